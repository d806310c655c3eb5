// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PassTimes_h
#define interlume_PassTimes_h

#include "InterlumeSceneModule.h"

#include <array>

namespace interlume
{

/**
 * @class   PassTimes
 * @brief   chooses the coarseness of an image from the times of previous images
 *
 * Coarseness multiplies the distances between the samples of an image in all three dimensions. The
 * time is expected to be inversely proportional to its cube.
 */
class INTERLUMESCENE_EXPORT PassTimes
{
public:
  /// Returns the coarseness at which an image should take at most the \a allocated time, given the
  /// time and the coarseness of the last image. The maximum is 8.
  static double ChooseCoarseness(double seconds, double lastCoarseness, double allocated);

  /// Returns the time of the final image for a viewport of \a size pixels: the measured time or, if
  /// unknown, \a estimate.
  double GetFinalSeconds(const std::array<int, 2>& size, double estimate);
  /// Returns the result of the last call, or a later measurement.
  double GetFinalSeconds() const { return this->FinalSeconds; }

  /// Returns the coarseness of a pass that may take \a seconds. Call GetFinalSeconds() first.
  double Choose(double seconds) const;

  /// Adds the measured time of a pass.
  void Add(double coarseness, double seconds);

private:
  std::array<int, 2> Size{};
  double FinalSeconds = 0.0;
  bool IsFinalMeasured = false;
  /// Time and coarseness of the last coarse pass; the time is 0 if unknown.
  double CoarseSeconds = 0.0;
  double Coarseness = 1.0;
};

}

#endif
