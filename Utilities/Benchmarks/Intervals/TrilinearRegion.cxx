// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Intervals/TrilinearRegion.h"

#include "Benchmarks/Measures/LevelDistance.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Returns the length of the part of [0, 1] where a linear function with the values \a bottom at 0
/// and \a top at 1 is at most \a bound.
double LengthBelow(double bottom, double top, double bound)
{
  const bool bottomInside = bottom <= bound;
  if (bottomInside == (top <= bound))
  {
    return bottomInside ? 1.0 : 0.0;
  }
  const double crossing = (bound - bottom) / (top - bottom);
  return bottomInside ? crossing : 1.0 - crossing;
}

/// Bilinear function on the unit square with values a at (0,0), b at (1,0), c at (0,1), d at (1,1).
struct Bilinear
{
  double A, B, C, D;

  double operator()(double x, double y) const
  {
    return (1.0 - y) * ((1.0 - x) * this->A + x * this->B) +
      y * ((1.0 - x) * this->C + x * this->D);
  }
};

struct Square
{
  double X, Y, Size;
};

/// The trilinear function of a cell: bilinear on the bottom and top faces, and linear along z.
class CellColumns
{
public:
  explicit CellColumns(const std::array<double, 8>& corners)
    : Bottom{ corners[0], corners[1], corners[2], corners[3] }
    , Top{ corners[4], corners[5], corners[6], corners[7] }
  {
  }

  /// Returns the volume of the part of the column over \a square where the function is at most
  /// \a bound.
  double VolumeBelow(double bound, const Square& square, int depth) const
  {
    if (depth > 0 &&
      (this->IsCrossed(this->Bottom, bound, square) || this->IsCrossed(this->Top, bound, square)))
    {
      const double half = 0.5 * square.Size;
      double volume = 0.0;
      for (int quarter = 0; quarter < 4; ++quarter)
      {
        volume += this->VolumeBelow(bound,
          { square.X + half * (quarter % 2), square.Y + half * (quarter / 2), half }, depth - 1);
      }
      return volume;
    }
    return this->Integrate(bound, square);
  }

private:
  /// Returns whether the contour of \a face at \a bound may intersect \a square. On an axis-aligned
  /// square, the values of a bilinear function are bounded by those at the corners.
  static bool IsCrossed(const Bilinear& face, double bound, const Square& square)
  {
    const double x = square.X + square.Size;
    const double y = square.Y + square.Size;
    const auto range =
      std::minmax({ face(square.X, square.Y), face(x, square.Y), face(square.X, y), face(x, y) });
    return range.first <= bound && range.second >= bound;
  }

  double Integrate(double bound, const Square& square) const
  {
    const double node = std::sqrt(0.6);
    const double nodes[3] = { 0.5 - 0.5 * node, 0.5, 0.5 + 0.5 * node };
    const double weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    double volume = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        const double x = square.X + square.Size * nodes[i];
        const double y = square.Y + square.Size * nodes[j];
        volume += weights[i] * weights[j] * LengthBelow(this->Bottom(x, y), this->Top(x, y), bound);
      }
    }
    return volume * square.Size * square.Size;
  }

  Bilinear Bottom;
  Bilinear Top;
};
}

TrilinearRegion::TrilinearRegion(vtkImageData* image)
{
  image->GetDimensions(this->Dimensions.data());
  image->GetOrigin(this->Origin.data());
  image->GetSpacing(this->Spacing.data());
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  this->Values.resize(scalars->GetNumberOfTuples());
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    this->Values[id] = scalars->GetTuple1(id);
  }
}

TrilinearRegion::Corners TrilinearRegion::GetCorners(int i, int j, int k) const
{
  const std::size_t row = this->Dimensions[0];
  const std::size_t slab = row * this->Dimensions[1];
  const std::size_t at = i + row * j + slab * k;
  Corners corners;
  for (std::size_t c = 0; c < 8; ++c)
  {
    corners[c] = this->Values[at + c % 2 + row * (c / 2 % 2) + slab * (c / 4)];
  }
  return corners;
}

double TrilinearRegion::GetVolume(double lower, double upper, int depth) const
{
  const Square unitSquare = { 0.0, 0.0, 1.0 };
  double cells = 0.0;
  for (int k = 0; k + 1 < this->Dimensions[2]; ++k)
  {
    for (int j = 0; j + 1 < this->Dimensions[1]; ++j)
    {
      for (int i = 0; i + 1 < this->Dimensions[0]; ++i)
      {
        const Corners corners = this->GetCorners(i, j, k);
        const auto range = std::minmax_element(corners.begin(), corners.end());
        if (*range.second < lower || *range.first > upper)
        {
          continue;
        }
        if (*range.first >= lower && *range.second <= upper)
        {
          cells += 1.0;
          continue;
        }
        const CellColumns columns(corners);
        cells += columns.VolumeBelow(upper, unitSquare, depth) -
          columns.VolumeBelow(lower, unitSquare, depth);
      }
    }
  }
  return cells * this->Spacing[0] * this->Spacing[1] * this->Spacing[2];
}

double TrilinearRegion::Evaluate(const double point[3], double gradient[3]) const
{
  int cell[3];
  double r[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double index = (point[axis] - this->Origin[axis]) / this->Spacing[axis];
    cell[axis] = std::clamp(static_cast<int>(std::floor(index)), 0, this->Dimensions[axis] - 2);
    r[axis] = index - cell[axis];
  }
  const Corners v = this->GetCorners(cell[0], cell[1], cell[2]);
  const Bilinear bottom{ v[0], v[1], v[2], v[3] };
  const Bilinear top{ v[4], v[5], v[6], v[7] };
  const Bilinear alongX{ v[1] - v[0], v[3] - v[2], v[5] - v[4], v[7] - v[6] };
  const Bilinear alongY{ v[2] - v[0], v[3] - v[1], v[6] - v[4], v[7] - v[5] };
  gradient[0] = alongX(r[1], r[2]) / this->Spacing[0];
  gradient[1] = alongY(r[0], r[2]) / this->Spacing[1];
  gradient[2] = (top(r[0], r[1]) - bottom(r[0], r[1])) / this->Spacing[2];
  return (1.0 - r[2]) * bottom(r[0], r[1]) + r[2] * top(r[0], r[1]);
}

double TrilinearRegion::GetDistance(const double point[3], double value) const
{
  return DistanceToLevel([this](const double at[3], double gradient[3])
    { return this->Evaluate(at, gradient); },
    point, value, this->Spacing[0]);
}

bool TrilinearRegion::AreOnSameBoxFace(
  const double a[3], const double b[3], const double c[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = this->Spacing[axis] * (this->Dimensions[axis] - 1);
    for (double side : { this->Origin[axis], this->Origin[axis] + size })
    {
      const double tolerance = 1e-9 * size;
      if (std::abs(a[axis] - side) < tolerance && std::abs(b[axis] - side) < tolerance &&
        std::abs(c[axis] - side) < tolerance)
      {
        return true;
      }
    }
  }
  return false;
}
