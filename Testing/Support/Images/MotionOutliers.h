// SPDX-License-Identifier: BSD-3-Clause
#ifndef MotionOutliers_h
#define MotionOutliers_h

#include "Support/Images/RgbaImage.h"

#include <vector>

namespace reference
{

/**
 * @class   MotionOutliers
 * @brief   finds outliers among the frames of a uniform motion
 *
 * During a uniform motion, frames change uniformly. A second difference, which is the difference
 * between the value in one frame and the mean of the values in the two neighboring frames, is
 * therefore small. It is computed for two values: the mean red value of a frame, and the largest
 * change of a pixel's red value from the previous frame.
 *
 * A second difference is an outlier if it exceeds three times the 95th percentile and is visible,
 * which means above 0.25 % of the mean red value, or above 0.05 for the change of a pixel. A second
 * difference above 1 % of the mean red value is always an outlier.
 */
class MotionOutliers
{
public:
  struct Bend
  {
    /// Largest second difference, its index in the sequence (starting at 0), and the 95th
    /// percentile.
    double Largest = 0.0;
    int At = 0;
    double P95 = 0.0;
    int Outliers = 0;
  };

  /// Adds the next frame, which must have the same size as the previous frames.
  void Add(RgbaImage image);

  /// Returns the mean red value of all frames.
  double GetMean() const;
  Bend GetSecondDifferencesOfMean() const;
  /// Returns the statistics of the largest pixel changes. Index 0 is the change from the first to
  /// the second frame.
  Bend GetSecondDifferencesOfChange() const;

  /// Computes statistics of the second differences of \a numbers. Differences up to \a seen are not
  /// outliers, differences above \a bound are. With \a isAbove, only numbers above the mean of
  /// their neighbors count as outliers.
  static Bend Measure(
    const std::vector<double>& numbers, double seen, double bound, bool isAbove = false);

private:
  RgbaImage Last;
  std::vector<double> Means;
  std::vector<double> Changes;
};

}

#endif
