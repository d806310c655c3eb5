// SPDX-License-Identifier: BSD-3-Clause
#ifndef reference_ReferenceReport_h
#define reference_ReferenceReport_h

#include "vtkInterlumeReport.h"
#include "vtkSmartPointer.h"

namespace reference
{

using ReportCopy = vtkSmartPointer<vtkInterlumeReport>;

/// Returns a copy of a report. The copy keeps its values when the filter or mapper executes again.
inline ReportCopy CopyReport(vtkInterlumeReport* report)
{
  auto copy = ReportCopy::New();
  copy->DeepCopy(report);
  return copy;
}

}

#endif
