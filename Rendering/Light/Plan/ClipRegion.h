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
   * The whole box of \a space less what \a croppingPlanes take away, with VTK's region \a flags.
   * The subvolume of an image along the axes becomes a smaller box, all else is for each sample to
   * find out.
   */
  void Crop(vtkImageData* image, bool isOfCells, const UnitSpace& space,
    const std::array<double, 6>& croppingPlanes, int flags);
  /// The whole box.
  void SetWhole(const UnitSpace& space);

  /// Planes in world coordinates, or null. Returns what is wrong, or nothing.
  std::string Clip(vtkPlaneCollection* planes, const UnitSpace& space);

  /// In texture coordinates.
  std::array<std::array<double, 2>, 3> Box{};
  /// Half spaces a x + b y + c z + d >= 0 that are left, in unit space.
  std::vector<std::array<double, 4>> ClippingPlanes;
  /// Regions for each sample to find out, in the volume's own coordinates.
  bool HasCropping = false;
  glm::dvec3 CroppingLower{};
  glm::dvec3 CroppingUpper{};
  int CroppingFlags = 0;
};

}

#endif
