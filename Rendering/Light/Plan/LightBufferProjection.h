// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightBufferProjection_h
#define interlume_LightBufferProjection_h

#include "Common/Vectors.h"
#include "Plan/SlicePlan.h"
#include "Space/BoxCorners.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   LightBufferProjection
 * @brief   size and projection of a light buffer
 *
 * A planar buffer covers a rectangle around the projected boxes of all volumes: the smallest one
 * with an edge parallel to a projected box edge. A border of Border texels lets interpolation at
 * the edge read valid texels. For a projective light, the buffer covers the part of the light's
 * screen in front of the boxes instead if that part is smaller. The buffer of a wide light is the
 * octahedral map of a half space.
 */
class LightBufferProjection
{
public:
  /// Width of the border on each side, in texels.
  static constexpr int Border = 2;
  /// Minimum distance at which a positional light is treated as directional. At this distance,
  /// single precision cannot represent the difference between the ray directions.
  static constexpr double FarDistance = 1e8;
  /// Maximum number of texels per voxel in an automatic buffer. More than one is used only if the
  /// frame has at least two pixels per texel, for lights with sample layers, or one pixel per
  /// texel, for lights in a dense medium.
  static constexpr double LargestFineness = 1.5;

  LightBufferProjection(const BoxCorners& corners,
    const std::vector<SlicePlan::SlicedVolume>& volumes, const SlicePlan::Settings& settings);

  /// Fits a planar buffer around the boxes.
  void FitPlanarBuffer(const LightSource& source, SlicePlan::ShadowedLight& light) const;
  /// Plans the soft shadows of an area light with the method in the settings. Call FitPlane first.
  /// Returns false and leaves the shadows hard if slices perpendicular to \a normal are seen
  /// edge-on from part of the emitter.
  bool PlanSoftShadows(
    const LightSource& source, const glm::dvec3& normal, SlicePlan::ShadowedLight& light) const;
  /// Increases the resolution of an automatic buffer after FitPlane, for media whose opacity ramps
  /// are no wider than a texel.
  void Refine(const LightSource& source, SlicePlan::ShadowedLight& light) const;
  /// Fits the buffer of a wide light at \a position to the half space that \a normal points into.
  void FitHalfSpaceBuffer(
    const glm::dvec3& normal, const glm::dvec3& position, SlicePlan::ShadowedLight& light) const;

private:
  /// A rectangle in a plane, and the axes of the plane. In perspective, coordinates in the plane
  /// are tangents of angles relative to Axis.
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
  Window FitWindowToBoxes(const LightSource& source) const;
  bool FitWindowToScreen(const LightSource& source, Window& window) const;
  int GetSize(double texels, int smallest) const;
  /// Fits a planar buffer. An automatic buffer has \a fineness texels per voxel and a size of at
  /// least \a smallest.
  void FitPlanarBuffer(const LightSource& source, SlicePlan::ShadowedLight& light, double fineness,
    int smallest) const;
  /// Returns the minimum length of a voxel along \a direction over all volumes. \a extent is the
  /// extent of the buffer. If it is not 0, volume axes are ignored along which the entire volume is
  /// thinner than one texel of the largest automatic buffer. Without this rule, extremely flat
  /// voxels would require the largest buffer and still not be resolved.
  double GetVoxelSpacing(const glm::dvec3& direction, double extent) const;

  const BoxCorners& Corners;
  const std::vector<SlicePlan::SlicedVolume>& Volumes;
  const SlicePlan::Settings& Settings;
  const glm::dvec3 Center;
};

}

#endif
