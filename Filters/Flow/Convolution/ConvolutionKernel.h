// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ConvolutionKernel_h
#define interlume_ConvolutionKernel_h

#include <vector>

namespace interlume
{

/**
 * @class   ConvolutionKernel
 * @brief   weights of noise along a streamline, and how much their mean varies
 *
 * Samples j = -n ... n lie at arc lengths j h; they are weighted by the trapezoidal rule, k(0) = 1.
 * A streamline may end after \a back samples and \a front samples; its mean is over those.
 *
 * The standard deviation of that mean is that on straight lines of all directions and places: the
 * covariance of LatticeNoise at two points apart by d, the mean over places, is its lattice's
 * variance times C(d_x) C(d_y) C(d_z), C the autocorrelation of the interpolation's weight of one
 * lattice point; its mean over directions is a function of |d|, 0 beyond 2 sqrt(3) lattice lengths.
 */
class ConvolutionKernel
{
public:
  /// Makes the kernel k(s) = (1 + cos(pi s / L)) / 2 if \a isHann, else 1. \a scale is that of the
  /// noise.
  ConvolutionKernel(bool isHann, int steps, double step, double scale);

  double GetWeight(int j) const { return this->Weights[j]; }
  double GetSum(int back, int front) const { return this->Sums[back] + this->Sums[front] - 1.0; }
  double GetDeviation(int back, int front) const;

private:
  // The weights, and their sums, of samples 0 ... j of one side.
  std::vector<double> Weights;
  std::vector<double> Sums;
  // The sums over pairs of those samples, both ways, less the pairs with sample 0 for the other
  // side.
  std::vector<double> FrontPairs;
  std::vector<double> BackPairs;
  // The sums over pairs on different sides, at [back * (Reach + 1) + front]; beyond Reach there are
  // no more.
  int Reach;
  std::vector<double> CrossPairs;
};

}

#endif
