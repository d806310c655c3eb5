// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/TimeBoundary.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <algorithm>

namespace gallery
{
vtkSmartPointer<vtkUnstructuredGrid> MakeTimeBoundary(
  vtkTimeVaryingIntervalVolume* filter, const std::vector<int>& kinds)
{
  vtkUnstructuredGrid* all = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
  vtkDataArray* kindOf = all->GetCellData()->GetArray("BoundaryKind");
  auto chosen = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetPoints()->GetDataType());
  chosen->SetPoints(points);
  chosen->GetPointData()->CopyAllocate(all->GetPointData());
  vtkNew<vtkIntArray> ids;
  ids->SetName("IntervalId");
  std::vector<vtkIdType> newIds(static_cast<std::size_t>(all->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    const auto kind =
      std::find(kinds.begin(), kinds.end(), static_cast<int>(kindOf->GetComponent(cell, 0)));
    if (kind == kinds.end())
    {
      continue;
    }
    all->GetCellPoints(cell, corners);
    for (vtkIdType& corner : *corners)
    {
      vtkIdType& newId = newIds[static_cast<std::size_t>(corner)];
      if (newId < 0)
      {
        newId = points->InsertNextPoint(all->GetPoint(corner));
        chosen->GetPointData()->CopyData(all->GetPointData(), corner, newId);
      }
      corner = newId;
    }
    chosen->InsertNextCell(all->GetCellType(cell), corners);
    ids->InsertNextValue(static_cast<int>(kind - kinds.begin()));
  }
  chosen->GetCellData()->AddArray(ids);
  return chosen;
}
}
