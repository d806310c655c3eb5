// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceFrame_h
#define interlume_SliceFrame_h

#include "Common/Vectors.h"
#include "Draw/SliceScattering.h"
#include "Lights/LightSource.h"
#include "Plan/ClipRegion.h"
#include "Plan/SlicePlan.h"
#include "Space/UnitSpace.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"

#include <array>
#include <vector>

class vtkSliceMatter;

namespace interlume
{

struct SliceScene;

/**
 * @class   SliceFrame
 * @brief   all that a volume's picture of slices is made of
 */
struct SliceFrame
{
  VolumeSamples Samples;
  VolumeBlocks Blocks;
  /// Where OpenGL is software, for tiles; else there are none.
  VolumeBlocks SmallBlocks;
  MaterialTable Material;
  UnitSpace Space;
  SlicePlan::Eye Eye;
  SlicePlan Plan;
  std::vector<LightSource> Lights;

  /// The columns and rows of the picture.
  std::array<int, 2> Size{ { 0, 0 } };

  ClipRegion Region;

  /// What the matter is looked up by, and samples and material only where there is any; null for
  /// these themselves.
  vtkSliceMatter* Matter = nullptr;

  /// Whether OpenGL is software, and the share of what is drawn that has matter; see MatterShare.
  bool IsSoftware = false;
  double ShareOfMatter = 1.0;

  bool IsShaded = false;
  /// The settings of these names of vtkShadowedSliceMapper.
  double SurfaceGradient = 0.0;
  bool TwoSidedLighting = false;
  /// The ambient, diffuse and specular coefficients and the specular power of each row.
  std::array<std::array<float, 4>, 4> Materials{};
  glm::dvec3 Ambient{ 1.0, 1.0, 1.0 };
  /// The factors by which half a difference along each axis of the image becomes a component of the
  /// gradient that the property's functions are given for.
  glm::dvec3 GradientSteps{ 1.0, 1.0, 1.0 };
  /// Unit distance of each row, in world units.
  std::array<double, 4> UnitDistances{ { 1.0, 1.0, 1.0, 1.0 } };

  /// A plane of the camera: whether it cuts the volume, and the half space that it leaves, in unit
  /// space.
  struct ViewPlane
  {
    bool IsCutting = false;
    std::array<double, 4> Plane{};
  };
  ViewPlane NearPlane;
  ViewPlane FarPlane;

  /// How light is scattered; the colours of the material are its albedo then.
  SliceScattering Scattering;

  bool IsSmoothLookup = true;
  bool MayBeOccluded = false;

  /// Which of the volumes that share the picture's slices this is, and whether light has colours
  /// inside another one. Plan, lights, eye and size are the same for all of them.
  int Number = 0;
  bool HasColoredLight = false;

  /// The scene that the picture is part of; null for a picture by itself.
  SliceScene* Scene = nullptr;

  bool HasShadows() const
  {
    for (const SlicePlan::Sweep& sweep : this->Plan.Sweeps)
    {
      if (!sweep.Lights.empty())
      {
        return true;
      }
    }
    return false;
  }
  /// Returns the number of channels of light that matter takes from: three where it has a colour
  /// for light that passes.
  int GetLightChannels() const
  {
    return this->HasColoredLight || !this->Material.Transmission.empty() ? 3 : 1;
  }
  /// Returns whether slices are drawn in tiles where the view lets them: a graphics card has no use
  /// for them, and what is a function has no small blocks.
  bool HasTiles() const { return this->SmallBlocks.GetNumberOfBlocks() > 0 && !this->Matter; }
  /// Returns whether lights change the colour at all.
  bool IsLit() const { return this->IsShaded || this->HasShadows() || this->Scattering.IsOn(); }
};

}

#endif
