// SPDX-License-Identifier: BSD-3-Clause
// Tiles of the light buffer of a light near the volume, compared with random rays: a ray that
// intersects a visible block in a slab has exactly one tile, and rays without visible blocks have
// no tile.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Light/ReferenceUnitSpace.h"

#include "Plan/LightTiles.h"
#include "vtkSMPTools.h"
#include "Space/UnitVector.h"

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

glm::dvec3 ToVector(const std::array<double, 3>& a)
{
  return glm::make_vec3(a.data());
}

struct Scene
{
  interlume::UnitSpace Space;
  std::array<std::vector<double>, 3> Borders;
  std::vector<unsigned char> Visible;
  interlume::SlicePlan::Sweep Sweep;
  interlume::SlicePlan::ShadowedLight Light;
  glm::dvec3 Position{};
};

// Creates a scene in which a \a fraction of the blocks is visible. The light is at \a distance from
// the center.
Scene MakeScene(Random& random, double fraction, double distance)
{
  Scene scene;
  const std::array<int, 3> size{ { 61, 49, 33 } };
  scene.Space = MakeUnitSpace(size, { { 1.0, 1.3, random.Get(0.5, 2.0) } }, random.Get(-0.4, 0.4));
  std::size_t blocks = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int cell = 0; cell < size[axis] - 1; cell += 9)
    {
      scene.Borders[axis].push_back((cell + 0.5) / (size[axis] - 1));
    }
    scene.Borders[axis].push_back((size[axis] - 1.5) / (size[axis] - 1));
    blocks *= scene.Borders[axis].size() - 1;
  }
  for (std::size_t i = 0; i < blocks; ++i)
  {
    scene.Visible.push_back(random.Get(0.0, 1.0) < fraction ? 1 : 0);
  }
  scene.Position = distance * ToVector(random.GetDirection());
  scene.Sweep.Normal = ToVector(random.GetDirection());
  // The sweep ends at distance 1 along its normal, since the volume is inside the unit sphere.
  scene.Sweep.First = glm::dot(scene.Position, scene.Sweep.Normal);
  scene.Sweep.Slabs = 40;
  scene.Sweep.Spacing = std::max(1.0 - scene.Sweep.First, 0.0) / scene.Sweep.Slabs;
  const glm::dvec3 first = Perpendicular(scene.Sweep.Normal, ToVector(random.GetDirection()));
  const std::array<glm::dvec3, 3> axes{ { first, glm::cross(scene.Sweep.Normal, first),
    scene.Sweep.Normal } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::copy_n(glm::value_ptr(axes[i]), 3, scene.Light.Frame.begin() + 3 * i);
  }
  scene.Light.IsWide = true;
  scene.Light.BufferSize = random.Get(0.0, 1.0) < 0.3 ? 100 : 160;
  return scene;
}

bool IsVisible(const Scene& scene, const glm::dvec3& point)
{
  const glm::dvec3 texture = TransformPoint(scene.Space.TextureFromUnit, point);
  std::size_t block = 0;
  for (std::size_t axis = 3; axis-- > 0;)
  {
    if (!(texture[axis] > scene.Space.Box[axis][0] && texture[axis] < scene.Space.Box[axis][1]))
    {
      return false;
    }
    const std::vector<double>& borders = scene.Borders[axis];
    std::size_t position = 0;
    while (position + 2 < borders.size() && borders[position + 1] <= texture[axis])
    {
      ++position;
    }
    block = block * (borders.size() - 1) + position;
  }
  return scene.Visible[block] != 0;
}

// Returns the number of tiles of a slab that contain a position in the buffer.
int CountCover(
  const interlume::LightTiles& tiles, std::size_t slab, const std::array<double, 2>& position)
{
  int cover = 0;
  // A rectangle has six vertices in two triangles. The first and the third vertex are opposite.
  for (std::size_t v = tiles.GetStarts()[slab]; v < tiles.GetStarts()[slab + 1]; v += 6)
  {
    const float* lower = tiles.GetVertices().data() + 3 * v;
    const float* upper = lower + 6;
    cover += position[0] > lower[0] && position[0] < upper[0] && position[1] > lower[1] &&
        position[1] < upper[1]
      ? 1
      : 0;
  }
  return cover;
}

