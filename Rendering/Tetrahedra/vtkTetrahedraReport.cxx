// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetrahedraReport.h"

void vtkTetrahedraReport::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "RenderPath: " << this->RenderPath << " (" << this->PathReason << ")\n";
  os << indent << "BlendMode: " << this->BlendMode << " (" << this->BlendReason << ")\n";
  os << indent << "SortMode: " << this->SortMode << " (" << this->SortReason << ")\n";
  os << indent << "Features: " << this->Features << "\n";
  os << indent << "Tetrahedra: " << this->Tetrahedra << "\n";
  os << indent << "TetrahedraDrawn: " << this->TetrahedraDrawn << "\n";
  os << indent << "TetrahedraClipped: " << this->TetrahedraClipped << "\n";
  os << indent << "FlatTetrahedra: " << this->FlatTetrahedra << "\n";
  os << indent << "NonFiniteTetrahedra: " << this->NonFiniteTetrahedra << "\n";
  os << indent << "BoundaryTriangles: " << this->BoundaryTriangles << "\n";
  os << indent << "UnmatchedTriangles: " << this->UnmatchedTriangles << "\n";
  os << indent << "Passes: " << this->Passes << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Cycles: " << this->Cycles << "\n";
  os << indent << "Gaps: " << this->Gaps << "\n";
  os << indent << "Sorted: " << this->Sorted << "\n";
  os << indent << "HasAdjacency: " << this->HasAdjacency << "\n";
  os << indent << "UploadedStaticBytes: " << this->UploadedStaticBytes << "\n";
  os << indent << "UploadedOrderBytes: " << this->UploadedOrderBytes << "\n";
  os << indent << "UploadedImageBytes: " << this->UploadedImageBytes << "\n";
  os << indent << "Buffers: " << this->Buffers << "\n";
  os << indent << "BufferBytes: " << this->BufferBytes << "\n";
  os << indent << "MemoryBytes: " << this->MemoryBytes << "\n";
  os << indent << "PixelStride: " << this->PixelStride << "\n";
  os << indent << "TetrahedronStride: " << this->TetrahedronStride << "\n";
  os << indent << "ControlPoints: " << this->ControlPoints << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
}
