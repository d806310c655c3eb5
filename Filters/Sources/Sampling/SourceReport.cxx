// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSourceReport.h"

#include "Common/NamedValue.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace
{
vtkIdType GetBytes(vtkDataArray* array)
{
  return array->GetNumberOfValues() * array->GetDataTypeSize();
}
}

vtkSourceReport vtkSourceReport::Of(vtkDataSet* output, vtkIdType evaluations, double time)
{
  vtkSourceReport report;
  report.Points = output->GetNumberOfPoints();
  report.Evaluations = evaluations;
  report.Time = time;
  for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
  {
    report.Bytes += GetBytes(output->GetPointData()->GetArray(i));
  }
  if (vtkPointSet* set = vtkPointSet::SafeDownCast(output))
  {
    report.Bytes += GetBytes(set->GetPoints()->GetData());
  }
  return report;
}

void vtkSourceReport::Print(std::ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Points", this->Points }, { "Evaluations", this->Evaluations }, { "Bytes", this->Bytes },
      { "Time", this->Time } });
}
