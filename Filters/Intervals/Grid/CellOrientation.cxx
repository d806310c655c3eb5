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

#include <array>
#include <cmath>

namespace interlume
{

namespace
{
// Computes the columns of the Jacobian at the middle of a cell, times a positive number, for one
// coordinate x(vertex) or for all.
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

// getPoint(v) gives the coordinates of a vertex.
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

// The three coordinates of a vector in single precision, and the sizes of the differences that it
// is a sum of. The fourth entries are there for the sake of vector instructions.
struct RoughVector
{
  float Values[4];
  float Sizes[4];

  float GetSize() const { return this->Sizes[0] + this->Sizes[1] + this->Sizes[2]; }

  friend RoughVector operator-(const RoughVector& a, const RoughVector& b)
  {
    RoughVector c;
    for (int axis = 0; axis < 4; ++axis)
    {
      c.Values[axis] = a.Values[axis] - b.Values[axis];
      c.Sizes[axis] = std::abs(c.Values[axis]);
    }
    return c;
  }

  friend RoughVector operator+(const RoughVector& a, const RoughVector& b)
  {
    RoughVector c;
    for (int axis = 0; axis < 4; ++axis)
    {
      c.Values[axis] = a.Values[axis] + b.Values[axis];
      c.Sizes[axis] = a.Sizes[axis] + b.Sizes[axis];
    }
    return c;
  }
};

// Returns the sign of the determinant where single precision is enough to tell, else 0. A column is
// rounded by less than 5 units of its size, each of the six products by less than 20, so that 64
// are a safe bound; the sizes are such that nothing underflows or overflows.
int GetRoughSign(vtkIsotable::Shapes shape, const float* coordinates, const vtkIdType* points)
{
  constexpr int vertices[vtkIsotable::NUMBER_OF_SHAPES] = { 4, 5, 6, 8 };
  constexpr float bound = 64.0f / (1 << 24);
  constexpr float least = 1e-9f;
  constexpr float most = 1e9f;
  RoughVector x[8];
  for (int v = 0; v < vertices[shape]; ++v)
  {
    const float* from = coordinates + 3 * points[v];
    x[v] = { { from[0], from[1], from[2], 0.0f }, {} };
  }
  RoughVector columns[3];
  FillColumns(
    shape, [&x](int v) -> const RoughVector& { return x[v]; }, columns);
  const float* a = columns[0].Values;
  const float* b = columns[1].Values;
  const float* c = columns[2].Values;
  const float determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) +
    a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  float size = 1.0f;
  bool isSafe = true;
  for (const RoughVector& column : columns)
  {
    isSafe &= column.GetSize() > least && column.GetSize() < most;
    size *= column.GetSize();
  }
  return !isSafe || !(std::abs(determinant) > bound * size) ? 0 : determinant < 0.0f ? -1 : 1;
}

bool Decreases(vtkDataArray* coordinates)
{
  const vtkIdType n = coordinates->GetNumberOfTuples();
  return n > 1 && coordinates->GetComponent(n - 1, 0) < coordinates->GetComponent(0, 0);
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
