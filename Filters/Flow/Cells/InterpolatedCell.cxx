// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/InterpolatedCell.h"

namespace interlume
{

bool InterpolatedCell::IsInBox(int shape, const double x[3]) const
{
  const auto& c = this->Points.C;
  const int corners = CellShape::Of(shape).NumberOfCorners;
  for (int i = 0; i < 3; ++i)
  {
    double minimum = c[0][i];
    double largest = c[0][i];
    for (int corner = 1; corner < corners; ++corner)
    {
      minimum = std::min(minimum, c[corner][i]);
      largest = std::max(largest, c[corner][i]);
    }
    const double slack = 1e-6 * (largest - minimum) + 32.0 * DBL_EPSILON * std::abs(x[i]);
    if (!(x[i] >= minimum - slack && x[i] <= largest + slack))
    {
      return false;
    }
  }
  return true;
}

void InterpolatedCell::EvaluateSecondDerivatives(
  const Trilinear& polynomial, const double p[3], double second[3][3][3]) const
{
  double mixed[3][4];
  // Second derivatives of x y / (1 - z), the only nonlinear term of the interpolant of a pyramid,
  // without its coefficient.
  double factors[3][3] = {};
  const bool isPyramid = this->Shape == CellShape::PYRAMID;
  if (isPyramid)
  {
    double r;
    double s;
    const double w = std::max(GetPyramidRatios(p, r, s), 1e-100);
    factors[0][1] = factors[1][0] = 1.0 / w;
    factors[0][2] = factors[2][0] = s / w;
    factors[1][2] = factors[2][1] = r / w;
    factors[2][2] = 2.0 * r * s / w;
  }
  else
  {
    polynomial.EvaluateMixedDerivatives(p, mixed);
  }
  for (int j = 0; j < 3; ++j)
  {
    for (int k = 0; k < 3; ++k)
    {
      for (int i = 0; i < 3; ++i)
      {
        second[j][k][i] = isPyramid ? factors[j][k] * polynomial.C[3][i]
          : j == k                  ? 0.0
                                    : mixed[j + k - 1][i];
      }
    }
  }
}

// With J = dx/dp and r = J^-1 v: dr/dp_j = J^-1 (dv/dp_j - dJ/dp_j r).
void InterpolatedCell::GetJacobian(const double p[3], double jacobian[9]) const
{
  double columns[3][4];
  this->EvaluateDerivatives(this->Vectors, p, columns);
  if (this->Form == CURVED)
  {
    double inverse[3][3];
    double rate[3];
    double second[3][3][3];
    this->GetInverse(p, inverse);
    this->GetVelocity(p, rate);
    this->EvaluateSecondDerivatives(this->Points, p, second);
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          columns[j][i] -= second[j][k][i] * rate[k];
        }
      }
      InverseJacobian::Multiply(inverse, columns[j], columns[j]);
    }
  }
  for (int i = 0; i < 9; ++i)
  {
    jacobian[i] = columns[i % 3][i / 3];
  }
}

// Each column dx/dp_j is bilinear in the two coordinates other than p_j (in VTK's parametric
// coordinates for a pyramid). Therefore its length is largest at a corner.
double InterpolatedCell::GetMaximumWorldLength(const double d[3]) const
{
  const auto& c = this->Points.C;
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int one = 1 << axis;
    const int second = one | (axis == 0 ? 2 : 1);
    const int third = one | (axis == 2 ? 2 : 4);
    const int both = this->Shape == CellShape::PYRAMID && axis == 2 ? 3 : 7;
    double longest = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double u = corner & 1;
      const double v = corner >> 1;
      // The 1-norm is an upper bound of the length and needs no square root.
      double length = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        length += std::abs(c[one][i] + u * c[second][i] + v * (c[third][i] + u * c[both][i]));
      }
      longest = std::max(longest, length);
    }
    sum += longest * d[axis];
  }
  return sum;
}

