// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/RegionError.h"

#include "Benchmarks/Measures/SurfaceDistances.h"
#include "Benchmarks/Measures/TetrahedronSums.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace interval4d
{
namespace
{
/// Returns true if \a value equals \a bound up to rounding error. The point with this value is then
/// on the isosurface of \a bound.
bool IsAt(double value, double bound)
{
  return std::abs(value - bound) < 1e-9;
}
}

RegionError MeasureRegionError(
  const MovingField& field, double time, vtkUnstructuredGrid* tetrahedra)
{
  vtkDataArray* values = tetrahedra->GetPointData()->GetArray(field.Source->GetArrayName());
  vtkNew<vtkIdList> ids;
  SurfaceDistances surface;
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    tetrahedra->GetCellPoints(cell, ids);
    for (const double bound : { field.Lower, field.Upper })
    {
      double x[4][3];
      int number = 0;
      for (const vtkIdType id : *ids)
      {
        if (IsAt(values->GetTuple1(id), bound))
        {
          tetrahedra->GetPoint(id, x[number++]);
        }
      }
      if (number == 3)
      {
        surface.AddTriangle(
          x, [&](const double point[3]) { return field.GetDistance(point, bound, time); });
      }
    }
  }
  const double exact = field.Volume(time);
  RegionError error;
  error.SymmetricDifference = surface.Integral / exact;
  error.Volume = std::abs(SumTetrahedra(tetrahedra).Volume - exact) / exact;
  return error;
}
}
