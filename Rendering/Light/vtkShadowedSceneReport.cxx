// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedSceneReport.h"

void vtkShadowedSceneReport::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "Casters: " << this->Casters << "\n";
  os << indent << "Lights: " << this->Lights << "\n";
  os << indent << "Volumes: " << this->Volumes << "\n";
  os << indent << "NotCasting: " << this->NotCasting << "\n";
  os << indent << "NotReceiving: " << this->NotReceiving << "\n";
  os << indent << "VolumesTogether: " << this->VolumesTogether << "\n";
  os << indent << "VolumesApart: " << this->VolumesApart << "\n";
  os << indent << "ScatteringReceivers: " << this->ScatteringReceivers << "\n";
  os << indent << "ScatteringBlockedCells: " << this->ScatteringBlockedCells << "\n";
  os << indent << "ScatteringVolumesApart: " << this->ScatteringVolumesApart << "\n";
  os << indent << "Images: " << this->Images << "\n";
  os << indent << "DepthMaps: " << this->DepthMaps << "\n";
  os << indent << "DepthMapsDrawn: " << this->DepthMapsDrawn << "\n";
  os << indent << "DepthMapResolution: " << this->DepthMapResolution << "\n";
  os << indent << "AreaLights: " << this->AreaLights << "\n";
  os << indent << "SampleMaps: " << this->SampleMaps << "\n";
  os << indent << "SampleMapsDrawn: " << this->SampleMapsDrawn << "\n";
  os << indent << "SampleMapResolution: " << this->SampleMapResolution << "\n";
  os << indent << "EyeDepthPasses: " << this->EyeDepthPasses << "\n";
  os << indent << "PixelsBefore: " << this->PixelsBefore << "\n";
  os << indent << "PixelsWithin: " << this->PixelsWithin << "\n";
  os << indent << "PixelsBehind: " << this->PixelsBehind << "\n";
  os << indent << "ReceiverPasses: " << this->ReceiverPasses << "\n";
  os << indent << "TranslucentActors: " << this->TranslucentActors << "\n";
  os << indent << "LightLayers: " << this->LightLayers << "\n";
  os << indent << "EyeLayers: " << this->EyeLayers << "\n";
  os << indent << "SlicedSegments: " << this->SlicedSegments << "\n";
  os << indent << "LightLayerBytes: " << this->LightLayerBytes << "\n";
  os << indent << "EyeLayerBytes: " << this->EyeLayerBytes << "\n";
  os << indent << "DepthMapBytes: " << this->DepthMapBytes << "\n";
  os << indent << "SampleMapBytes: " << this->SampleMapBytes << "\n";
  os << indent << "EyeDepthBytes: " << this->EyeDepthBytes << "\n";
  os << indent << "TransmittanceBytes: " << this->TransmittanceBytes << "\n";
}
