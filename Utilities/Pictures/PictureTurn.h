// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureTurn_h
#define PictureTurn_h

#include "Pictures/RgbaPicture.h"

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
  };

  /// Adds the next picture, of the same size as those before.
  void Add(RgbaPicture picture);

  /// The mean of red over all pictures.
  double GetMean() const;
  Bend GetMeanBend() const { return Measure(this->Means); }
  /// The number 0 is the change to the second picture.
  Bend GetChangeBend() const { return Measure(this->Changes); }

  static Bend Measure(const std::vector<double>& numbers);

private:
  RgbaPicture Last;
  std::vector<double> Means;
  std::vector<double> Changes;
};

}

#endif
