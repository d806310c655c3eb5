// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CroppingRegions_h
#define interlume_CroppingRegions_h

#include "InterlumeSceneModule.h"

#include <array>
#include <vector>

class vtkShaderProgram;

namespace interlume
{

/**
 * @class   CroppingRegions
 * @brief   the visible regions of a cropped vtkVolumeMapper, as half spaces and gaps inside them
 *
 * Up to six half spaces bound all visible regions. They cut exactly, like a smaller box or clipping
 * planes. Regions that do not fill the half spaces leave gaps. Shaders remove these gaps from rays
 * with thresholds and flags (CROPPING in ShaderFeatures).
 */
class INTERLUMESCENE_EXPORT CroppingRegions
{
public:
  using Box = std::array<std::array<double, 2>, 3>;
  using Planes = std::vector<std::array<double, 4>>;
  /// An affine matrix, row by row.
  using Matrix = std::array<double, 16>;

  /// Crops nothing.
  CroppingRegions() = default;
  /**
   * Retains the regions given by the mapper's six planes and flags. \a linesToVolume transforms ray
   * coordinates, in which positions on view rays are given, to volume coordinates.
   */
  CroppingRegions(const std::array<double, 6>& planes, int flags, const Matrix& linesToVolume);

  /**
   * Clips \a box, the lower and upper bound along each axis, to the half spaces. \a boxToVolume
   * transforms from box coordinates to volume coordinates. Appends half spaces oblique to the box
   * to \a planes: (a, b, c, d) with a x + b y + c z + d >= 0 in ray coordinates.
   */
  void Cut(const Matrix& boxToVolume, Box& box, Planes& planes) const;

  bool HasGaps() const { return this->IsGapped; }
  /// Returns true if the region at a position in ray coordinates is visible.
  bool IsRetained(const std::array<double, 3>& position) const;
  /// Returns all values that define the regions, for comparison.
  std::vector<double> GetKey() const;
  /// Sets the uniforms of a shader with CROPPING.
  void SetUniforms(vtkShaderProgram* program) const;

private:
  static constexpr int All = (1 << 27) - 1;

  int Flags = All;
  bool IsGapped = false;
  /// Axes of the volume, of length 1 in ray coordinates, and the thresholds along them.
  std::array<std::array<double, 3>, 3> Axes{};
  Box Thresholds{};
  /// Bounds of the half spaces in volume coordinates and along the axes; infinite if unbounded.
  Box VolumeBounds{};
  Box Bounds{};
};

}

#endif
