// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceRay.h"

#include "Support/Arrays/ReferenceIndices.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <cmath>

namespace reference
{

PixelRays::PixelRays(vtkCamera* camera, const std::array<int, 2>& size)
  : Size(size)
  , Near(camera->GetClippingRange()[0])
  , Far(camera->GetClippingRange()[1])
{
  vtkMatrix4x4* view = camera->GetViewTransformMatrix();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(static_cast<double>(size[0]) / size[1], -1, 1);
  for (int row = 0; row < 3; ++row)
  {
    this->Position[row] = camera->GetPosition()[row];
    for (int column = 0; column < 3; ++column)
    {
      this->Axes[row][column] = view->GetElement(row, column);
    }
  }
  for (const auto& [row, column] : AllIndices(4, 4))
  {
    this->Matrix[row][column] = projection->GetElement(row, column);
  }
}

Vector PixelRays::GetPointAtDepth(Real x, Real y, Real depth) const
{
  // For a given z, rows 0, 1 and 3 of the projection matrix give linear equations for x and y.
  const auto& m = this->Matrix;
  const Real z = -depth;
  const Real rightSide[2] = { x * (m[3][2] * z + m[3][3]) - m[0][2] * z - m[0][3],
    y * (m[3][2] * z + m[3][3]) - m[1][2] * z - m[1][3] };
  const Real determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return { (rightSide[0] * m[1][1] - rightSide[1] * m[0][1]) / determinant,
    (rightSide[1] * m[0][0] - rightSide[0] * m[1][0]) / determinant, z };
}

Ray PixelRays::Get(int i, int j) const
{
  // Rays are slightly offset, since rays through exact pixel centers could lie in cell faces if the
  // coordinates of the mesh are round numbers.
  constexpr Real pixelOffset[2] = { 1.4e-9L, 0.6e-9L };
  const Real x = (2 * i + 1 + pixelOffset[0]) / static_cast<Real>(this->Size[0]) - 1;
  const Real y = (2 * j + 1 + pixelOffset[1]) / static_cast<Real>(this->Size[1]) - 1;
  const Vector begin = this->GetPointAtDepth(x, y, 0);
  const Vector end = this->GetPointAtDepth(x, y, 1);
  Ray ray = { this->Position, { 0, 0, 0 }, 0 };
  for (const auto& [axis, k] : AllIndices(3, 3))
  {
    ray.Origin[k] += begin[axis] * this->Axes[axis][k];
    ray.Direction[k] += (end[axis] - begin[axis]) * this->Axes[axis][k];
  }
  ray.DistancePerDepth = std::sqrt(Dot(ray.Direction, ray.Direction));
  for (Real& component : ray.Direction)
  {
    component /= ray.DistancePerDepth;
  }
  return ray;
}

Vector PixelRays::ToEye(const Vector& point) const
{
  const Vector offset = { point[0] - this->Position[0], point[1] - this->Position[1],
    point[2] - this->Position[2] };
  return { Dot(this->Axes[0], offset), Dot(this->Axes[1], offset), Dot(this->Axes[2], offset) };
}

Real PixelRays::GetDepth(const Vector& point) const
{
  return -this->ToEye(point)[2];
}

std::optional<std::array<double, 2>> PixelRays::Project(const Vector& point) const
{
  const Vector eye = this->ToEye(point);
  const auto clip = [&](int row)
  {
    return Dot({ this->Matrix[row][0], this->Matrix[row][1], this->Matrix[row][2] }, eye) +
      this->Matrix[row][3];
  };
  const Real w = clip(3);
  if (!(w > 0))
  {
    return std::nullopt;
  }
  return std::array<double, 2>{ static_cast<double>((clip(0) / w + 1) / 2 * this->Size[0]),
    static_cast<double>((clip(1) / w + 1) / 2 * this->Size[1]) };
}

}
