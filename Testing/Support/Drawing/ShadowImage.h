// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowImage_h
#define ShadowImage_h

#include "Support/Images/RgbaImage.h"
#include "Support/Images/ShadowScene.h"

class vtkShadowedSliceMapper;

namespace reference
{

class VolumeStage;

/// Applies the image, array, shadow, transmission, cropping and clipping settings of a scene to a
/// mapper.
void Configure(vtkShadowedSliceMapper* mapper, const ShadowScene& scene);

/// Configures the mapper and adds the scene to the stage.
void SetScene(VolumeStage& stage, vtkShadowedSliceMapper* mapper, const ShadowScene& scene);

/// Configures the mapper and returns a floating-point rendering of the scene.
RgbaImage DrawByMapper(vtkShadowedSliceMapper* mapper, const ShadowScene& scene);

}

#endif
