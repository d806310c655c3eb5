// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInflowMappingReport.h"

void vtkInflowMappingReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "Ids: " << this->Ids << "\n";
  os << indent << "ContinuedSeams: " << this->ContinuedSeams << "\n";
}
