// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedSliceReport.h"

void vtkShadowedSliceReport::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "Lights: " << this->Lights << "\n";
  os << indent << "ShadowedLights: " << this->ShadowedLights << "\n";
  os << indent << "Sweeps: " << this->Sweeps << "\n";
  os << indent << "FrontToBackSweeps: " << this->FrontToBackSweeps << "\n";
  os << indent << "Slices: " << this->Slices << "\n";
  os << indent << "SlicesDrawn: " << this->SlicesDrawn << "\n";
  os << indent << "SliceSpacing: " << this->SliceSpacing << "\n";
  os << indent << "EyePasses: " << this->EyePasses << "\n";
  os << indent << "LightPasses: " << this->LightPasses << "\n";
  os << indent << "OcclusionPasses: " << this->OcclusionPasses << "\n";
  os << indent << "ImageBuffers: " << this->ImageBuffers << "\n";
  os << indent << "ImageBufferBytes: " << this->ImageBufferBytes << "\n";
  os << indent << "LightBuffers: " << this->LightBuffers << "\n";
  os << indent << "LightBufferBytes: " << this->LightBufferBytes << "\n";
  os << indent << "LightBufferSize: " << this->LightBufferSize << "\n";
  os << indent << "LightChannels: " << this->LightChannels << "\n";
  os << indent << "Features: " << this->Features << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
  os << indent << "BlocksDrawn: " << this->BlocksDrawn << "\n";
  os << indent << "NonFiniteVoxels: " << this->NonFiniteVoxels << "\n";
  os << indent << "TextureBytes: " << this->TextureBytes << "\n";
  os << indent << "UploadedBytes: " << this->UploadedBytes << "\n";
  os << indent << "TriangleBytes: " << this->TriangleBytes << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
}
