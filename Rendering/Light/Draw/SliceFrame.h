#ifndef interlume_SliceFrame_h
#define interlume_SliceFrame_h

#include "Common/Vectors.h"
#include "Lights/LightSource.h"
#include "Plan/ClipRegion.h"
#include "Plan/SlicePlan.h"
#include "Space/UnitSpace.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   SliceFrame
 * @brief   all that a picture of slices is made of
 */
struct SliceFrame
{
  VolumeSamples Samples;
  VolumeBlocks Blocks;
  MaterialTable Material;
  UnitSpace Space;
  SlicePlan::Eye Eye;
  SlicePlan Plan;
  std::vector<LightSource> Lights;

  /// Columns and rows.
  std::array<int, 2> Size{ { 0, 0 } };

  ClipRegion Matter;

  bool IsShaded = false;
  /// See vtkShadowedSliceMapper.
  double SurfaceGradient = 0.0;
  /// Ambient, diffuse, specular, specular power of each row.
  std::array<std::array<float, 4>, 4> Materials{};
  glm::dvec3 Ambient{ 1.0, 1.0, 1.0 };
  /// Of the image, for the magnitude of gradients as the property's functions have it.
  glm::dvec3 Spacing{ 1.0, 1.0, 1.0 };
  /// Unit distance of each row, in world units.
  std::array<double, 4> UnitDistances{ { 1.0, 1.0, 1.0, 1.0 } };

  /// The near plane as a half space in unit space, where it cuts the volume.
  bool IsCutByNearPlane = false;
  std::array<double, 4> NearPlane{};

  bool IsSmoothLookup = true;
  bool MayBeOccluded = false;

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
  /// Channels of light that matter takes from: three where it has a colour for light that passes.
  int GetLightChannels() const { return this->Material.Transmission.empty() ? 1 : 3; }
  /// Whether lights change the colour at all.
  bool IsLit() const { return this->IsShaded || this->HasShadows(); }
};

}

#endif
