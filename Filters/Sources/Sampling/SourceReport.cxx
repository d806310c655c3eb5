// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/SourceReport.h"

#include "Common/ReportValue.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace interlume
{

namespace
{
vtkIdType GetBytes(vtkDataArray* array)
{
  return array->GetNumberOfValues() * array->GetDataTypeSize();
}
}

SourceReport SourceReport::Of(vtkDataSet* output, vtkIdType evaluations, double time)
{
  SourceReport report;
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

void SourceReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
    { { "Points", this->Points }, { "Evaluations", this->Evaluations }, { "Bytes", this->Bytes },
      { "Time", this->Time } });
}

}
