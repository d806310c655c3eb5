// SPDX-License-Identifier: BSD-3-Clause
// Compares the unit space of vtkImageData of random position, size and orientation with the points
// of the vtkImageData.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include <limits>

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

// Returns a random rotation matrix, with a reflection if \a isMirrored.
std::array<double, 9> MakeRotation(Random& random, bool isMirrored)
{
  const glm::dvec3 a = Normalize(glm::dvec3(random.Get(-1.0, 1.0), random.Get(-1.0, 1.0), 0.5), {});
  const glm::dvec3 b = Perpendicular(a, { 0.2, random.Get(-1.0, 1.0), 0.9 });
  const glm::dvec3 c = (isMirrored ? -1.0 : 1.0) * glm::cross(a, b);
  return { { a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2] } };
}

struct Scene
{
  vtkNew<vtkImageData> Image;
  vtkNew<vtkMatrix4x4> Matrix;
  interlume::UnitSpace Space;
  std::array<int, 6> Extent{};
  bool IsOfCells = false;

  // Returns the position of an image index in volume coordinates.
  glm::dvec3 GetVolumePoint(const glm::dvec3& index)
  {
    glm::dvec3 point;
    this->Image->TransformContinuousIndexToPhysicalPoint(
      glm::value_ptr(index), glm::value_ptr(point));
    return point;
  }
  glm::dvec3 GetWorldPoint(const glm::dvec3& index)
  {
    const glm::dvec3 point = this->GetVolumePoint(index);
    const double from[4] = { point[0], point[1], point[2], 1.0 };
    double to[4];
    this->Matrix->MultiplyPoint(from, to);
    return glm::dvec3(to[0], to[1], to[2]);
  }
};

bool IsFlat(const Scene& scene, std::size_t axis)
{
  return scene.Extent[2 * axis] == scene.Extent[2 * axis + 1];
}

// Checks the distance between two points, relative to a length.
void CheckNear(Check& check, const glm::dvec3& found, const glm::dvec3& expected, double tolerance,
  double length, const std::string& what)
{
  check.Near(interlume::Vectors::SafeLength(found - expected) / length, 0.0, tolerance, what, 1.0);
}

// Compares transformed points with the points of the vtkImageData. \a far is the distance of the
// volume from the origin, relative to its size.
void CheckPoints(Check& check, Scene& scene, Random& random, double far)
{
  const interlume::UnitSpace& space = scene.Space;
  // Allows for rounding errors of world coordinates.
  const double tolerance = 1e-12 + 1e-14 * far;
  const double size = interlume::Vectors::SafeLength(
    glm::dvec3(double(space.Size[0]), double(space.Size[1]), double(space.Size[2])));
  double maximum = 0.0;
  for (int corner = 0; corner < 40; ++corner)
  {
    glm::dvec3 index;
    glm::dvec3 texture;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      // First the corners of the box, then random positions.
      const double lower = scene.Extent[2 * axis] - (IsFlat(scene, axis) ? 0.5 : 0.0);
      const double upper = scene.Extent[2 * axis + 1] + (IsFlat(scene, axis) ? 0.5 : 0.0);
      const double t = corner < 8 ? corner >> axis & 1 : random.Get(0.0, 1.0);
      index[axis] = lower + t * (upper - lower);
      const bool hasEnds = scene.IsOfCells || IsFlat(scene, axis);
      const double points = scene.Extent[2 * axis + 1] - scene.Extent[2 * axis] + 1;
      texture[axis] = hasEnds ? t : (index[axis] - scene.Extent[2 * axis] + 0.5) / points;
      if (corner < 8)
      {
        check.Near(
          space.Box[axis][corner >> axis & 1], texture[axis], 1e-14, "the corners of the box", 1.0);
      }
    }
    const glm::dvec3 unit = TransformPoint(space.UnitFromTexture, texture);
    const glm::dvec3 world = scene.GetWorldPoint(index);
    CheckNear(check, TransformPoint(space.TextureFromUnit, unit), texture, 1e-11, 1.0,
      "mapped back to texture coordinates");
    CheckNear(check, space.ToUnit(glm::value_ptr(world)), unit, tolerance, 1.0, "unit from world");
    const glm::dvec3 volume = TransformPoint(space.VolumeFromTexture, texture);
    const glm::dvec3 expected = scene.GetVolumePoint(index);
    CheckNear(check, volume, expected, tolerance,
      size *
        interlume::Vectors::SafeLength(glm::dvec3(scene.Image->GetSpacing()[0],
          scene.Image->GetSpacing()[1], scene.Image->GetSpacing()[2])),
      "volume from texture");
    if (corner < 8)
    {
      maximum = std::max(maximum, interlume::Vectors::SafeLength(unit));
    }
  }
  check.Near(maximum, 1.0, 1e-12, "the farthest corner is on the unit sphere");
}