double GetArea(const interlume::LightTiles& tiles)
{
  double area = 0.0;
  for (std::size_t v = 0; v < tiles.GetVertices().size() / 3; v += 6)
  {
    const float* lower = tiles.GetVertices().data() + 3 * v;
    area += (lower[6] - lower[0]) * (lower[7] - lower[1]);
  }
  return area / (static_cast<double>(tiles.GetStarts().size()) - 1.0);
}

interlume::LightTiles Find(const Scene& scene)
{
  interlume::LightTiles tiles;
  tiles.Build(scene.Sweep, scene.Light, scene.Position, { scene.Borders, scene.Visible },
    scene.Space, scene.Space.Box);
  return tiles;
}

void CheckRays(Check& check, const Scene& scene, Random& random)
{
  const interlume::LightTiles tiles = Find(scene);
  check.Equal(static_cast<long long>(tiles.GetStarts().size()), scene.Sweep.Slabs + 1, "slabs");
  for (int number = 0; number < 1500; ++number)
  {
    // Many rays are almost parallel to the slices.
    glm::dvec3 across = ToVector(random.GetDirection());
    across = across - glm::dot(across, scene.Sweep.Normal) * scene.Sweep.Normal;
    const double slope = number % 2 ? random.Get(0.0, 2.0) : std::exp(random.Get(-9.0, 0.0));
    const glm::dvec3 ray = across + slope * scene.Sweep.Normal;
    const std::array<double, 2> position =
      interlume::SlicePlan::GetBufferPosition(scene.Light.Frame, ray);
    const auto slab = static_cast<std::size_t>(random.Get(0.0, scene.Sweep.Slabs - 1e-3));
    const double lower = scene.Sweep.First + static_cast<double>(slab) * scene.Sweep.Spacing;
    const double apex = glm::dot(scene.Position, scene.Sweep.Normal);
    bool isVisible = false;
    for (int i = 0; i < 100 && !isVisible; ++i)
    {
      const double height = lower + random.Get(0.0, 1.0) * scene.Sweep.Spacing - apex;
      const double length = height / glm::dot(ray, scene.Sweep.Normal);
      isVisible = length > 0.0 && length * interlume::Vectors::SafeLength(ray) < 4.0 &&
        IsVisible(scene, scene.Position + length * ray);
    }
    const int cover = CountCover(tiles, slab, position);
    check.That(cover <= 1, "no texel is in two tiles");
    check.That(!isVisible || cover == 1, "a ray through a visible block has a tile");
  }
}

// Positions outside the volume and empty blocks have no tiles.
void CheckAreas(Check& check)
{
  Random random(3);
  check.SetContext("areas");
  check.Near(GetArea(Find(MakeScene(random, 0.0, 0.1))), 0.0, 0.0, "no block is visible");
  const double full = GetArea(Find(MakeScene(random, 1.1, 0.1)));
  const double sparse = GetArea(Find(MakeScene(random, 0.03, 0.1)));
  check.That(full > 0.3 && full < 0.85, "all blocks are visible: " + std::to_string(full));
  check.That(sparse < 0.4 * full, "3 % of the blocks are visible: " + std::to_string(sparse));
}

void CheckThreads(Check& check)
{
  Random random(4);
  const Scene scene = MakeScene(random, 0.3, 0.2);
  std::vector<interlume::LightTiles> results;
  for (const char* backend : GetBackends())
  {
    for (const int threads : { 1, 4 })
    {
      vtkSMPTools::SetBackend(backend);
      SetThreads(threads);
      results.push_back(Find(scene));
      check.That(!results.back().GetVertices().empty() &&
          results.back().GetVertices() == results.front().GetVertices() &&
          results.back().GetStarts() == results.front().GetStarts(),
        std::to_string(threads) + " threads of " + backend);
    }
  }
}

}

int TestLightTiles(int, char*[])
{
  Check check;
  Random random(8);
  for (int i = 0; i < 60; ++i)
  {
    check.SetContext("scene " + std::to_string(i));
    CheckRays(check,
      MakeScene(random, i % 3 ? random.Get(0.0, 0.3) : 0.9, random.Get(0.0, i % 2 ? 0.4 : 1.2)),
      random);
  }
  CheckAreas(check);
  CheckThreads(check);
  return check.Result();
}
