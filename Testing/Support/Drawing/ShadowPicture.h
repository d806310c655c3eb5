// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowPicture_h
#define ShadowPicture_h

#include "Support/Pictures/RgbaPicture.h"
#include "Support/Pictures/ShadowScene.h"

class vtkRenderWindow;
class vtkShadowedSliceMapper;

namespace reference
{

class VolumeStage;

/// Gives a mapper the image, its array, shadows, transmission, cropping and clipping of a scene.
void Configure(vtkShadowedSliceMapper* mapper, const ShadowScene& scene);

/// Puts the scene with the mapper, configured, on the stage.
void SetScene(VolumeStage& stage, vtkShadowedSliceMapper* mapper, const ShadowScene& scene);

/// The picture by the mapper, configured, in floating point.
RgbaPicture DrawByMapper(vtkShadowedSliceMapper* mapper, const ShadowScene& scene);

/// Renders once; what the window shows, in bytes, alpha 1.
RgbaPicture ReadWindow(vtkRenderWindow* window);

}

#endif
