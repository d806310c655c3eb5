// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplexTimeSliceReport.h"

void vtkSimplexTimeSliceReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "Simplices: " << this->Simplices << "\n";
  os << indent << "Tetrahedra: " << this->Tetrahedra << "\n";
}
