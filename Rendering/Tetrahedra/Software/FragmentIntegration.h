// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentIntegration_h
#define interlume_FragmentIntegration_h

#include "Software/Fragments.h"

namespace interlume
{

class PiecewiseLinearTransferFunction;

/**
 * @class   FragmentIntegration
 * @brief   integrates many view ray segments at once, with SIMD instructions
 *
 * InterlumeTetrahedraFS.glsl has the same equations for GPUs.
 */
class FragmentIntegration
{
public:
  enum Results
  {
    /// The weights add up to the opacity, which is stored in Total.
    OPACITY,
    /// The weights add up to the optical depth, which is stored in Total.
    OPTICAL_DEPTH
  };

  /// Channels that are interpolated in addition to depth.
  struct Channels
  {
    bool HasScalars = false;
    bool HasColors = false;
    bool HasDeltaT = false;
  };

  /**
   * In perspective, divides depth-weighted values by depth, and converts depth differences to
   * lengths.
   */
  static void ApplyPerspectiveDivision(interlume::Fragments& fragments, const Channels& channels);

  /**
   * Cuts segments at opaque surfaces, given the opaque depth of each pixel. The length of hidden
   * segments becomes 0.
   */
  static void CutAtOpaqueSurfaces(interlume::Fragments& fragments, const Channels& channels,
    bool isParallel, const float* opaque);

  ///@{
  /**
   * Compute the extinction at both ends of each segment. LookUp uses the transfer functions, and
   * finds the segments that cross a control point. SetExtinction uses point colors or one color for
   * each tetrahedron.
   */
  static void LookUpExtinction(
    interlume::Fragments& fragments, const PiecewiseLinearTransferFunction& pieces);
  static void SetExtinction(interlume::Fragments& fragments);
  static void SetExtinction(
    interlume::Fragments& fragments, const interlume::Fragments::Color* cells);
  ///@}

  /**
   * Computes weights and totals, by exact integration of linear color and extinction if \a isExact,
   * otherwise from the means of the values at both ends.
   */
  static void Integrate(
    interlume::Fragments& fragments, bool hasDeltaT, bool isExact, Results results);

  /**
   * Converts the color weights from Integrate() to weights of the value and slope of the transfer
   * function piece that contains the segment. Segments that cross control points are split there
   * and integrated again or, unless \a isExact, averaged.
   */
  static void ConvertToPieceWeights(interlume::Fragments& fragments,
    const PiecewiseLinearTransferFunction& pieces, bool hasDeltaT, bool isExact, Results results);
};

}

#endif
