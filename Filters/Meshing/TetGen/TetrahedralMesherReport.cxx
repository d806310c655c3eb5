// SPDX-License-Identifier: BSD-3-Clause
#include "TetGen/TetrahedralMesherReport.h"

#include "Common/ReportValue.h"

namespace interlume
{

void TetrahedralMesherReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
    { { "Cells", this->Cells }, { "CellsByTetGen", this->CellsByTetGen },
      { "CellsConed", this->CellsConed }, { "SkippedCells", this->SkippedCells },
      { "UnsupportedCells", this->UnsupportedCells },
      { "SurfaceTriangles", this->SurfaceTriangles }, { "SplitTriangles", this->SplitTriangles },
      { "MergedPoints", this->MergedPoints }, { "FoldedFaces", this->FoldedFaces },
      { "FirstFoldedCell", this->FirstFoldedCell }, { "AddedPoints", this->AddedPoints },
      { "Regions", this->Regions }, { "Tetrahedra", this->Tetrahedra },
      { "TetrahedraAboveQualityBound", this->TetrahedraAboveQualityBound },
      { "TetrahedraAboveMaximumVolume", this->TetrahedraAboveMaximumVolume },
      { "LargestRadiusEdgeRatio", this->LargestRadiusEdgeRatio },
      { "SmallestVolume", this->SmallestVolume }, { "LargestVolume", this->LargestVolume },
      { "TetGenCalls", this->TetGenCalls } });
}

}
