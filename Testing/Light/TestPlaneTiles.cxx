// SPDX-License-Identifier: BSD-3-Clause
// Tiles of slices, compared with random positions in the slices: a position in a visible block has
// exactly one tile in the image, and empty blocks have no tile.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Light/ReferenceUnitSpace.h"

#include "Plan/PlaneTiles.h"
#include "Space/UnitVector.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

constexpr int Slabs = 40;
constexpr double Margin = 0.02;

glm::dvec3 GetDirection(Random& random)
{
  const std::array<double, 3> direction = random.GetDirection();
  return glm::make_vec3(direction.data());
}

struct Scene
{
  interlume::UnitSpace Space;
  std::array<std::vector<double>, 3> Borders;
  std::vector<unsigned char> Visible;
  interlume::SlicePlan::Sweep Sweep;
  glm::dmat4 ClipFromUnit{ 0.0 };
  std::array<int, 2> Size{ { 0, 0 } };
};

// Creates a view along \a axis that shows a square of edge length 2 * \a half around the center.
// The view is perspective if \a distance is above 0, otherwise parallel.
glm::dmat4 MakeView(Random& random, const glm::dvec3& axis, double half, double distance)
{
  const glm::dvec3 across = Perpendicular(axis, GetDirection(random));
  const glm::dvec3 up = glm::cross(axis, across);
  glm::dmat4 view(0.0);
  view = glm::row(view, 0, glm::dvec4(across / half, 0.1));
  view = glm::row(view, 1, glm::dvec4(up / half, -0.05));
  view =
    glm::row(view, 3, distance > 0.0 ? glm::dvec4(axis / distance, 1.0) : glm::dvec4(0, 0, 0, 1));
  return view;
}

// Creates a scene in which a \a fraction of the blocks is visible. The slices are oblique to the
// view.
Scene MakeScene(Random& random, double fraction, double half, double distance)
{
  Scene scene;
  const std::array<int, 3> size{ { 41, 33, 25 } };
  scene.Space = MakeUnitSpace(size, { { 1.0, 1.3, random.Get(0.5, 2.0) } }, random.Get(-0.4, 0.4));
  std::size_t blocks = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int cell = 0; cell < size[axis] - 1; cell += 5)
    {
      scene.Borders[axis].push_back((cell + 0.5) / size[axis]);
    }
    scene.Borders[axis].push_back((size[axis] - 0.5) / size[axis]);
    blocks *= scene.Borders[axis].size() - 1;
  }
  for (std::size_t i = 0; i < blocks; ++i)
  {
    scene.Visible.push_back(random.Get(0.0, 1.0) < fraction ? 1 : 0);
  }
  const glm::dvec3 axis = GetDirection(random);
  scene.Sweep.Normal = Normalize(axis + 0.6 * GetDirection(random), axis);
  scene.Sweep.First = -1.0;
  scene.Sweep.Slabs = Slabs;
  scene.Sweep.Spacing = 2.0 / Slabs;
  scene.Size = { { 150, random.Get(0.0, 1.0) < 0.5 ? 301 : 96 } };
  scene.ClipFromUnit = MakeView(random, axis, half, distance);
  return scene;
}

bool Build(const Scene& scene, interlume::PlaneTiles& tiles)
{
  return tiles.Build(scene.Sweep, scene.ClipFromUnit, scene.Size, { scene.Borders, scene.Visible },
    scene.Space, scene.Space.Box, Margin);
}

glm::dvec2 GetPixel(const Scene& scene, const glm::dvec3& position)
{
  const glm::dvec4 clip = scene.ClipFromUnit * glm::dvec4(position, 1.0);
  return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(scene.Size[0], scene.Size[1]);
}

