// SPDX-License-Identifier: BSD-3-Clause
// Polygons of slices, compared with planes that are clipped to each block separately: areas,
// coverage of points, planes on block faces, and threads.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Light/ReferenceUnitSpace.h"

#include "Plan/SlicePolygons.h"
#include "Space/UnitVector.h"

#include <utility>

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

// Converts an array to a GLM vector.
glm::dvec3 ToVector(const std::array<double, 3>& a)
{
  return glm::make_vec3(a.data());
}

using Box = std::array<std::array<double, 2>, 3>;
using Polygon = std::vector<glm::dvec3>;

struct Scene
{
  interlume::UnitSpace Space;
  std::array<std::vector<double>, 3> Borders;
  std::vector<unsigned char> Visible;
  Box Crop{};
  double Margin = 0.0;
  interlume::SlicePlan::Sweep Sweep;
};

// Returns block borders in texture coordinates as in interlume::VolumeBlocks, from the center of
// the first texel to the center of the last.
std::vector<double> MakeBorders(int size, int block)
{
  std::vector<double> borders;
  for (int sample = 0; sample < size - 1; sample += block)
  {
    borders.push_back((sample + 0.5) / size);
  }
  borders.push_back((size - 0.5) / size);
  return borders;
}

void SetSlabs(Scene& scene, const glm::dvec3& normal, int slabs)
{
  double lower = VTK_DOUBLE_MAX;
  double upper = -VTK_DOUBLE_MAX;
  for (const double x : scene.Crop[0])
  {
    for (const double y : scene.Crop[1])
    {
      for (const double z : scene.Crop[2])
      {
        const double position =
          glm::dot(normal, TransformPoint(scene.Space.UnitFromTexture, glm::dvec3(x, y, z)));
        lower = std::min(lower, position);
        upper = std::max(upper, position);
      }
    }
  }
  scene.Sweep.Normal = normal;
  scene.Sweep.Slabs = slabs;
  scene.Sweep.First = lower;
  scene.Sweep.Spacing = (upper - lower) / slabs;
}

// Returns the box of each visible block.
std::vector<Box> GetBlocks(const Scene& scene)
{
  std::vector<Box> blocks;
  std::size_t sizes[3];
  double margins[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    sizes[axis] = scene.Borders[axis].size() - 1;
    // The margin is measured in unit space, perpendicular to the face.
    margins[axis] = scene.Margin * glm::length(GetRow(scene.Space.TextureFromUnit, axis));
  }
  for (std::size_t block = 0; block < scene.Visible.size(); ++block)
  {
    const std::size_t position[3] = { block % sizes[0], block / sizes[0] % sizes[1],
      block / sizes[0] / sizes[1] };
    Box box;
    bool isEmpty = scene.Visible[block] == 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::array<double, 2>& crop = scene.Crop[axis];
      const double start = position[axis] == 0 ? -1.0 : scene.Borders[axis][position[axis]];
      const double end =
        position[axis] + 1 == sizes[axis] ? 2.0 : scene.Borders[axis][position[axis] + 1];
      isEmpty = isEmpty || start >= crop[1] || end <= crop[0];
      box[axis][0] = start > crop[0] ? start : crop[0] - margins[axis];
      box[axis][1] = end < crop[1] ? end : crop[1] + margins[axis];
    }
    if (!isEmpty)
    {
      blocks.push_back(box);
    }
  }
  return blocks;
}

// Returns two perpendicular directions in the plane with the given normal.
std::array<glm::dvec3, 2> GetAxes(const glm::dvec3& normal)
{
  const glm::dvec3 first = Perpendicular(normal, { 0.3, 0.8, 0.5 });
  return { { first, glm::cross(normal, first) } };
}

double GetArea(const Polygon& polygon)
{
  glm::dvec3 sum{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const glm::dvec3 across = glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    sum = sum + 0.5 * across;
  }
  return interlume::Vectors::SafeLength(sum);
}

