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
 * During a uniform motion, frames change uniformly. The difference between a quantity in one frame
 * and its mean in the two neighboring frames, a second difference, is therefore small. The
 * quantities are the mean red value, and the largest change of a pixel's red value from the
 * previous frame.
 *
 * A second difference is an outlier if it exceeds three times the 95th percentile and is visible:
 * above 0.25 % of the mean, or 0.05 for the change of a pixel. An error of 1 % of the mean is
 * always an outlier.
 */
class MotionOutliers
{
public:
  struct Bend
  {
    /// Largest second difference, its index (starting at 0), and the 95th percentile.
    double Largest = 0.0;
    int At = 0;
    double P95 = 0.0;
    int Outliers = 0;
  };

  /// Adds the next frame, which must have the same size as the previous frames.
  void Add(RgbaImage image);

  /// Returns the mean red value of all frames.
  double GetMean() const;
  Bend GetMeanBend() const;
  /// Returns the statistics of the changes. Index 0 is the change from the first to the second
  /// frame.
  Bend GetChangeBend() const;

  /// Computes statistics of second differences. Differences up to \a seen are not outliers,
  /// differences above \a bound are. With \a isAbove, only numbers above the mean of their
  /// neighbors count as outliers.
  static Bend Measure(
    const std::vector<double>& numbers, double seen, double bound, bool isAbove = false);

private:
  RgbaImage Last;
  std::vector<double> Means;
  std::vector<double> Changes;
};

}

#endif