// Returns true if a position is in a visible block. Outer blocks are enlarged by the margin.
bool IsVisible(const Scene& scene, const glm::dvec3& position)
{
  const glm::dvec3 texture = TransformPoint(scene.Space.TextureFromUnit, position);
  const std::array<double, 3> margins = scene.Space.GetMargins(Margin);
  std::size_t block = 0;
  for (std::size_t axis = 3; axis-- > 0;)
  {
    const double at = texture[static_cast<int>(axis)];
    const std::array<double, 2>& box = scene.Space.Box[axis];
    if (!(at > box[0] - margins[axis] && at < box[1] + margins[axis]))
    {
      return false;
    }
    const std::vector<double>& borders = scene.Borders[axis];
    const auto above = std::upper_bound(borders.begin() + 1, borders.end() - 1, at);
    block = block * (borders.size() - 1) + static_cast<std::size_t>(above - borders.begin()) - 1;
  }
  return scene.Visible[block] != 0;
}

glm::dvec3 GetVertex(const interlume::PlaneTiles& tiles, std::size_t vertex)
{
  const float* position = tiles.GetVertices().data() + 3 * vertex;
  return { position[0], position[1], position[2] };
}

// Returns the number of rectangles of a slab that contain a pixel. Each rectangle has six vertices;
// the first and the third are opposite corners.
int CountCover(
  const Scene& scene, const interlume::PlaneTiles& tiles, std::size_t slab, const glm::dvec2& pixel)
{
  int cover = 0;
  for (std::size_t v = tiles.GetStarts()[slab]; v < tiles.GetStarts()[slab + 1]; v += 6)
  {
    const glm::dvec2 lower = GetPixel(scene, GetVertex(tiles, v));
    const glm::dvec2 upper = GetPixel(scene, GetVertex(tiles, v + 2));
    cover += pixel.x > lower.x && pixel.x < upper.x && pixel.y > lower.y && pixel.y < upper.y;
  }
  return cover;
}

double GetArea(const Scene& scene, const interlume::PlaneTiles& tiles)
{
  double area = 0.0;
  for (std::size_t v = 0; v < tiles.GetVertices().size() / 3; v += 6)
  {
    const glm::dvec2 edges =
      GetPixel(scene, GetVertex(tiles, v + 2)) - GetPixel(scene, GetVertex(tiles, v));
    area += edges.x * edges.y;
  }
  return area;
}

void CheckCorners(Check& check, const Scene& scene, const interlume::PlaneTiles& tiles)
{
  double height = 0.0;
  double edge = 0.0;
  for (std::size_t slab = 0; slab < Slabs; ++slab)
  {
    const double plane =
      scene.Sweep.First + (static_cast<double>(slab) + 0.5) * scene.Sweep.Spacing;
    for (std::size_t v = tiles.GetStarts()[slab]; v < tiles.GetStarts()[slab + 1]; ++v)
    {
      const glm::dvec3 position = GetVertex(tiles, v);
      height = std::max(height, std::abs(glm::dot(position, scene.Sweep.Normal) - plane));
      const glm::dvec2 tile = GetPixel(scene, position) / double(interlume::PlaneTiles::TileSize);
      edge = std::max(
        { edge, std::abs(tile.x - std::round(tile.x)), std::abs(tile.y - std::round(tile.y)) });
    }
  }
  check.That(height < 1e-6, "vertices are in the planes of the slices: " + std::to_string(height));
  check.That(edge < 1e-4, "vertices are at tile corners: " + std::to_string(edge));
}

void CheckPositions(Check& check, const Scene& scene, Random& random, int& seen)
{
  interlume::PlaneTiles tiles;
  if (!check.That(Build(scene, tiles), "there are tiles"))
  {
    return;
  }
  check.Equal(tiles.GetNumberOfSlabs(), Slabs, "slabs");
  CheckCorners(check, scene, tiles);
  for (int number = 0; number < 2000; ++number)
  {
    const auto slab = static_cast<std::size_t>(random.Get(0.0, Slabs - 1e-3));
    const double plane =
      scene.Sweep.First + (static_cast<double>(slab) + 0.5) * scene.Sweep.Spacing;
    const glm::dvec3 offset = random.Get(0.0, 1.0) * GetDirection(random);
    const glm::dvec3 position =
      offset + (plane - glm::dot(offset, scene.Sweep.Normal)) * scene.Sweep.Normal;
    const glm::dvec2 pixel = GetPixel(scene, position);
    const int cover = CountCover(scene, tiles, slab, pixel);
    const bool isInside =
      pixel.x > 0.0 && pixel.y > 0.0 && pixel.x < scene.Size[0] && pixel.y < scene.Size[1];
    const bool isSeen = isInside && IsVisible(scene, position);
    seen += isSeen ? 1 : 0;
    check.That(cover <= 1, "no pixel is in two tiles");
    check.That(!isSeen || cover == 1, "a position in a visible block has a tile");
  }
}

