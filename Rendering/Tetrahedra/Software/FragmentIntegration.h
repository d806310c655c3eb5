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

  /// What is interpolated besides depth.
  struct Channels
  {
    bool HasScalars = false;
    bool HasColors = false;
    bool HasDeltaT = false;
  };

  /**
   * In perspective: divides what is weighted by depth, and makes lengths of differences of depth.
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
   * Extinction of both ends: by the transfer functions, which also tells those that pass a control
   * point; from point colours; one of each tetrahedron.
   */
  static void LookUp(interlume::Fragments& fragments, const PiecewiseLinearTransfer& pieces);
  static void TakeExtinction(interlume::Fragments& fragments);
  static void TakeExtinction(
    interlume::Fragments& fragments, const interlume::Fragments::Color* cells);
  ///@}

  /**
   * Weights and totals. \a isExact: the integral over linear colour and extinction, else their
   * mean.
   */
  static void Integrate(
    interlume::Fragments& fragments, bool hasDeltaT, bool isExact, Results results);

  /**
   * After LookUp() and Integrate(): turns the weights of colours into those of a piece's value and
   * slope, and integrates anew the segments that pass a control point, from one to the next.
   */
  static void FinishPieces(interlume::Fragments& fragments, const PiecewiseLinearTransfer& pieces,
    bool hasDeltaT, bool isExact, Results results);
};

}

#endif
