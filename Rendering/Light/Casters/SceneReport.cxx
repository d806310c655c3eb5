// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedSceneReport.h"

#include "Common/NamedValue.h"

void vtkShadowedSceneReport::Print(ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Casters", this->Casters }, { "Lights", this->Lights }, { "Volumes", this->Volumes },
      { "NotCasting", this->NotCasting }, { "NotReceiving", this->NotReceiving },
      { "VolumesTogether", this->VolumesTogether }, { "VolumesApart", this->VolumesApart },
      { "ScatteringReceivers", this->ScatteringReceivers },
      { "ScatteringBlockedCells", this->ScatteringBlockedCells },
      { "ScatteringVolumesApart", this->ScatteringVolumesApart }, { "Images", this->Images },
      { "DepthMaps", this->DepthMaps }, { "DepthMapsDrawn", this->DepthMapsDrawn },
      { "DepthMapResolution", this->DepthMapResolution }, { "AreaLights", this->AreaLights },
      { "SampleMaps", this->SampleMaps }, { "SampleMapsDrawn", this->SampleMapsDrawn },
      { "SampleMapResolution", this->SampleMapResolution },
      { "EyeDepthPasses", this->EyeDepthPasses }, { "PixelsBefore", this->PixelsBefore },
      { "PixelsWithin", this->PixelsWithin }, { "PixelsBehind", this->PixelsBehind },
      { "ReceiverPasses", this->ReceiverPasses }, { "TranslucentActors", this->TranslucentActors },
      { "LightLayers", this->LightLayers }, { "EyeLayers", this->EyeLayers },
      { "SlicedSegments", this->SlicedSegments }, { "LightLayerBytes", this->LightLayerBytes },
      { "EyeLayerBytes", this->EyeLayerBytes }, { "DepthMapBytes", this->DepthMapBytes },
      { "SampleMapBytes", this->SampleMapBytes }, { "EyeDepthBytes", this->EyeDepthBytes },
      { "TransmittanceBytes", this->TransmittanceBytes } });
}