// Returns the intersection of a slice plane with a block: a large square clipped by the block's
// faces.
Polygon ClipPlane(const Scene& scene, double position, const Box& block)
{
  const glm::dvec3& normal = scene.Sweep.Normal;
  const std::array<glm::dvec3, 2> axes = GetAxes(normal);
  Polygon polygon;
  for (const std::array<double, 2>& corner : { std::array<double, 2>{ { -9.0, -9.0 } },
         { { 9.0, -9.0 } }, { { 9.0, 9.0 } }, { { -9.0, 9.0 } } })
  {
    polygon.push_back(position * normal + corner[0] * axes[0] + corner[1] * axes[1]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const std::size_t side : { std::size_t(0), std::size_t(1) })
    {
      const auto inside = [&](const glm::dvec3& point)
      {
        const double depth =
          TransformPoint(scene.Space.TextureFromUnit, point)[axis] - block[axis][side];
        return side == 0 ? depth : -depth;
      };
      Polygon clipped;
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const glm::dvec3& from = polygon[i];
        const glm::dvec3& to = polygon[(i + 1) % polygon.size()];
        const double start = inside(from);
        const double end = inside(to);
        if (start >= 0.0)
        {
          clipped.push_back(from);
        }
        if ((start >= 0.0) != (end >= 0.0))
        {
          const double t = start / (start - end);
          clipped.push_back((1.0 - t) * from + t * to);
        }
      }
      polygon = clipped;
    }
  }
  return polygon;
}

using Point = std::array<double, 2>;
using Triangle = std::array<Point, 3>;

// Returns the triangles of a slab in plane coordinates. Equal vertices remain equal.
std::vector<Triangle> GetTriangles(
  const Scene& scene, const interlume::SlicePolygons& polygons, int slab)
{
  const std::array<glm::dvec3, 2> axes = GetAxes(scene.Sweep.Normal);
  const std::vector<float>& vertices = polygons.GetVertices();
  std::vector<Triangle> triangles;
  const auto index = static_cast<std::size_t>(slab);
  for (std::size_t v = polygons.GetStarts()[index]; v < polygons.GetStarts()[index + 1]; v += 3)
  {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const float* p = vertices.data() + 3 * (v + i);
      const glm::dvec3 point{ p[0], p[1], p[2] };
      triangle[i] = { { glm::dot(point, axes[0]), glm::dot(point, axes[1]) } };
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

// Returns true if a point is to the left of an edge. The result is the same for both triangles that
// share the edge.
bool IsLeft(const Point& a, const Point& b, const Point& p)
{
  if (b < a)
  {
    return !IsLeft(b, a, p);
  }
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= 0.0;
}

int CountCover(const std::vector<Triangle>& triangles, const Point& p)
{
  return static_cast<int>(std::count_if(triangles.begin(), triangles.end(),
    [&](const Triangle& t)
    {
      const bool first = IsLeft(t[0], t[1], p);
      return IsLeft(t[1], t[2], p) == first && IsLeft(t[2], t[0], p) == first;
    }));
}

// Returns the distance of a point inside a block to its boundary, in texture coordinates.
double GetDepth(const Box& block, const glm::dvec3& texture)
{
  double depth = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    depth = std::min({ depth, texture[axis] - block[axis][0], block[axis][1] - texture[axis] });
  }
  return depth;
}

// Checks the total area of each slab's triangles, and points in its plane: points in visible
// blocks, including those on common faces, are covered exactly once, and points outside are not
// covered.
void CheckScene(Check& check, const Scene& scene, Random& random, bool hasTies)
{
  interlume::SlicePolygons polygons;
  polygons.Build(
    scene.Sweep, { scene.Borders, scene.Visible }, scene.Space, scene.Crop, scene.Margin);
  check.Equal(polygons.GetNumberOfSlabs(), scene.Sweep.Slabs, "slabs");
  check.That(polygons.GetVertices().size() == 3 * polygons.GetStarts().back(), "vertices");
  const std::vector<Box> blocks = GetBlocks(scene);
  const std::array<glm::dvec3, 2> axes = GetAxes(scene.Sweep.Normal);
  for (int slab = 0; slab < scene.Sweep.Slabs; ++slab)
  {
    const double position = scene.Sweep.First + (slab + 0.5) * scene.Sweep.Spacing;
    // If slice planes coincide with block faces, the expected area is that of a plane slightly
    // above.
    const double sampledPosition = position + (hasTies ? 1e-9 : 0.0);
    double expected = 0.0;
    for (const Box& block : blocks)
    {
      expected += GetArea(ClipPlane(scene, sampledPosition, block));
    }
    double found = 0.0;
    const std::vector<Triangle> triangles = GetTriangles(scene, polygons, slab);
    for (const Triangle& t : triangles)
    {
      const double area = 0.5 *
        std::abs(
          (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]));
      found += area;
      check.That(
        t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "the vertices of a triangle are distinct");
    }
    check.Near(found, expected, 2e-6, "area of slab " + std::to_string(slab), 1.0);
    check.That(polygons.IsEmpty(slab) == triangles.empty(), "empty slabs");

    const auto checkPoint = [&](const Point& p)
    {
      const glm::dvec3 unit =
        sampledPosition * scene.Sweep.Normal + p[0] * axes[0] + p[1] * axes[1];
      const glm::dvec3 texture = TransformPoint(scene.Space.TextureFromUnit, unit);
      double depth = -1.0;
      for (const Box& block : blocks)
      {
        // Boxes are enlarged slightly, so that points on common faces are inside.
        Box larger = block;
        for (std::array<double, 2>& range : larger)
        {
          range = { { range[0] - 1e-12, range[1] + 1e-12 } };
        }
        depth = std::max(depth, GetDepth(larger, texture));
      }
      // Points close to the boundary of the visible blocks may be covered or not.
      bool isNear = false;
      for (int corner = 0; corner < 8; ++corner)
      {
        glm::dvec3 moved = texture;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          moved[axis] += corner >> axis & 1 ? 1e-6 : -1e-6;
        }
        const bool isInside = std::any_of(blocks.begin(), blocks.end(),
          [&](const Box& block) { return GetDepth(block, moved) > 0.0; });
        isNear = isNear || isInside != (depth > 0.0);
      }
      if (!isNear)
      {
        check.Equal(CountCover(triangles, p), depth > 0.0 ? 1 : 0,
          "coverage of a point of slab " + std::to_string(slab));
      }
    };
    for (int i = 0; i < 20; ++i)
    {
      checkPoint({ { random.Get(-1.2, 1.2), random.Get(-1.2, 1.2) } });
    }
    for (std::size_t i = 0; i < triangles.size(); i += 7)
    {
      // Test points on edges. Most edges are shared by two triangles.
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const Point& a = triangles[i][edge];
        const Point& b = triangles[i][(edge + 1) % 3];
        const double t = random.Get(0.1, 0.9);
        checkPoint({ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) } });
      }
    }
  }
}

