#ifndef vtkSlicePicture_h
#define vtkSlicePicture_h

#include "vtkLightSource.h"
#include "vtkMaterialTable.h"
#include "vtkSliceMatter.h"
#include "vtkSlicePlan.h"
#include "vtkUnitSpace.h"
#include "vtkVolumeBlocks.h"
#include "vtkVolumeSamples.h"

#include <array>
#include <vector>

/**
 * @class   vtkSlicePicture
 * @brief   all that a picture of slices is made of
 */
struct vtkSlicePicture
{
  vtkVolumeSamples Samples;
  vtkVolumeBlocks Blocks;
  vtkMaterialTable Material;
  vtkUnitSpace Space;
  vtkSlicePlan::Eye Eye;
  vtkSlicePlan Plan;
  std::vector<vtkLightSource> Lights;

  /// Columns and rows.
  std::array<int, 2> Size{ { 0, 0 } };

  vtkSliceMatter Matter;

  bool IsShaded = false;
  /// See vtkShadowedSliceMapper.
  double SurfaceGradient = 0.0;
  /// Ambient, diffuse, specular, specular power of each row.
  std::array<std::array<float, 4>, 4> Materials{};
  std::array<double, 3> Ambient{ { 1.0, 1.0, 1.0 } };
  /// Of the image, for the magnitude of gradients as the property's functions have it.
  std::array<double, 3> Spacing{ { 1.0, 1.0, 1.0 } };
  /// Unit distance of each row, in world units.
  std::array<double, 4> UnitDistances{ { 1.0, 1.0, 1.0, 1.0 } };

  /// The near plane as a half space in unit space, where it cuts the volume.
  bool IsCutByNearPlane = false;
  std::array<double, 4> NearPlane{};

  bool IsSmoothLookup = true;
  bool MayBeOccluded = false;

  bool HasShadows() const
  {
    for (const vtkSlicePlan::Sweep& sweep : this->Plan.Sweeps)
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

#endif
