// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolumeReport.h"

void vtkFlowVolumeReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Cells: " << this->Cells << "\n";
  os << indent << "CellsWithoutAnswer: " << this->CellsWithoutAnswer << "\n";
  os << indent << "CellsBetweenSurfaces: " << this->CellsBetweenSurfaces << "\n";
  os << indent << "CellsOnSeams: " << this->CellsOnSeams << "\n";
  os << indent << "CellsAcrossSurfaces: " << this->CellsAcrossSurfaces << "\n";
  os << indent << "CellsWithTimeJumps: " << this->CellsWithTimeJumps << "\n";
  os << indent << "CellsCut: " << this->CellsCut << "\n";
  os << indent << "CellsAcrossSeams: " << this->CellsAcrossSeams << "\n";
  os << indent << "CellsAroundPoles: " << this->CellsAroundPoles << "\n";
  os << indent << "PointsOnSeams: " << this->PointsOnSeams << "\n";
  os << indent << "Preparations: " << this->Preparations << "\n";
  os << indent << "InflowPasses: " << this->InflowPasses << "\n";
  os << indent << "TimePasses: " << this->TimePasses << "\n";
  os << indent << "SurfaceCuts: " << this->SurfaceCuts << "\n";
  os << indent << "NormalPasses: " << this->NormalPasses << "\n";
}
