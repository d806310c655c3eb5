// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStreamSurfaceParametersReport.h"

void vtkStreamSurfaceParametersReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Contours: " << this->Contours << "\n";
  os << indent << "ClosedContours: " << this->ClosedContours << "\n";
  os << indent << "AddedPoints: " << this->AddedPoints << "\n";
}
