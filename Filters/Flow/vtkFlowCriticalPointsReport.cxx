// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowCriticalPointsReport.h"

void vtkFlowCriticalPointsReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "ZeroCells: " << this->ZeroCells << "\n";
  os << indent << "DegenerateCells: " << this->DegenerateCells << "\n";
  os << indent << "NonFiniteCells: " << this->NonFiniteCells << "\n";
}
