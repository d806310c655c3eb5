// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClipRegion_h
#define interlume_ClipRegion_h

#include "Common/Error.h"
#include "Offscreen/CroppingRegions.h"

#include <array>
#include <vector>

class vtkPlaneCollection;

namespace interlume
{

class UnitSpace;

/**
 * @class   ClipRegion
 * @brief   the region of the volume that remains after cropping and clipping
 */
class ClipRegion
{
public:
  /// Cropping and clipping of a vtkVolumeMapper.
  struct Cuts
  {
    /// Clipping planes in world coordinates, or null.
    vtkPlaneCollection* Planes = nullptr;
    bool IsCropped = false;
    std::array<double, 6> CroppingPlanes{};
    int CroppingFlags = 0;
  };

  /**
   * Sets the region to the box of \a space, reduced by \a cuts. Outer planes of the cropping
   * regions shrink the box if they are perpendicular to its axes; otherwise they become clipping
   * planes. Returns an error if a clipping plane has no normal.
   */
  Error Set(const Cuts& cuts, const UnitSpace& space);

  /// The remaining box, in texture coordinates.
  std::array<std::array<double, 2>, 3> Box{};
  /// The half spaces a x + b y + c z + d >= 0 that contain the region, in unit space.
  std::vector<std::array<double, 4>> ClippingPlanes;
  /// The regions that cropping keeps, contiguous or not, in unit space.
  CroppingRegions Regions;
};

}

#endif