void InterpolatedCell::GetVelocityGradient(const double p[3], double gradient[9]) const
{
  double frame[3][4];
  double inverse[3][3];
  double columns[3][4];
  this->EvaluateDerivatives(this->Points, p, frame);
  InverseJacobian::Invert(frame, inverse);
  this->EvaluateDerivatives(this->Vectors, p, columns);
  if (this->Form != CURVED)
  {
    for (auto& column : columns)
    {
      InverseJacobian::Combine(frame, column, column);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      gradient[3 * i + j] = columns[0][i] * inverse[0][j] + columns[1][i] * inverse[1][j] +
        columns[2][i] * inverse[2][j];
    }
  }
}

bool InterpolatedCell::FindCellCoordinates(const double x[3], bool fromSeveral, double p[3]) const
{
  const CellShape& shape = CellShape::Of(this->Shape);
  if (!fromSeveral)
  {
    return this->FindCellCoordinatesFrom(shape.Center, x, p);
  }
  // Starts Newton's method once per corner, from a point between the corner and the center. Returns
  // the solution that is deepest inside the cell.
  bool hasCoordinates = false;
  for (int corner = 0; corner < shape.NumberOfCorners; ++corner)
  {
    double start[3];
    double found[3];
    for (int i = 0; i < 3; ++i)
    {
      start[i] = 0.75 * shape.Corners[corner][i] + 0.25 * shape.Center[i];
    }
    if (this->FindCellCoordinatesFrom(start, x, found) &&
      (!hasCoordinates || this->GetDistance(found) > this->GetDistance(p)))
    {
      hasCoordinates = true;
      std::copy(found, found + 3, p);
    }
  }
  return hasCoordinates;
}

bool InterpolatedCell::FindCellCoordinatesFrom(
  const double start[3], const double x[3], double p[3]) const
{
  constexpr int maximumIterations = 40;
  // At larger parametric coordinates, the polynomial of a curved cell is meaningless.
  constexpr double farthest = 100.0;
  // Below this length, Newton steps decrease quadratically until they reach rounding error.
  constexpr double nearby = 1e-5;
  constexpr double minimumStep = 1e-15;
  std::copy(start, start + 3, p);
  double previous = 1.0;
  for (int iteration = 0; iteration < maximumIterations; ++iteration)
  {
    double rest[3];
    double inverse[3][3];
    this->GetPosition(p, rest);
    for (int i = 0; i < 3; ++i)
    {
      rest[i] = x[i] - rest[i];
    }
    this->GetInverse(p, inverse);
    double step[3];
    InverseJacobian::Multiply(inverse, rest, step);
    const double length = std::max({ std::abs(step[0]), std::abs(step[1]), std::abs(step[2]) });
    if (!(length < 1e100))
    {
      return false;
    }
    if (length <= minimumStep || (previous < nearby && length >= 0.5 * previous))
    {
      return true;
    }
    previous = length;
    double reach = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      p[i] += step[i];
      reach = std::max(reach, std::abs(p[i]));
    }
    if (this->Form == CURVED && reach > farthest)
    {
      return false;
    }
  }
  return false;
}

FaceExtent InterpolatedCell::GetFaceExtent(int face) const
{
  const CellShape& shape = CellShape::Of(this->Shape);
  double all[8][3];
  for (int i = 0; i < shape.NumberOfCorners; ++i)
  {
    this->GetPosition(shape.Corners[i], all[i]);
  }
  const CellShape::Face& own = shape.Faces[face];
  double corners[4][3];
  for (int i = 0; i < own.NumberOfCorners; ++i)
  {
    std::copy_n(all[own.Corners[i]], 3, corners[i]);
  }
  return FaceExtent::Of(corners, own.NumberOfCorners, all, shape.NumberOfCorners);
}

double InterpolatedCell::GetDistance(const double p[3]) const
{
  double minimum = this->GetFace(0).GetDistance(p);
  for (int face = 1; face < this->GetNumberOfFaces(); ++face)
  {
    minimum = std::min(minimum, this->GetFace(face).GetDistance(p));
  }
  return minimum;
}

void InterpolatedCell::Clamp(double p[3]) const
{
  for (int face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    const double* plane = this->GetFace(face).Plane;
    const double distance = this->GetFace(face).GetDistance(p);
    if (distance < 0.0)
    {
      const double squared = plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2];
      for (int i = 0; i < 3; ++i)
      {
        p[i] -= distance * plane[i] / squared;
      }
    }
  }
}

}
