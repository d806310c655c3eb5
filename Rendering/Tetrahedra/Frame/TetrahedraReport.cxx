// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetrahedraReport.h"

#include "Common/NamedValue.h"

void vtkTetrahedraReport::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "RenderPath: " << this->RenderPath << " (" << this->PathReason << ")\n";
  os << indent << "SilhouetteShader: " << this->SilhouetteShader << " (" << this->ShaderReason
     << ")\n";
  os << indent << "BlendMode: " << this->BlendMode << " (" << this->BlendReason << ")\n";
  os << indent << "SortMode: " << this->SortMode << " (" << this->SortReason << ")\n";
  interlume::NamedValue::Print(os, indent,
    { { "Features", this->Features }, { "Tetrahedra", this->Tetrahedra },
      { "TetrahedraDrawn", this->TetrahedraDrawn },
      { "TetrahedraClipped", this->TetrahedraClipped }, { "FlatTetrahedra", this->FlatTetrahedra },
      { "NonFiniteTetrahedra", this->NonFiniteTetrahedra },
      { "BoundaryTriangles", this->BoundaryTriangles },
      { "UnmatchedTriangles", this->UnmatchedTriangles }, { "ValuesTaken", this->ValuesTaken },
      { "MeshMade", this->MeshMade }, { "Processes", this->Processes }, { "Passes", this->Passes },
      { "Layers", this->Layers }, { "Cycles", this->Cycles }, { "Gaps", this->Gaps },
      { "Sorted", this->Sorted }, { "HasAdjacency", this->HasAdjacency },
      { "UploadedStaticBytes", this->UploadedStaticBytes },
      { "UploadedOrderBytes", this->UploadedOrderBytes },
      { "UploadedImageBytes", this->UploadedImageBytes }, { "Buffers", this->Buffers },
      { "BufferBytes", this->BufferBytes }, { "MemoryBytes", this->MemoryBytes },
      { "PixelStride", this->PixelStride }, { "TetrahedronStride", this->TetrahedronStride },
      { "ControlPoints", this->ControlPoints }, { "Seconds", this->Seconds } });
}
