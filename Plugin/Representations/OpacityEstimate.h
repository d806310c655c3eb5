// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpacityEstimate_h
#define interlume_OpacityEstimate_h

#include <vector>

namespace interlume
{

/// Numbers of samples in adjacent intervals of values, all of the same width.
struct ValueHistogram
{
  /// Smallest value of the first bin, and width of a bin.
  double First = 0.0;
  double Width = 1.0;
  std::vector<double> Counts;

  double GetCenter(int bin) const { return this->First + (bin + 0.5) * this->Width; }

  /// Creates empty bins, at most 1024, for values from \a smallest to \a largest. If the values are
  /// integers, each bin has the same number of them.
  static ValueHistogram Make(double smallest, double largest, bool areIntegers);
  /// Counts a value. Values outside the bins, and NaN, are ignored.
  void Add(double value, double weight = 1.0);
};

/**
 * @class   OpacityEstimate
 * @brief   derives an opacity function from a histogram, so that rare values are seen
 *
 * - The background is the largest peak of the histogram. It is transparent up to the end of its
 *   noise: the value where the logarithm of the histogram is farthest below the straight line from
 *   the peak to the end of the tail (the triangle method of Zack et al., 1977). If the histogram
 *   has no such bend, the rarest 15 % of the samples are shown.
 * - At least the rarest 10 % are shown. If more than 60 % are, the peak is padding or only a part
 *   of the background, and the next peak is removed too.
 * - Both sides of the background are shown if each has at least a fifth of the samples of the
 *   other, for example for a velocity component; otherwise only the side with more samples. A
 *   single smallest value far below the background is padding and is not shown.
 * - The opacity rises with the number of samples, by a quarter for every quarter of the samples
 *   shown, up to 0.8 at the rarest 0.1 %.
 * - If there are at most 16 different values, they are labels. The most frequent label is
 *   transparent, and the others have an opacity of 0.3.
 */
class OpacityEstimate
{
public:
  struct Point
  {
    double Value;
    double Opacity;
  };

  /// Returns points in ascending order of values, between which the opacity is linear. Returns no
  /// points if there are fewer than two different values.
  static std::vector<Point> Find(const ValueHistogram& histogram);
};

}

#endif
