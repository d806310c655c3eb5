// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVortexAxisReport.h"

void vtkVortexAxisReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Planes: " << this->Planes << "\n";
  os << indent << "Places: " << this->Places << "\n";
  os << indent << "PointsOnAxis: " << this->PointsOnAxis << "\n";
}
