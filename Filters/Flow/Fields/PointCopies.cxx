// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/PointCopies.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace interlume
{

void PointCopies::Append(
  vtkPointSet* input, const std::vector<vtkIdType>& sources, vtkPoints* points, vtkPointData* data)
{
  const vtkIdType before = input->GetNumberOfPoints();
  const vtkIdType after = before + static_cast<vtkIdType>(sources.size());
  points->SetDataType(input->GetPoints()->GetDataType());
  points->GetData()->DeepCopy(input->GetPoints()->GetData());
  points->Resize(after);
  vtkPointData* from = input->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(from, after);
  data->CopyData(from, 0, before, 0);
  for (vtkIdType p = before; p < after; ++p)
  {
    const vtkIdType source = sources[p - before];
    double x[3];
    input->GetPoint(source, x);
    points->InsertNextPoint(x);
    data->CopyData(from, source, p);
  }
}

}
