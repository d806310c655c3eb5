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
 * @brief   the visible regions of a cropped vtkVolumeMapper, as half-spaces and gaps inside them
 *
 * Up to six half-spaces bound all visible regions. They clip the volume exactly, by a smaller box
 * or by clipping planes. Hidden regions within the half-spaces are gaps, which shaders cut out of
 * rays using thresholds and flags (CROPPING in ShaderFeatures).
 */
class INTERLUMESCENE_EXPORT CroppingRegions
{
public:
  using Box = std::array<std::array<double, 2>, 3>;
  using Planes = std::vector<std::array<double, 4>>;
  /// An affine matrix in row-major order.
  using Matrix = std::array<double, 16>;

  /// Crops nothing.
  CroppingRegions() = default;
  /**
   * Retains the regions given by the mapper's six planes and flags. \a linesToVolume transforms ray
   * coordinates, in which positions on view rays are given, to volume coordinates.
   */
  CroppingRegions(const std::array<double, 6>& planes, int flags, const Matrix& linesToVolume);

  /**
   * Clips \a box, given by its lower and upper bound along each axis, to the half-spaces. \a
   * boxToVolume transforms from box coordinates to volume coordinates. Half-spaces oblique to the
   * box are appended to \a planes instead, as (a, b, c, d) with a x + b y + c z + d >= 0 in ray
   * coordinates.
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
  /// Unit vectors along the volume's axes, in ray coordinates, and the cropping thresholds along
  /// them.
  std::array<std::array<double, 3>, 3> Axes{};
  Box Thresholds{};
  /// Bounds of the visible regions along the volume's axes, in volume coordinates and in ray
  /// coordinates; infinite if unbounded.
  Box VolumeBounds{};
  Box Bounds{};
};

}

#endif
