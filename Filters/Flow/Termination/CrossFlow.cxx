// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/CrossFlow.h"

#include "Common/Vectors.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// Cross-flow below this fraction of the velocity is rounding error.
constexpr double MinimumCrossFlow = 4e-15;
// A point is on a plane if its distance is within this fraction of the cell's height.
constexpr double MinimumDistance = 1e-10;
// An eigenvalue's imaginary part below this fraction of the largest Jacobian entry counts as zero.
constexpr double MinimumSwirl = 1e-9;
// Cosine above which two directions are the same.
constexpr double SameDirection = 1.0 - 1e-12;

// Returns the largest absolute component. Unlike the length, it does not overflow or underflow.
double GetLargest(const double x[3])
{
  return std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
}

void SetUnit(const double x[3], double unit[3])
{
  const double largest = GetLargest(x);
  for (int i = 0; i < 3; ++i)
  {
    unit[i] = x[i] / largest;
  }
  vtkMath::Normalize(unit);
}

// Computes the number of points per axis. Returns false if the dataset is not structured.
bool GetDimensions(vtkDataSet* data, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(dimensions);
    return true;
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(dimensions);
    return true;
  }
  if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(dimensions);
    return true;
  }
  return false;
}
}

CrossFlow::CrossFlow(const double axis[3], const double frameVelocity[3])
{
  SetUnit(axis, this->Normal);
  std::copy_n(frameVelocity, 3, this->FrameVelocity);
  // Start from the coordinate axis with the largest angle to the normal. If the normal is along a
  // coordinate axis, the directions are exactly along the other two axes.
  int perpendicular = 0;
  for (int i = 1; i < 3; ++i)
  {
    perpendicular =
      std::abs(this->Normal[i]) < std::abs(this->Normal[perpendicular]) ? i : perpendicular;
  }
  double across[3] = { 0.0, 0.0, 0.0 };
  across[perpendicular] = 1.0;
  vtkMath::Cross(this->Normal, across, this->Directions[0]);
  vtkMath::Normalize(this->Directions[0]);
  vtkMath::Cross(this->Normal, this->Directions[0], this->Directions[1]);
}

double CrossFlow::GetHeight(const double x[3]) const
{
  return vtkMath::Dot(this->Normal, x);
}

double CrossFlow::GetDistance(const double a[3], const double b[3]) const
{
  double offset[3];
  vtkMath::Subtract(a, b, offset);
  return std::hypot(
    vtkMath::Dot(this->Directions[0], offset), vtkMath::Dot(this->Directions[1], offset));
}

bool CrossFlow::PlacePlanesByLayer(vtkDataSet* data, int& number)
{
  int dimensions[3];
  if (!GetDimensions(data, dimensions))
  {
    return false;
  }
  const vtkIdType strides[3] = { 1, dimensions[0],
    static_cast<vtkIdType>(dimensions[0]) * dimensions[1] };
  double origin[3];
  data->GetPoint(0, origin);
  int nearest = 0;
  double cosines[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    double offset[3];
    data->GetPoint((dimensions[axis] - 1) * strides[axis], offset);
    vtkMath::Subtract(offset, origin, offset);
    const double length = Vectors::SafeLength(glm::make_vec3(offset));
    cosines[axis] = length > 0.0 ? std::abs(this->GetHeight(offset)) / length : 0.0;
    nearest = cosines[axis] > cosines[nearest] ? axis : nearest;
  }
  number = dimensions[nearest];
  if (vtkStructuredGrid::SafeDownCast(data) || cosines[nearest] < SameDirection)
  {
    return false;
  }
  for (int layer = 0; layer < number; ++layer)
  {
    double x[3];
    data->GetPoint(layer * strides[nearest], x);
    this->Planes.push_back(this->GetHeight(x));
  }
  std::sort(this->Planes.begin(), this->Planes.end());
  return true;
}

void CrossFlow::PlacePlanesEvenly(vtkDataSet* data, int number)
{
  double x[3];
  data->GetPoint(0, x);
  double lower = this->GetHeight(x);
  double upper = lower;
  for (vtkIdType i = 1; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, x);
    const double height = this->GetHeight(x);
    lower = std::min(lower, height);
    upper = std::max(upper, height);
  }
  for (int i = 0; i < number; ++i)
  {
    const double part = number > 1 ? static_cast<double>(i) / (number - 1) : 0.5;
    this->Planes.push_back((1.0 - part) * lower + part * upper);
  }
}

