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
 * @brief   cropping of a vtkVolumeMapper as half spaces and gaps in them
 *
 * The half spaces, up to six, are those around all regions that are kept. They cut exactly, as a
 * smaller box or as clipping planes do. Regions that do not fill them leave gaps, which shaders cut
 * from lines by thresholds and flags (CROPPING in ShaderFeatures).
 */
class INTERLUMESCENE_EXPORT CroppingRegions
{
public:
  using Box = std::array<std::array<double, 2>, 3>;
  using Planes = std::vector<std::array<double, 4>>;
  /// An affine matrix, row by row.
  using Matrix = std::array<double, 16>;

  /// Keeps everything.
  CroppingRegions() = default;
  /**
   * Keeps the regions of the mapper's six planes and flags. \a linesToVolume transforms from the
   * coordinates of lines to the volume's own.
   */
  CroppingRegions(const std::array<double, 6>& planes, int flags, const Matrix& linesToVolume);

  /**
   * Cuts \a box, lower and upper along each axis, with the half spaces. \a boxToVolume transforms
   * from its coordinates to the volume's own. Half spaces that are oblique to the box are appended
   * to \a planes: (a, b, c, d) with a x + b y + c z + d >= 0 in the coordinates of lines.
   */
  void Cut(const Matrix& boxToVolume, Box& box, Planes& planes) const;

  bool HasGaps() const { return this->IsGapped; }
  /// Returns true if the region at a place, in the coordinates of lines, is kept.
  bool IsKept(const std::array<double, 3>& place) const;
  /// Returns all numbers that regions depend on.
  std::vector<double> GetKey() const;
  /// Sets the uniforms of a shader that has CROPPING.
  void SetUniforms(vtkShaderProgram* program) const;

private:
  static constexpr int All = (1 << 27) - 1;

  int Flags = All;
  bool IsGapped = false;
  /// The axes of the volume, of length 1 in the coordinates of lines, and the thresholds there.
  std::array<std::array<double, 3>, 3> Axes{};
  Box Thresholds{};
  /// Bounds of the half spaces in the volume's own coordinates and along the axes; infinite if
  /// there is no bound.
  Box VolumeBounds{};
  Box Bounds{};
};

}

#endif
