// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightFit_h
#define interlume_LightFit_h

#include "Common/Vectors.h"
#include "Plan/SlicePlan.h"
#include "Space/BoxCorners.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   LightFit
 * @brief   the buffer of a light: its size, and the place of a point in it
 *
 * A plane's buffer is a rectangle as small as its orientations along the edges of each box let it
 * be around all boxes, with a border of Border texels, so that interpolation at its edge reads what
 * was drawn. That of a projective light is its screen where that is smaller. A wide light's buffer
 * is the octahedral map of a half space.
 */
class LightFit
{
public:
  /// Texels on each side.
  static constexpr int Border = 2;
  /// The distance from which on positional lights are fitted as directional ones: single precision
  /// sees no difference.
  static constexpr double FarDistance = 1e8;
  /// The most texels to a voxel of the automatic buffer of a light with layers, where the picture
  /// has two pixels to a texel, and of a light on dense matter, where it has one. Other lights have
  /// one texel.
  static constexpr double LargestFineness = 1.5;

  LightFit(const BoxCorners& corners, const std::vector<SlicePlan::Matter>& matter,
    const SlicePlan::Settings& settings);

  void FitPlane(const LightSource& source, SlicePlan::ShadowedLight& light) const;
  /// Plans the soft shadows of an area light, by the method of the settings, that FitPlane was
  /// called for. Returns false, and leaves them hard, where slices along \a normal are seen edge-on
  /// from some of the emitter.
  bool Soften(
    const LightSource& source, const glm::dvec3& normal, SlicePlan::ShadowedLight& light) const;
  /// Refines an automatic buffer that FitPlane was called for, for surfaces that are ramps as
  /// narrow as its texels.
  void Refine(const LightSource& source, SlicePlan::ShadowedLight& light) const;
  void FitHalfSpace(
    const glm::dvec3& normal, const glm::dvec3& position, SlicePlan::ShadowedLight& light) const;

private:
  /// A plane's axes and the rectangle in it; places are in tangents for positional lights.
  struct Window
  {
    bool IsPerspective = false;
    glm::dvec3 Origin{ 0.0, 0.0, 0.0 };
    glm::dvec3 Axis{ 0.0, 0.0, 1.0 };
    std::array<glm::dvec3, 2> Across{};
    std::array<std::array<double, 2>, 2> Range{};
  };

  static double GetArea(const Window& window);
  bool Bound(Window& window) const;
  Window FitBox(const LightSource& source) const;
  bool FitScreen(const LightSource& source, Window& window) const;
  int GetSize(double texels, int smallest) const;
  /// Fits a plane's buffer; an automatic one has \a fineness texels to a voxel, and the smallest
  /// number at least.
  void FitPlane(const LightSource& source, SlicePlan::ShadowedLight& light, double fineness,
    int smallest) const;
  /// The shortest of a voxel's length along a direction of all volumes. Where that is for a buffer
  /// of some extent, axes do not count along which all of a volume is within less than a texel of
  /// the largest automatic buffer: voxels a million times as long as thin would ask for that
  /// buffer, and be lost in it.
  double GetVoxelSpacing(const glm::dvec3& direction, double extent) const;

  const BoxCorners& Corners;
  const std::vector<SlicePlan::Matter>& Matter;
  const SlicePlan::Settings& Settings;
  const glm::dvec3 Center;
};

}

#endif
