// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitFlowVolumeReport.h"

#include "Common/NamedValue.h"

void vtkImplicitFlowVolumeReport::Print(ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Surfaces", this->Surfaces }, { "SurfacesWithoutTexture", this->SurfacesWithoutTexture },
      { "UniformCells", this->UniformCells }, { "SplitCells", this->SplitCells },
      { "EmptyCells", this->EmptyCells }, { "NonFiniteSamples", this->NonFiniteSamples },
      { "Features", this->Features }, { "GridUploads", this->GridUploads },
      { "InflowUploads", this->InflowUploads }, { "DetailUploads", this->DetailUploads },
      { "GateUploads", this->GateUploads }, { "TransferUploads", this->TransferUploads },
      { "ArrayUploads", this->ArrayUploads }, { "UploadedBytes", this->UploadedBytes },
      { "Textures", this->Textures }, { "TextureBytes", this->TextureBytes },
      { "ImageBufferBytes", this->ImageBufferBytes }, { "Passes", this->Passes },
      { "ShadowedLights", this->ShadowedLights }, { "Sweeps", this->Sweeps },
      { "Slices", this->Slices }, { "SliceSpacing", this->SliceSpacing },
      { "LightBuffers", this->LightBuffers }, { "LightBufferSize", this->LightBufferSize },
      { "LightBufferBytes", this->LightBufferBytes }, { "SampleDistance", this->SampleDistance },
      { "ImageSampleDistance", this->ImageSampleDistance }, { "Seconds", this->Seconds } });
}
