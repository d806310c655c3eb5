// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentIntegration_h
#define interlume_FragmentIntegration_h

#include "Software/Fragments.h"

namespace interlume
{

class PiecewiseLinearTransfer;

/**
 * @class   FragmentIntegration
 * @brief   the mathematics of segments, many at a time
 *
 * InterlumeTetrahedraFS.glsl has the same for a graphics card.
 */
class FragmentIntegration
{
public:
  enum Results
  {
    /// Weights add up to opacity, which is Total.
    OPACITY,
    /// Weights add up to optical depth, which is Total.
    OPTICAL_DEPTH
  };

  /// The channels that are interpolated besides depth.
  struct Channels
  {
    bool HasScalars = false;
    bool HasColors = false;
    bool HasDeltaT = false;
  };

  /**
   * Divides the values that are weighted by depth, and turns differences of depth into lengths, in
   * perspective.
   */
  static void FinishPerspective(interlume::Fragments& fragments, const Channels& channels);

  /**
   * Cuts each segment where an opaque surface is at, given as depth of each pixel; what lies behind
   * has length 0 then.
   */
  static void CutAt(interlume::Fragments& fragments, const Channels& channels, bool isParallel,
    const float* opaque);

  ///@{
  /**
   * Find the extinction of both ends: by the transfer functions, which also finds the segments that
   * pass a control point; from point colours; or one for each tetrahedron.
   */
  static void LookUp(interlume::Fragments& fragments, const PiecewiseLinearTransfer& pieces);
  static void TakeExtinction(interlume::Fragments& fragments);
  static void TakeExtinction(
    interlume::Fragments& fragments, const interlume::Fragments::Color* cells);
  ///@}

  /**
   * Computes weights and totals: the integral over linear colour and extinction if \a isExact, else
   * their mean.
   */
  static void Integrate(
    interlume::Fragments& fragments, bool hasDeltaT, bool isExact, Results results);

  /**
   * Turns the weights of colours, after LookUp() and Integrate(), into those of a piece's value and
   * slope, and integrates anew the segments that pass a control point, from one to the next.
   */
  static void FinishPieces(interlume::Fragments& fragments, const PiecewiseLinearTransfer& pieces,
    bool hasDeltaT, bool isExact, Results results);
};

}

#endif