void CheckRandom(Check& check)
{
  Random random(11);
  for (int number = 0; number < 150; ++number)
  {
    check.SetContext("scene " + std::to_string(number));
    Scene scene;
    std::array<int, 3> size;
    std::size_t blocks = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      size[axis] = number % 10 == 0 && axis == 2 ? 2 : static_cast<int>(random.Get(2.0, 40.0));
      const auto block = static_cast<int>(random.Get(2.0, 16.0));
      // The number of cells is one less than the number of points.
      scene.Borders[axis] =
        size[axis] == 2 ? std::vector<double>{ 0.5, 0.5 } : MakeBorders(size[axis] - 1, block);
      blocks *= scene.Borders[axis].size() - 1;
    }
    const double shear = number % 4 == 0 ? random.Get(-1.0, 1.0) : 0.0;
    scene.Space = MakeUnitSpace(
      size, { { random.Get(0.5, 2.0), random.Get(0.5, 2.0), random.Get(0.5, 2.0) } }, shear);
    const double fraction = number % 5 == 0 ? 1.1 : random.Get(0.1, 0.9);
    for (std::size_t block = 0; block < blocks; ++block)
    {
      scene.Visible.push_back(random.Get(0.0, 1.0) < fraction ? 1 : 0);
    }
    scene.Crop = scene.Space.Box;
    for (std::size_t axis = 0; axis < 3 && number % 3 == 0; ++axis)
    {
      scene.Crop[axis] = { { random.Get(0.0, 0.4), random.Get(0.6, 1.0) } };
    }
    scene.Margin = number % 2 ? random.Get(0.0, 0.1) : 0.0;
    SetSlabs(scene, ToVector(random.GetDirection()), 12);
    CheckScene(check, scene, random, false);
  }
}

