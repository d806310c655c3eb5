// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/TetrahedraReport.h"

#include "Common/ReportValue.h"

namespace interlume
{

void TetrahedraReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
    { { "RenderPath", this->RenderPath }, { "PathReason", this->PathReason },
      { "SilhouetteShader", this->SilhouetteShader }, { "ShaderReason", this->ShaderReason },
      { "BlendMode", this->BlendMode }, { "BlendReason", this->BlendReason },
      { "SortMode", this->SortMode }, { "SortReason", this->SortReason },
      { "Features", this->Features }, { "Tetrahedra", this->Tetrahedra },
      { "TetrahedraDrawn", this->TetrahedraDrawn },
      { "TetrahedraClipped", this->TetrahedraClipped }, { "FlatTetrahedra", this->FlatTetrahedra },
      { "NonFiniteTetrahedra", this->NonFiniteTetrahedra },
      { "BoundaryTriangles", this->BoundaryTriangles },
      { "UnmatchedTriangles", this->UnmatchedTriangles }, { "ValuesUpdated", this->ValuesUpdated },
      { "MeshRebuilt", this->MeshRebuilt }, { "Processes", this->Processes },
      { "Passes", this->Passes }, { "Layers", this->Layers }, { "Cycles", this->Cycles },
      { "Gaps", this->Gaps }, { "Sorted", this->Sorted }, { "HasAdjacency", this->HasAdjacency },
      { "UploadedStaticBytes", this->UploadedStaticBytes },
      { "UploadedOrderBytes", this->UploadedOrderBytes },
      { "UploadedImageBytes", this->UploadedImageBytes }, { "Buffers", this->Buffers },
      { "BufferBytes", this->BufferBytes }, { "MemoryBytes", this->MemoryBytes },
      { "PixelStride", this->PixelStride }, { "TetrahedronStride", this->TetrahedronStride },
      { "ControlPoints", this->ControlPoints }, { "Seconds", this->Seconds } });
}

}
