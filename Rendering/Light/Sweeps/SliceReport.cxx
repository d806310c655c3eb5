// SPDX-License-Identifier: BSD-3-Clause
#include "Sweeps/SliceReport.h"

#include "Common/ReportValue.h"

namespace interlume
{

void SliceReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
    { { "Lights", this->Lights }, { "ShadowedLights", this->ShadowedLights },
      { "Sweeps", this->Sweeps }, { "FrontToBackSweeps", this->FrontToBackSweeps },
      { "Slices", this->Slices }, { "SlicesDrawn", this->SlicesDrawn },
      { "SliceSpacing", this->SliceSpacing }, { "ImagePasses", this->ImagePasses },
      { "LightPasses", this->LightPasses }, { "OcclusionPasses", this->OcclusionPasses },
      { "ImageBuffers", this->ImageBuffers }, { "ImageBufferBytes", this->ImageBufferBytes },
      { "LightBuffers", this->LightBuffers }, { "LightBufferBytes", this->LightBufferBytes },
      { "LightBufferSize", this->LightBufferSize }, { "LightChannels", this->LightChannels },
      { "SoftShadowLights", this->SoftShadowLights },
      { "SoftShadowMethod", this->SoftShadowMethod },
      { "AreaLightsWithHardShadows", this->AreaLightsWithHardShadows },
      { "LightLayers", this->LightLayers }, { "SampledLights", this->SampledLights },
      { "SoftShadowPasses", this->SoftShadowPasses }, { "SoftShadowBytes", this->SoftShadowBytes },
      { "ScatteringCells", this->ScatteringCells },
      { "ScatteringBlockedCells", this->ScatteringBlockedCells },
      { "ScatteringBytes", this->ScatteringBytes }, { "ScatteringSolves", this->ScatteringSolves },
      { "ScatteringSeconds", this->ScatteringSeconds }, { "Features", this->Features },
      { "Blocks", this->Blocks }, { "BlocksDrawn", this->BlocksDrawn },
      { "NonFiniteVoxels", this->NonFiniteVoxels }, { "TextureBytes", this->TextureBytes },
      { "UploadedBytes", this->UploadedBytes }, { "TriangleBytes", this->TriangleBytes },
      { "ImageSampleDistance", this->ImageSampleDistance }, { "Seconds", this->Seconds } });
}

}
