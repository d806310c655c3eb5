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

namespace interlume
{

namespace
{
// Computes the columns of the Jacobian at the middle of a cell, times a positive number, for one
// coordinate x(vertex).
template <typename Coordinate>
void FillColumns(vtkIsotable::Shapes shape, Coordinate&& x, double* columns)
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
