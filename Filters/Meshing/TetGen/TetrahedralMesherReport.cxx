// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetrahedralMesherReport.h"

#include "Common/NamedValue.h"

#include <ostream>

void vtkTetrahedralMesherReport::Print(ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Cells", this->Cells }, { "CellsByTetGen", this->CellsByTetGen },
      { "CellsConed", this->CellsConed }, { "CellsLeftOut", this->CellsLeftOut },
      { "UnsupportedCells", this->UnsupportedCells },
      { "SurfaceTriangles", this->SurfaceTriangles }, { "SplitTriangles", this->SplitTriangles },
      { "MergedPoints", this->MergedPoints }, { "AddedPoints", this->AddedPoints },
      { "Regions", this->Regions }, { "Tetrahedra", this->Tetrahedra },
      { "TetrahedraAboveQualityBound", this->TetrahedraAboveQualityBound },
      { "TetrahedraAboveMaximumVolume", this->TetrahedraAboveMaximumVolume },
      { "LargestRadiusEdgeRatio", this->LargestRadiusEdgeRatio },
      { "SmallestVolume", this->SmallestVolume }, { "LargestVolume", this->LargestVolume },
      { "TetGenCalls", this->TetGenCalls } });
}
