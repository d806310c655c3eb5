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
 * @brief   the complete state for rendering one volume of an image
 */
struct VolumeRenderState
{
  VolumeSamples Samples;
  VolumeBlocks Blocks;
  /// Small blocks for drawing in tiles; empty unless OpenGL runs in software.
  VolumeBlocks SmallBlocks;
  MaterialTable Material;
  UnitSpace Space;
  ClipRegion Region;

  /// Custom medium that replaces samples and material, or null. Samples and material then only
  /// determine which blocks are visible.
  vtkSliceMedium* Medium = nullptr;

  bool IsSoftware = false;
  /// If true, a texture contains the differences between the neighbors of each voxel.
  bool HasDifferences = false;
  /// See OccupancyEstimate.
  double OccupiedFraction = 1.0;

  bool IsShaded = false;
  /// Settings of vtkShadowedSliceMapper.
  double SurfaceGradient = 0.0;
  bool TwoSidedLighting = false;
  /// Ambient, diffuse and specular coefficients and specular power, for each row.
  std::array<std::array<float, 4>, 4> Materials{};
  /// For each axis of the image, the factor that converts half the difference between the two
  /// neighboring samples into a gradient component, in the units of the gradient opacity function.
  glm::dvec3 GradientSteps{ 1.0, 1.0, 1.0 };
  /// Scalar opacity unit distance of each row, in world units.
  std::array<double, 4> UnitDistances{ { 1.0, 1.0, 1.0, 1.0 } };

  /// Scattering settings and results. If scattering is on, the material's colors are the albedo.
  SliceScattering Scattering;

  /// The image, and the index of the volume in it.
  const ImageState* Image = nullptr;
  int Number = 0;

  /// Returns true if slices can be drawn in tiles. Graphics cards do not need tiles, and a custom
  /// medium has no small blocks.
  bool HasTiles() const { return this->SmallBlocks.GetNumberOfBlocks() > 0 && !this->Medium; }
  /// Returns true if the color depends on lights.
  bool IsLit() const
  {
    return this->IsShaded || this->Image->HasShadows() || this->Scattering.IsOn();
  }
};

}

#endif
