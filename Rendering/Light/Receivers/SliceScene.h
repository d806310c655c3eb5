// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceScene_h
#define interlume_SliceScene_h

#include "Receivers/ScatteredField.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkProp;
class vtkTextureObject;

namespace interlume
{

class LightTransmittance;
class PaneMaps;
class SceneCasters;

/**
 * @class   SliceScene
 * @brief   what a picture of slices takes from the scene around, and gives to it
 */
struct SliceScene
{
  /// The depth of the opaque surfaces that the eye sees: a texture, null for no surface, and its
  /// values row by row from below.
  vtkTextureObject* EyeDepth = nullptr;
  std::vector<float> EyeDepths;
  std::array<int, 2> Size{ { 0, 0 } };
  /// The depth of the translucent surfaces before which the picture shows nothing; null where it
  /// begins at the eye.
  vtkTextureObject* FrontDepth = nullptr;
  /// Shows the picture in the place of all volumes; they show their own where it is empty.
  std::function<void()> Show;

  /// The depth maps of lights.
  const SceneCasters* Casters = nullptr;
  /// The opaque props that these are of.
  std::vector<vtkProp*> Blockers;
  /// What translucent surfaces leave of the lights.
  const PaneMaps* Panes = nullptr;

  /// What is left of the lights at the eye's surfaces, which the slices multiply.
  LightTransmittance* Transmittance = nullptr;
  /// The light that volumes have scattered on and on; they add theirs.
  std::vector<ScatteredField> Fields;
  vtkIdType PixelsBefore = 0;
  vtkIdType PixelsWithin = 0;
  vtkIdType PixelsBehind = 0;
  int ReceiverPasses = 0;
};

}

#endif