void MakeScene(Scene& scene, Random& random, int number, double far)
{
  const double size = std::pow(10.0, random.Get(-9.0, 9.0));
  double spacing[3];
  double origin[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scene.Extent[2 * axis] = static_cast<int>(random.Get(-50.0, 50.0));
    const int more = static_cast<int>(random.Get(number % 3 ? 1.0 : 0.0, number % 3 ? 60.0 : 3.0));
    scene.Extent[2 * axis + 1] = scene.Extent[2 * axis] + more;
    spacing[axis] = size * std::exp(random.Get(-2.0, 2.0));
    origin[axis] = random.Get(-1.0, 1.0) * far * size;
  }
  scene.Image->SetExtent(scene.Extent.data());
  scene.Image->SetSpacing(spacing);
  scene.Image->SetOrigin(origin);
  scene.Image->SetDirectionMatrix(MakeRotation(random, number % 2 == 0).data());
  // An affine matrix: a rotation with scale and shear.
  const std::array<double, 9> rotation = MakeRotation(random, number % 5 == 0);
  const double scale = std::pow(10.0, random.Get(-3.0, 3.0));
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const int element = 3 * row + column;
      const double shear = row < column ? random.Get(-1.0, 1.0) : 0.0;
      scene.Matrix->SetElement(
        row, column, scale * (rotation[static_cast<std::size_t>(element)] + shear));
    }
    scene.Matrix->SetElement(row, 3, random.Get(-1.0, 1.0) * far * size * scale);
  }
  scene.IsOfCells = number % 4 == 1;
}

void CheckRandom(Check& check)
{
  Random random(3);
  for (int number = 0; number < 1000; ++number)
  {
    check.SetContext("scene " + std::to_string(number));
    const double far = number % 7 == 0 ? 1e7 : 10.0;
    Scene scene;
    MakeScene(scene, random, number, far);
    check.That(!scene.Space.Set(scene.Image, scene.IsOfCells, scene.Matrix), "no error");
    CheckPoints(check, scene, random, far);
  }
}

void CheckSizes(Check& check)
{
  check.SetContext("");
  vtkNew<vtkImageData> image;
  vtkNew<vtkMatrix4x4> matrix;
  interlume::UnitSpace space;
  image->SetExtent(5, 8, 0, 0, -1, 0);
  check.That(!space.Set(image, false, matrix), "no error");
  check.That(space.Size == std::array<int, 3>{ { 4, 1, 2 } }, "texels of points");
  check.Near(
    space.Radius, 0.5 * std::sqrt(9.0 + 1.0 + 1.0), 1e-14, "radius with a thickness of one voxel");
  check.Near(space.Center[0], 6.5, 1e-14, "center");
  check.That(!space.Set(image, true, matrix), "no error");
  check.That(space.Size == std::array<int, 3>{ { 3, 1, 1 } }, "texels of cells");
  check.That(space.Box[0] == std::array<double, 2>{ { 0.0, 1.0 } }, "cells fill their texture");
}

void CheckErrors(Check& check)
{
  vtkNew<vtkImageData> image;
  vtkNew<vtkMatrix4x4> matrix;
  interlume::UnitSpace space;
  const auto hasError = [&] { return static_cast<bool>(space.Set(image, false, matrix)); };
  check.That(hasError(), "an image without samples");
  image->SetDimensions(3, 4, 5);
  check.That(!hasError(), "no error");
  for (const double value :
    { 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    matrix->SetElement(1, 1, value);
    check.That(hasError(), "scale " + std::to_string(value));
    matrix->Identity();
  }
  matrix->SetElement(1, 3, std::numeric_limits<double>::quiet_NaN());
  check.That(hasError(), "a NaN translation");
  matrix->Identity();
  matrix->SetElement(0, 1, 1.0);
  matrix->SetElement(1, 0, 1.0);
  check.That(hasError(), "two equal rows");
  matrix->Identity();
  matrix->SetElement(3, 0, 0.1);
  check.That(hasError(), "a perspective matrix");
  matrix->Identity();
  image->SetSpacing(1.0, 0.0, 1.0);
  check.That(hasError(), "zero spacing");
}
}

int TestUnitSpace(int, char*[])
{
  Check check;
  CheckRandom(check);
  CheckSizes(check);
  CheckErrors(check);
  return check.Result();
}
