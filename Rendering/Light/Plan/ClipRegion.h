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
 * @brief   the part of the volume that cropping and clipping planes leave
 */
class ClipRegion
{
public:
  /// Cropping and clipping as a vtkVolumeMapper has them.
  struct Cuts
  {
    /// In world coordinates; null for none.
    vtkPlaneCollection* Planes = nullptr;
    bool IsCropped = false;
    std::array<double, 6> CroppingPlanes{};
    int CroppingFlags = 0;
  };

  /**
   * Takes the whole box of \a space less what \a cuts take away. The half spaces around the regions
   * that cropping keeps make the box smaller where they are along its axes, and are planes
   * elsewhere. Returns an error if a clipping plane has no normal.
   */
  Error Set(const Cuts& cuts, const UnitSpace& space);

  /// The box that is left, in texture coordinates.
  std::array<std::array<double, 2>, 3> Box{};
  /// The half spaces a x + b y + c z + d >= 0 that are left, in unit space.
  std::vector<std::array<double, 4>> ClippingPlanes;
  /// The regions that cropping leaves, with gaps or without, in unit space.
  CroppingRegions Regions;
};

}

#endif
