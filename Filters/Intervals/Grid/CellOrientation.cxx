// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/CellOrientation.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace interlume
{

namespace
{
// Computes the columns of the Jacobian at the cell center, up to positive factors. x(vertex)
// returns one coordinate, or a vector of all coordinates, of a vertex.
template <typename Coordinate, typename Number>
void FillColumns(vtkIsotable::Shapes shape, Coordinate&& x, Number* columns)
{
  switch (shape)
  {
    case vtkIsotable::TETRAHEDRON:
      columns[0] = x(1) - x(0);
      columns[1] = x(2) - x(0);
      columns[2] = x(3) - x(0);
      break;
    case vtkIsotable::PYRAMID:
      columns[0] = (x(1) - x(0)) + (x(2) - x(3));
      columns[1] = (x(3) - x(0)) + (x(2) - x(1));
      columns[2] = (x(4) - x(0)) + (x(4) - x(1)) + (x(4) - x(2)) + (x(4) - x(3));
      break;
    case vtkIsotable::WEDGE:
      columns[0] = (x(1) - x(0)) + (x(4) - x(3));
      columns[1] = (x(2) - x(0)) + (x(5) - x(3));
      columns[2] = (x(3) - x(0)) + (x(4) - x(1)) + (x(5) - x(2));
      break;
    default:
      columns[0] = (x(1) - x(0)) + (x(3) - x(2)) + (x(5) - x(4)) + (x(7) - x(6));
      columns[1] = (x(2) - x(0)) + (x(3) - x(1)) + (x(6) - x(4)) + (x(7) - x(5));
      columns[2] = (x(4) - x(0)) + (x(5) - x(1)) + (x(6) - x(2)) + (x(7) - x(3));
  }
}

// Returns the sign of the Jacobian determinant at the cell center. getPoint(v) returns the
// coordinates of a vertex.
template <typename GetPoint>
int GetDeterminantSign(vtkIsotable::Shapes shape, GetPoint&& getPoint)
{
  double columns[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    FillColumns(
      shape, [&](int v) { return static_cast<double>(getPoint(v)[axis]); }, columns[axis]);
  }
  const double determinant = vtkMath::Determinant3x3(columns);
  return determinant < 0.0 ? -1 : determinant > 0.0 ? 1 : 0;
}

// A single-precision vector of three coordinates and a zero.
using RoughVector = float __attribute__((vector_size(16)));
using RoughBits = unsigned int __attribute__((vector_size(16)));

// Computes the same columns as FillColumns with fewer additions. Requires x[0] to be zero.
void FillRoughColumns(vtkIsotable::Shapes shape, const RoughVector* x, RoughVector* columns)
{
  if (shape != vtkIsotable::HEXAHEDRON)
  {
    FillColumns(
      shape, [x](int v) -> const RoughVector& { return x[v]; }, columns);
    return;
  }
  const RoughVector behind = x[2] + x[3];
  const RoughVector above = x[4] + x[5];
  const RoughVector aboveBehind = x[6] + x[7];
  columns[0] = (x[1] + (x[3] - x[2])) + ((x[5] - x[4]) + (x[7] - x[6]));
  columns[1] = (behind - x[1]) + (aboveBehind - above);
  columns[2] = (above + aboveBehind) - (x[1] + behind);
}

// Returns the sign of the determinant if single precision is sufficient, otherwise 0. Let u be the
// unit roundoff and s the sum of the maximum distances from the first vertex along the axes. A
// column is a sum of at most eight distances, so its length is at most 8 s and its rounding error
// below 48 u s. The error of the determinant is below (3 * 48 * 64 + 20 * 512) u s^3, for which
// 2^15 u s^3 is a safe bound. The range of s excludes underflow and overflow.
template <vtkIsotable::Shapes Shape, int Vertices>
int GetRoughSign(const float* coordinates, const vtkIdType* points)
{
  constexpr float bound = 1.0f / (1 << 9);
  constexpr float minimumSize = 1e-9f;
  constexpr float maximumSize = 1e9f;
  const auto read = [=](int v) -> RoughVector
  {
    const float* const from = coordinates + 3 * points[v];
    return RoughVector{ from[0], from[1], from[2], 0.0f };
  };
  const RoughVector first = read(0);
  RoughVector x[8] = {};
  RoughVector distances = {};
  for (int v = 1; v < Vertices; ++v)
  {
    x[v] = read(v) - first;
    const RoughVector distance = RoughVector(RoughBits(x[v]) & (~0u >> 1));
    distances = distances < distance ? distance : distances;
  }
  RoughVector columns[3];
  FillRoughColumns(Shape, x, columns);
  const RoughVector& a = columns[0];
  const RoughVector& b = columns[1];
  const RoughVector& c = columns[2];
  const float determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) +
    a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  const float size = distances[0] + distances[1] + distances[2];
  const bool isSafe = size > minimumSize && size < maximumSize &&
    std::abs(determinant) > bound * (size * size * size);
  return !isSafe ? 0 : determinant < 0.0f ? -1 : 1;
}

int GetRoughSign(vtkIsotable::Shapes shape, const float* coordinates, const vtkIdType* points)
{
  switch (shape)
  {
    case vtkIsotable::TETRAHEDRON:
      return GetRoughSign<vtkIsotable::TETRAHEDRON, 4>(coordinates, points);
    case vtkIsotable::PYRAMID:
      return GetRoughSign<vtkIsotable::PYRAMID, 5>(coordinates, points);
    case vtkIsotable::WEDGE:
      return GetRoughSign<vtkIsotable::WEDGE, 6>(coordinates, points);
    default:
      return GetRoughSign<vtkIsotable::HEXAHEDRON, 8>(coordinates, points);
  }
}

// The three edges at a corner, each from end to end in the direction of a cell axis.
struct CornerEdges
{
  std::uint8_t Ends[3][2];
};

constexpr CornerEdges HexahedronCorners[] = { { { { 0, 1 }, { 0, 2 }, { 0, 4 } } },
  { { { 0, 1 }, { 1, 3 }, { 1, 5 } } }, { { { 2, 3 }, { 0, 2 }, { 2, 6 } } },
  { { { 2, 3 }, { 1, 3 }, { 3, 7 } } }, { { { 4, 5 }, { 4, 6 }, { 0, 4 } } },
  { { { 4, 5 }, { 5, 7 }, { 1, 5 } } }, { { { 6, 7 }, { 4, 6 }, { 2, 6 } } },
  { { { 6, 7 }, { 5, 7 }, { 3, 7 } } } };
constexpr CornerEdges WedgeCorners[] = { { { { 0, 1 }, { 0, 2 }, { 0, 3 } } },
  { { { 1, 2 }, { 1, 0 }, { 1, 4 } } }, { { { 2, 0 }, { 2, 1 }, { 2, 5 } } },
  { { { 3, 4 }, { 3, 5 }, { 0, 3 } } }, { { { 4, 5 }, { 4, 3 }, { 1, 4 } } },
  { { { 5, 3 }, { 5, 4 }, { 2, 5 } } } };
constexpr CornerEdges PyramidCorners[] = { { { { 0, 1 }, { 0, 3 }, { 0, 4 } } },
  { { { 0, 1 }, { 1, 2 }, { 1, 4 } } }, { { { 3, 2 }, { 1, 2 }, { 2, 4 } } },
  { { { 3, 2 }, { 0, 3 }, { 3, 4 } } } };

// Returns whether the Jacobian is positive at some corners and negative at others. \a x contains
// the coordinates of the vertices.
template <std::size_t Number>
bool HasBothSigns(const CornerEdges (&corners)[Number], const double (*x)[3])
{
  double minimum = 0.0;
  double maximum = 0.0;
  for (const CornerEdges& corner : corners)
  {
    double edges[3][3];
    for (int edge = 0; edge < 3; ++edge)
    {
      vtkMath::Subtract(x[corner.Ends[edge][1]], x[corner.Ends[edge][0]], edges[edge]);
    }
    const double determinant = vtkMath::Determinant3x3(edges[0], edges[1], edges[2]);
    minimum = std::min(minimum, determinant);
    maximum = std::max(maximum, determinant);
  }
  // The sign is unreliable at nearly collapsed corners.
  constexpr double collapsed = 0.01;
  return minimum < -collapsed * maximum && maximum > -collapsed * minimum;
}

// Returns whether the last finite coordinate is less than the first one.
bool Decreases(vtkDataArray* coordinates)
{
  vtkIdType first = 0;
  vtkIdType last = coordinates->GetNumberOfTuples() - 1;
  const auto isFinite = [coordinates](vtkIdType i)
  { return std::isfinite(coordinates->GetComponent(i, 0)); };
  for (; first < last && !isFinite(first); ++first)
  {
  }
  for (; first < last && !isFinite(last); --last)
  {
  }
  return first < last && coordinates->GetComponent(last, 0) < coordinates->GetComponent(first, 0);
}
}

