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
  /// Depth of the surfaces behind the slices that the camera sees: a texture (null if there are no
  /// surfaces), and its values in row-major order from the bottom row. These are opaque surfaces or
  /// a translucent layer.
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
  /// Transmittance of translucent surfaces along the light rays.
  const TranslucentShadowMaps* TranslucentMaps = nullptr;

  /// Transmittance of volumes from each light to the surfaces that the camera sees. Each volume
  /// multiplies the transmittance of its slices into it.
  LightTransmittance* Transmittance = nullptr;
  /// Light from multiple scattering in volumes. Each volume adds an element.
  std::vector<ScatteredLightTexture> Fields;
  vtkIdType PixelsInFront = 0;
  vtkIdType PixelsInside = 0;
  vtkIdType PixelsBehind = 0;
  int ReceiverPasses = 0;
};

}

#endif
