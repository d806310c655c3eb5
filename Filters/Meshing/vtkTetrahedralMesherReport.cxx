// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetrahedralMesherReport.h"

#include <ostream>

void vtkTetrahedralMesherReport::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "Cells: " << this->Cells << "\n";
  os << indent << "CellsByTetGen: " << this->CellsByTetGen << "\n";
  os << indent << "CellsConed: " << this->CellsConed << "\n";
  os << indent << "CellsLeftOut: " << this->CellsLeftOut << "\n";
  os << indent << "UnsupportedCells: " << this->UnsupportedCells << "\n";
  os << indent << "SurfaceTriangles: " << this->SurfaceTriangles << "\n";
  os << indent << "MergedPoints: " << this->MergedPoints << "\n";
  os << indent << "AddedPoints: " << this->AddedPoints << "\n";
  os << indent << "Regions: " << this->Regions << "\n";
  os << indent << "Tetrahedra: " << this->Tetrahedra << "\n";
  os << indent << "TetrahedraAboveQualityBound: " << this->TetrahedraAboveQualityBound << "\n";
  os << indent << "TetrahedraAboveMaximumVolume: " << this->TetrahedraAboveMaximumVolume << "\n";
  os << indent << "LargestRadiusEdgeRatio: " << this->LargestRadiusEdgeRatio << "\n";
  os << indent << "SmallestVolume: " << this->SmallestVolume << "\n";
  os << indent << "LargestVolume: " << this->LargestVolume << "\n";
  os << indent << "TetGenCalls: " << this->TetGenCalls << "\n";
}