CellOrientation::CellOrientation(vtkDataSet* input)
{
  if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(input))
  {
    this->Points = pointSet->GetPoints();
    if (vtkFloatArray* floats = vtkFloatArray::SafeDownCast(this->Points->GetData()))
    {
      this->Floats = floats->GetPointer(0);
    }
    else if (vtkDoubleArray* doubles = vtkDoubleArray::SafeDownCast(this->Points->GetData()))
    {
      this->Doubles = doubles->GetPointer(0);
    }
  }
  else if (vtkImageData* image = vtkImageData::SafeDownCast(input))
  {
    const double* spacing = image->GetSpacing();
    this->AllInverted =
      spacing[0] * spacing[1] * spacing[2] * image->GetDirectionMatrix()->Determinant() < 0.0;
  }
  else if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input))
  {
    this->AllInverted = Decreases(grid->GetXCoordinates()) !=
      (Decreases(grid->GetYCoordinates()) != Decreases(grid->GetZCoordinates()));
  }
}

bool CellOrientation::IsCellFolded(vtkIsotable::Shapes shape, const vtkIdType* points) const
{
  double x[8][3];
  const int number = shape == vtkIsotable::PYRAMID ? 5 : shape == vtkIsotable::WEDGE ? 6 : 8;
  for (int v = 0; v < number; ++v)
  {
    if (this->Floats)
    {
      std::copy_n(this->Floats + 3 * points[v], 3, x[v]);
    }
    else if (this->Doubles)
    {
      std::copy_n(this->Doubles + 3 * points[v], 3, x[v]);
    }
    else
    {
      this->Points->GetPoint(points[v], x[v]);
    }
  }
  switch (shape)
  {
    case vtkIsotable::PYRAMID:
      return HasBothSigns(PyramidCorners, x);
    case vtkIsotable::WEDGE:
      return HasBothSigns(WedgeCorners, x);
    default:
      return HasBothSigns(HexahedronCorners, x);
  }
}

int CellOrientation::GetCellSign(vtkIsotable::Shapes shape, const vtkIdType* points) const
{
  if (this->Floats)
  {
    const int rough = GetRoughSign(shape, this->Floats, points);
    if (rough != 0)
    {
      return rough;
    }
    return GetDeterminantSign(shape, [&](int v) { return this->Floats + 3 * points[v]; });
  }
  if (this->Doubles)
  {
    return GetDeterminantSign(shape, [&](int v) { return this->Doubles + 3 * points[v]; });
  }
  return GetDeterminantSign(shape,
    [&](int v)
    {
      std::array<double, 3> x;
      this->Points->GetPoint(points[v], x.data());
      return x;
    });
}

}
