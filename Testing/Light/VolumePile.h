// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumePile_h
#define VolumePile_h

#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkNew.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <vector>

namespace reference
{

/**
 * @class   VolumePile
 * @brief   a window out of sight with the volumes and surfaces of a scene, drawn by
 * vtkShadowedScenePass
 */
class VolumePile
{
public:
  /// Adds the scene's volumes in their order, or in the opposite one.
  explicit VolumePile(const MixedScene& scene, bool isReversed = false);
  ~VolumePile();

  RgbaPicture Draw() { return this->Stage.Capture(); }
  vtkInterlumeReport* GetReport() const { return this->Pass->GetReport(); }

  VolumeStage Stage;
  vtkNew<vtkShadowedScenePass> Pass;
  /// In the order of the scene's volumes.
  std::vector<vtkSmartPointer<vtkShadowedSliceMapper>> Mappers;
  std::vector<vtkSmartPointer<vtkVolume>> Volumes;
};

}

#endif
