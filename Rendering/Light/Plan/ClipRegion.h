// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClipRegion_h
#define interlume_ClipRegion_h

#include "Common/Vectors.h"
#include <array>
#include <string>
#include <vector>

class vtkImageData;
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
  /**
   * Takes the whole box of \a space less what \a croppingPlanes take away, with VTK's region \a
   * flags. The subvolume of an image along the axes becomes a smaller box, for other regions each
   * sample is tested by itself.
   */
  void Crop(vtkImageData* image, bool isOfCells, const UnitSpace& space,
    const std::array<double, 6>& croppingPlanes, int flags);
  /// Takes the whole box.
  void SetWhole(const UnitSpace& space);

  /// Adds planes in world coordinates; null for none. Returns what is wrong, or nothing.
  std::string Clip(vtkPlaneCollection* planes, const UnitSpace& space);

  /// The box that is left, in texture coordinates.
  std::array<std::array<double, 2>, 3> Box{};
  /// The half spaces a x + b y + c z + d >= 0 that are left, in unit space.
  std::vector<std::array<double, 4>> ClippingPlanes;
  /// Whether regions are left that each sample is tested for, in the volume's own coordinates.
  bool HasCropping = false;
  glm::dvec3 CroppingLower{};
  glm::dvec3 CroppingUpper{};
  int CroppingFlags = 0;
};

}

#endif
