// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceScene_h
#define interlume_SliceScene_h

#include "Receivers/ScatteredLightTexture.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkProp;
class vtkTextureObject;

namespace interlume
{

class LightTransmittance;
class TranslucentShadowMaps;
class SceneOccluders;

/**
 * @class   SliceScene
 * @brief   input and output of sliced volumes in a scene
 */
struct SliceScene
{
  /// Depth of the surfaces that the camera sees behind the slices: a texture (null if there are no
  /// surfaces), and its values row by row from the bottom. These are opaque surfaces or a
  /// translucent layer.
  vtkTextureObject* CameraDepth = nullptr;
  std::vector<float> CameraDepths;
  std::array<int, 2> Size{ { 0, 0 } };
  /// Depth of the translucent surfaces in front of the slices. Null if the slices start at the
  /// camera.
  vtkTextureObject* FrontDepth = nullptr;
  /// Shows one image for all volumes. If empty, each volume shows its own image.
  std::function<void()> Show;

  /// Shadow maps of the lights.
  const SceneOccluders* Occluders = nullptr;
  /// Opaque props in the shadow maps.
  std::vector<vtkProp*> Blockers;
  /// Transmittance of translucent surfaces for the lights.
  const TranslucentShadowMaps* TranslucentMaps = nullptr;

  /// Transmittance of volumes for the lights, at the surfaces that the camera sees. The
  /// transmittance of the slices is multiplied into it.
  LightTransmittance* Transmittance = nullptr;
  /// Multiply scattered light of volumes. Each volume adds its own.
  std::vector<ScatteredLightTexture> Fields;
  vtkIdType PixelsInFront = 0;
  vtkIdType PixelsInside = 0;
  vtkIdType PixelsBehind = 0;
  int ReceiverPasses = 0;
};

}

#endif
