// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureTurn_h
#define PictureTurn_h

#include "Support/Pictures/RgbaPicture.h"

#include <vector>

namespace reference
{

/**
 * @class   PictureTurn
 * @brief   finds the pictures of an even motion that stand out of it
 *
 * What is even changes evenly from picture to picture: a number of a picture, less the middle of
 * those before and after, is a second difference and small. The numbers are the mean of red, and
 * the largest change of a pixel's red from the picture before.
 *
 * An outlier is a second difference of more than three times what 95 % are below, if it can be
 * seen: above 0.25 % of the mean, or 0.05 of a pixel's change. A mean by 1 % off is one in any
 * case.
 */
class PictureTurn
{
public:
  struct Bend
  {
    /// The largest distance of a number from the middle of its neighbours', where it is, counted
    /// from 0, and the distance below which 95 % are.
    double Largest = 0.0;
    int At = 0;
    double P95 = 0.0;
    int Outliers = 0;
  };

  /// Adds the next picture, of the same size as those before.
  void Add(RgbaPicture picture);

  /// The mean of red over all pictures.
  double GetMean() const;
  Bend GetMeanBend() const;
  /// The number 0 is the change to the second picture.
  Bend GetChangeBend() const;

  /// What is at most \a seen is no outlier, what is above \a bound is one; with \a isAbove only
  /// where the number is above its neighbours' middle.
  static Bend Measure(
    const std::vector<double>& numbers, double seen, double bound, bool isAbove = false);

private:
  RgbaPicture Last;
  std::vector<double> Means;
  std::vector<double> Changes;
};

}

#endif
