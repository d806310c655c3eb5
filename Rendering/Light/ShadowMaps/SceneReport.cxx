// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/SceneReport.h"

#include "Common/ReportValue.h"

namespace interlume
{

void SceneReport::CopyTo(vtkInterlumeReport* report) const
{
  ReportValue::Set(report,
    { { "ShadowCasters", this->ShadowCasters }, { "Lights", this->Lights },
      { "Volumes", this->Volumes }, { "NonCastingActors", this->NonCastingActors },
      { "NonReceivingActors", this->NonReceivingActors },
      { "VolumesInSharedSlices", this->VolumesInSharedSlices },
      { "SeparateVolumesReason", this->SeparateVolumesReason },
      { "ScatteringReceivers", this->ScatteringReceivers },
      { "ScatteringBlockedCells", this->ScatteringBlockedCells },
      { "SeparateScatteringVolumes", this->SeparateScatteringVolumes }, { "Images", this->Images },
      { "DepthMaps", this->DepthMaps }, { "DepthMapsDrawn", this->DepthMapsDrawn },
      { "DepthMapResolution", this->DepthMapResolution }, { "AreaLights", this->AreaLights },
      { "SampleMaps", this->SampleMaps }, { "SampleMapsDrawn", this->SampleMapsDrawn },
      { "SampleMapResolution", this->SampleMapResolution },
      { "CameraDepthPasses", this->CameraDepthPasses },
      { "PixelsInFrontOfVolumes", this->PixelsInFrontOfVolumes },
      { "PixelsInsideVolumes", this->PixelsInsideVolumes },
      { "PixelsBehindVolumes", this->PixelsBehindVolumes },
      { "ReceiverPasses", this->ReceiverPasses }, { "TranslucentActors", this->TranslucentActors },
      { "LightLayers", this->LightLayers }, { "CameraLayers", this->CameraLayers },
      { "SlicedSegments", this->SlicedSegments }, { "LightLayerBytes", this->LightLayerBytes },
      { "CameraLayerBytes", this->CameraLayerBytes }, { "DepthMapBytes", this->DepthMapBytes },
      { "SampleMapBytes", this->SampleMapBytes }, { "CameraDepthBytes", this->CameraDepthBytes },
      { "TransmittanceBytes", this->TransmittanceBytes } });
}

}
