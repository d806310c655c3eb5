// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeRenderState_h
#define interlume_VolumeRenderState_h

#include "Common/Vectors.h"
#include "Plan/ClipRegion.h"
#include "Shaders/ImageState.h"
#include "Shaders/SliceScattering.h"
#include "Space/UnitSpace.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"

#include <array>

class vtkSliceMedium;

namespace interlume
{

/**
 * @class   VolumeRenderState
 * @brief   everything needed to render one volume of an image
 */
struct VolumeRenderState
{
  VolumeSamples Samples;
  VolumeBlocks Blocks;
  /// Blocks of tiles; empty unless OpenGL is software.
  VolumeBlocks SmallBlocks;
  MaterialTable Material;
  UnitSpace Space;
  ClipRegion Region;

  /// The medium that replaces samples and material; null if these are used. They then only tell
  /// where the medium is.
  vtkSliceMedium* Medium = nullptr;

  bool IsSoftware = false;
  /// See OccupancyEstimate.
  double OccupiedFraction = 1.0;

  bool IsShaded = false;
  /// The settings of these names of vtkShadowedSliceMapper.
  double SurfaceGradient = 0.0;
  bool TwoSidedLighting = false;
  /// The ambient, diffuse and specular coefficients and the specular power of each row.
  std::array<std::array<float, 4>, 4> Materials{};
  /// The factors by which half a difference along each axis of the image becomes a component of the
  /// gradient that the property's functions are given for.
  glm::dvec3 GradientSteps{ 1.0, 1.0, 1.0 };
  /// Unit distance of each row, in world units.
  std::array<double, 4> UnitDistances{ { 1.0, 1.0, 1.0, 1.0 } };

  /// How light is scattered; if it is, the colors of the material are its albedo.
  SliceScattering Scattering;

  /// The image and the index of the volume in it.
  const ImageState* Image = nullptr;
  int Number = 0;

  /// Returns whether slices are drawn in tiles if the view permits: a graphics card does not need
  /// them, and a medium of its own has no small blocks.
  bool HasTiles() const { return this->SmallBlocks.GetNumberOfBlocks() > 0 && !this->Medium; }
  /// Returns whether lights change the color at all.
  bool IsLit() const
  {
    return this->IsShaded || this->Image->HasShadows() || this->Scattering.IsOn();
  }
};

}

#endif
