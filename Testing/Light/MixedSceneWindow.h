// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumePile_h
#define VolumePile_h

#include "Support/Images/MixedScene.h"
#include "Support/Images/VolumeStage.h"

#include "vtkNew.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <vector>

namespace reference
{

/**
 * @class   MixedSceneWindow
 * @brief   an offscreen window with the volumes and surfaces of a scene, drawn by
 *          vtkShadowedScenePass
 */
class MixedSceneWindow
{
public:
  /// Adds the volumes in the order of the scene, or in reverse order.
  explicit MixedSceneWindow(const MixedScene& scene, bool isReversed = false);
  ~MixedSceneWindow();

  RgbaImage Draw() { return this->Stage.Capture(); }
  vtkInterlumeReport* GetReport() const { return this->Pass->GetReport(); }

  VolumeStage Stage;
  vtkNew<vtkShadowedScenePass> Pass;
  /// One mapper per volume, in the order of the scene.
  std::vector<vtkSmartPointer<vtkShadowedSliceMapper>> Mappers;
  std::vector<vtkSmartPointer<vtkVolume>> Volumes;
};

}

#endif
