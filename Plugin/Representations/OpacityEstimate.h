// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpacityEstimate_h
#define interlume_OpacityEstimate_h

#include <vector>

namespace interlume
{

/// Histogram with bins of equal width.
struct ValueHistogram
{
  /// Lower bound of the first bin, and width of a bin.
  double First = 0.0;
  double Width = 1.0;
  std::vector<double> Counts;

  double GetCenter(int bin) const { return this->First + (bin + 0.5) * this->Width; }

  /// Creates empty bins, at most 1024, for values from \a smallest to \a largest. If the values are
  /// integers, all bins span the same number of integers.
  static ValueHistogram Make(double smallest, double largest, bool areIntegers);
  /// Adds \a weight to the bin of a value. NaN and values outside the bins are ignored.
  void Add(double value, double weight = 1.0);
};

/**
 * @class   OpacityEstimate
 * @brief   derives an opacity function from a histogram, so that rare values are visible
 *
 * - The background is the largest peak of the histogram. It is transparent up to the end of its
 *   noise: the value where the logarithm of the histogram is farthest below the straight line from
 *   the peak to the end of the tail (the triangle method of Zack et al., 1977). If the histogram
 *   has no such bend, the rarest 15 % of the samples are shown.
 * - At least the rarest 10 % are shown. If more than 60 % would be, the peak is padding or only a
 *   part of the background, and the next peak is made transparent too.
 * - Both sides of the background are shown if each has at least a fifth of the samples of the
 *   other, for example for a velocity component; otherwise only the side with more samples. If
 *   nearly all samples below the background have the smallest value, they are padding and are not
 *   shown.
 * - The opacity rises with the distance from the background, from 0 to 0.8 at the rarest 0.1 %: by
 *   a quarter of 0.8 after each quarter of the samples shown.
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

  /// Returns the points of a piecewise linear opacity function in ascending order of values.
  /// Returns no points if fewer than two bins contain samples.
  static std::vector<Point> Find(const ValueHistogram& histogram);
};

}

#endif
