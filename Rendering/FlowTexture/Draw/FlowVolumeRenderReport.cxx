// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowVolumeRenderReport.h"

#include "Common/ReportValue.h"

namespace interlume
{

void FlowVolumeRenderReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
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

}