// Returns a unit space in which all block borders have exact coordinates.
interlume::UnitSpace MakeExactSpace()
{
  interlume::UnitSpace space;
  space.Size.fill(8);
  space.UnitFromTexture = glm::dmat4(1.0);
  space.UnitFromTexture[3] = glm::dvec4(-0.5, -0.5, -0.5, 1.0);
  space.TextureFromUnit = glm::dmat4(1.0);
  space.TextureFromUnit[3] = glm::dvec4(0.5, 0.5, 0.5, 1.0);
  space.Box.fill({ { 0.0, 1.0 } });
  return space;
}

// Tests planes on the faces of blocks and through their vertices.
void CheckTies(Check& check)
{
  Random random(11);
  const double third = std::sqrt(1.0 / 3.0);
  const double half = std::sqrt(0.5);
  const std::vector<glm::dvec3> normals = { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0),
    glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(third, third, third), glm::dvec3(-third, third, -third),
    glm::dvec3(half, half, 0.0), glm::dvec3(0.0, half, -half) };
  for (const glm::dvec3& normal : normals)
  {
    for (const bool isFull : { false, true })
    {
      check.SetContext("planes on faces and through vertices");
      Scene scene;
      scene.Space = MakeExactSpace();
      scene.Borders.fill({ 0.0, 0.25, 0.5, 0.75, 1.0 });
      for (int block = 0; block < 64; ++block)
      {
        scene.Visible.push_back(isFull || random.Get(0.0, 1.0) < 0.5 ? 1 : 0);
      }
      scene.Crop = scene.Space.Box;
      // Slabs are shifted by half their thickness, so that slice planes coincide with block
      // borders, including both ends of the volume.
      SetSlabs(scene, normal, 4);
      scene.Sweep.First -= 0.5 * scene.Sweep.Spacing;
      scene.Sweep.Slabs = 5;
      CheckScene(check, scene, random, true);
    }
  }
  // Outer faces: the lower face is drawn, the upper face is not.
  Scene scene;
  scene.Space = MakeExactSpace();
  scene.Borders.fill({ 0.0, 0.5, 1.0 });
  scene.Visible.assign(8, 1);
  scene.Crop = scene.Space.Box;
  SetSlabs(scene, glm::dvec3(0.0, 0.0, 1.0), 2);
  scene.Sweep.First -= 0.5 * scene.Sweep.Spacing;
  scene.Sweep.Slabs = 3;
  interlume::SlicePolygons polygons;
  polygons.Build(scene.Sweep, { scene.Borders, scene.Visible }, scene.Space, scene.Crop, 0.0);
  check.That(!polygons.IsEmpty(0) && !polygons.IsEmpty(1) && polygons.IsEmpty(2),
    "a block owns its lower face");
  // A slab in which all blocks are visible has one polygon of two triangles.
  check.Equal(static_cast<long long>(polygons.GetStarts()[2] - polygons.GetStarts()[1]), 6,
    "vertices of a slab across all blocks");
}

void CheckThreads(Check& check)
{
  check.SetContext("");
  Random random(11);
  Scene scene;
  scene.Space = MakeUnitSpace({ { 129, 129, 129 } }, { { 1.0, 1.0, 1.0 } }, 0.0);
  scene.Borders.fill(MakeBorders(128, 16));
  for (int block = 0; block < 512; ++block)
  {
    scene.Visible.push_back(random.Get(0.0, 1.0) < 0.5 ? 1 : 0);
  }
  scene.Crop = scene.Space.Box;
  SetSlabs(scene, ToVector(random.GetDirection()), 300);
  interlume::SlicePolygons polygons;
  const auto build = [&]()
  {
    polygons.Build(
      scene.Sweep, { scene.Borders, scene.Visible }, scene.Space, scene.Crop, scene.Margin);
  };
  const auto get = [&]()
  {
    build();
    check.That(!polygons.GetVertices().empty(), "there are triangles");
    return std::make_pair(polygons.GetVertices(), polygons.GetStarts());
  };
  CheckSame("polygons", get, check);
  // Results of earlier calls are cleared.
  scene.Visible.assign(512, 0);
  build();
  check.That(
    polygons.GetVertices().empty() && polygons.GetNumberOfSlabs() == 300 && polygons.IsEmpty(0),
    "there are no triangles without visible blocks");
}
}

int TestSlicePolygons(int, char*[])
{
  Check check;
  CheckRandom(check);
  CheckTies(check);
  CheckThreads(check);
  return check.Result();
}
