// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowLICReport.h"

void vtkFlowLICReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Points: " << this->Points << "\n";
  os << indent << "PointsOutside: " << this->PointsOutside << "\n";
  os << indent << "PointsAtRest: " << this->PointsAtRest << "\n";
  os << indent << "PointsWithShortLines: " << this->PointsWithShortLines << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "NoiseScale: " << this->NoiseScale << "\n";
}