void CrossFlow::PlacePlanes(vtkDataSet* data, int number)
{
  this->Planes.clear();
  if (number == 0)
  {
    number = std::max(2, static_cast<int>(std::lround(std::cbrt(data->GetNumberOfPoints()))));
    if (this->PlacePlanesByLayer(data, number))
    {
      return;
    }
  }
  this->PlacePlanesEvenly(data, number);
}

void CrossFlow::GetRange(const MultilinearCell& cell, int& first, int& last) const
{
  const int* corners = nullptr;
  const int number = MultilinearCell::GetCorners(cell.GetShape(), corners);
  double lower = this->GetHeight(cell.GetPositions()[corners[0]]);
  double upper = lower;
  for (int i = 1; i < number; ++i)
  {
    const double height = this->GetHeight(cell.GetPositions()[corners[i]]);
    lower = std::min(lower, height);
    upper = std::max(upper, height);
  }
  const double margin = MinimumDistance * (upper - lower);
  const auto begin = this->Planes.begin();
  first = static_cast<int>(std::lower_bound(begin, this->Planes.end(), lower - margin) - begin);
  last = static_cast<int>(std::upper_bound(begin, this->Planes.end(), upper + margin) - begin);
}

void CrossFlow::Evaluate(
  const MultilinearCell& cell, int plane, MultilinearCell::Values& values) const
{
  double fastest = GetLargest(this->FrameVelocity);
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double* v = cell.GetVectors()[corner];
    double relative[3];
    vtkMath::Subtract(v, this->FrameVelocity, relative);
    values[corner][0] = vtkMath::Dot(this->Directions[0], relative);
    values[corner][1] = vtkMath::Dot(this->Directions[1], relative);
    values[corner][2] = this->GetHeight(cell.GetPositions()[corner]) - this->Planes[plane];
    fastest = std::max(fastest, GetLargest(v));
    farthest = std::max(farthest, std::abs(values[corner][2]));
  }
  const double tolerances[3] = { MinimumCrossFlow * fastest, MinimumCrossFlow * fastest,
    MinimumDistance * farthest };
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int i = 0; i < 3; ++i)
    {
      values[corner][i] = std::abs(values[corner][i]) <= tolerances[i] ? 0.0 : values[corner][i];
    }
  }
}

CrossFlow::Vortex CrossFlow::MakeVortex(const ZeroSearch::Zero& zero) const
{
  Vortex vortex = {};
  vortex.Plane = zero.System;
  std::copy_n(zero.Position, 3, vortex.Position);
  vortex.CellLength = zero.CellLength;
  double velocity[3];
  vtkMath::Subtract(zero.Velocity, this->FrameVelocity, velocity);
  vortex.CrossFlowSpeed = std::hypot(
    vtkMath::Dot(this->Directions[0], velocity), vtkMath::Dot(this->Directions[1], velocity));
  vortex.AxialVelocity = vtkMath::Dot(this->Normal, velocity);
  double jacobian[2][2];
  double size = 0.0;
  for (int j = 0; j < 2; ++j)
  {
    double change[3];
    for (int i = 0; i < 3; ++i)
    {
      change[i] = vtkMath::Dot(zero.Gradient + 3 * i, this->Directions[j]);
    }
    for (int i = 0; i < 2; ++i)
    {
      jacobian[i][j] = vtkMath::Dot(this->Directions[i], change);
      size = std::max(size, std::abs(jacobian[i][j]));
    }
  }
  if (size > 0.0 && !zero.IsDegenerate)
  {
    // Divide by the largest entry so that squares do not overflow.
    const double half = 0.5 * (jacobian[0][0] - jacobian[1][1]) / size;
    const double square = half * half + (jacobian[0][1] / size) * (jacobian[1][0] / size);
    const double swirl = square < 0.0 ? std::sqrt(-square) : 0.0;
    vortex.SwirlStrength = swirl > MinimumSwirl ? swirl * size : 0.0;
    vortex.IsCounterclockwise = jacobian[1][0] > jacobian[0][1];
  }
  return vortex;
}

}