// Empty blocks have no tiles, and the tiles of a single block extend only slightly past it.
void CheckAreas(Check& check)
{
  check.SetContext("areas");
  Random random(3);
  interlume::PlaneTiles tiles;
  const Scene none = MakeScene(random, 0.0, 1.1, 0.0);
  check.That(Build(none, tiles) && tiles.GetVertices().empty(), "no block is visible");
  Scene scene = MakeScene(random, 1.1, 1.1, 3.0);
  Build(scene, tiles);
  const double full = GetArea(scene, tiles);
  std::fill(scene.Visible.begin(), scene.Visible.end(), 0);
  scene.Visible[scene.Visible.size() / 2] = 1;
  Build(scene, tiles);
  const double one = GetArea(scene, tiles) * static_cast<double>(scene.Visible.size());
  check.That(one > full && one < 2.5 * full, "one block: " + std::to_string(one / full));
}

// Slices seen edge-on, and volumes around the camera, have no tiles. They are drawn as polygons.
void CheckUnsuitable(Check& check)
{
  check.SetContext("unsuitable");
  Random random(5);
  interlume::PlaneTiles tiles;
  Scene scene = MakeScene(random, 1.1, 1.1, 0.0);
  const glm::dvec3 axis = Perpendicular(scene.Sweep.Normal, GetDirection(random));
  scene.ClipFromUnit = MakeView(random, axis, 1.1, 0.0);
  check.That(!Build(scene, tiles) && tiles.GetVertices().empty(), "edge-on");
  check.Equal(tiles.GetNumberOfSlabs(), Slabs, "edge-on: slabs");
  scene.ClipFromUnit = MakeView(random, scene.Sweep.Normal, 1.1, 0.3);
  check.That(!Build(scene, tiles) && tiles.GetVertices().empty(), "around the camera");
}

void CheckThreads(Check& check)
{
  Random random(4);
  const Scene scene = MakeScene(random, 0.3, 1.1, 2.5);
  std::vector<interlume::PlaneTiles> results;
  for (const char* backend : GetBackends())
  {
    for (const int threads : { 1, 4 })
    {
      vtkSMPTools::SetBackend(backend);
      SetThreads(threads);
      results.emplace_back();
      Build(scene, results.back());
      check.That(!results.back().GetVertices().empty() &&
          results.back().GetVertices() == results.front().GetVertices() &&
          results.back().GetStarts() == results.front().GetStarts(),
        std::to_string(threads) + " threads of " + backend);
    }
  }
}

}

int TestPlaneTiles(int, char*[])
{
  Check check;
  Random random(8);
  int seen = 0;
  for (int i = 0; i < 60; ++i)
  {
    check.SetContext("scene " + std::to_string(i));
    // Some views show only a part of the volume.
    CheckPositions(check,
      MakeScene(random, i % 3 ? random.Get(0.0, 0.3) : 0.9, i % 4 ? 1.1 : 0.3,
        i % 2 ? random.Get(2.5, 9.0) : 0.0),
      random, seen);
  }
  check.SetContext("all scenes");
  check.That(seen > 5000, "positions are visible: " + std::to_string(seen));
  CheckAreas(check);
  CheckUnsuitable(check);
  CheckThreads(check);
  return check.Result();
}
