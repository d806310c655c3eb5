#include "vtkCellOrientation.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"

#include <array>

namespace
{
// Weights of the vertices in the three columns of the Jacobian at the middle of a cell.
struct Jacobian
{
  int NumberOfVertices;
  double Weights[3][vtkIsotable::MaximumNumberOfVertices];
};

const Jacobian Jacobians[vtkIsotable::NUMBER_OF_SHAPES] = {
  { 4, { { -1, 1, 0, 0 }, { -1, 0, 1, 0 }, { -1, 0, 0, 1 } } },
  { 5, { { -1, 1, 1, -1, 0 }, { -1, -1, 1, 1, 0 }, { -1, -1, -1, -1, 4 } } },
  { 6, { { -1, 1, 0, -1, 1, 0 }, { -1, 0, 1, -1, 0, 1 }, { -1, -1, -1, 1, 1, 1 } } },
  { 8,
    { { -1, 1, -1, 1, -1, 1, -1, 1 }, { -1, -1, 1, 1, -1, -1, 1, 1 },
      { -1, -1, -1, -1, 1, 1, 1, 1 } } }
};

// getPoint(v) gives the coordinates of a vertex.
template <typename GetPoint>
bool IsNegative(const Jacobian& jacobian, GetPoint&& getPoint)
{
  double columns[3][3] = {};
  for (int v = 0; v < jacobian.NumberOfVertices; ++v)
  {
    const auto x = getPoint(v);
    for (int c = 0; c < 3; ++c)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        columns[c][axis] += jacobian.Weights[c][v] * static_cast<double>(x[axis]);
      }
    }
  }
  return vtkMath::Determinant3x3(columns) < 0.0;
}

bool Decreases(vtkDataArray* coordinates)
{
  const vtkIdType n = coordinates->GetNumberOfTuples();
  return n > 1 && coordinates->GetComponent(n - 1, 0) < coordinates->GetComponent(0, 0);
}
}

vtkCellOrientation::vtkCellOrientation(vtkDataSet* input)
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

bool vtkCellOrientation::IsCellInverted(vtkIsotable::Shapes shape, const vtkIdType* points) const
{
  const Jacobian& jacobian = Jacobians[shape];
  if (this->Floats)
  {
    return IsNegative(jacobian, [&](int v) { return this->Floats + 3 * points[v]; });
  }
  if (this->Doubles)
  {
    return IsNegative(jacobian, [&](int v) { return this->Doubles + 3 * points[v]; });
  }
  return IsNegative(jacobian,
    [&](int v)
    {
      std::array<double, 3> x;
      this->Points->GetPoint(points[v], x.data());
      return x;
    });
}
