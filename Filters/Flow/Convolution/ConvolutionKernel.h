// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ConvolutionKernel_h
#define interlume_ConvolutionKernel_h

#include <vector>

namespace interlume
{

/**
 * @class   ConvolutionKernel
 * @brief   weights of noise samples along a streamline, and the standard deviation of their mean
 *
 * Sample j = -n ... n is at arc length j h, where n is the number of steps and h the step length.
 * The weight of a sample is the kernel k, with k(0) = 1, times the weight of the trapezoidal rule.
 * If a streamline ends after \a back samples upstream and \a front samples downstream, the mean is
 * taken over these samples.
 *
 * The standard deviation is computed for straight lines, averaged over directions and positions. At
 * offset d, the covariance of LatticeNoise, averaged over positions, is the variance of a lattice
 * value times C(d_x) C(d_y) C(d_z). C is the autocorrelation of the interpolation weight of a
 * lattice point. The average over directions is a function of |d| that is 0 for distances above 2
 * sqrt(3) lattice units.
 */
class ConvolutionKernel
{
public:
  /// Creates a kernel of length L = steps * step in each direction: k(s) = (1 + cos(pi s / L)) / 2
  /// if \a isHann is true, otherwise k(s) = 1. \a scale is the lattice spacing of the noise.
  ConvolutionKernel(bool isHann, int steps, double step, double scale);

  double GetWeight(int j) const { return this->Weights[j]; }
  double GetSum(int back, int front) const { return this->Sums[back] + this->Sums[front] - 1.0; }
  double GetDeviation(int back, int front) const;

private:
  // Weight of sample j, and sum of the weights of samples 0 to j.
  std::vector<double> Weights;
  std::vector<double> Sums;
  // Weighted sums of the covariances of all pairs among samples 0 to j, for the downstream and the
  // upstream side. Pairs with sample 0 count only in FrontPairs.
  std::vector<double> FrontPairs;
  std::vector<double> BackPairs;
  // Weighted sums for pairs of samples on different sides, at [back * (Reach + 1) + front]. Samples
  // past Reach are not correlated with samples on the other side.
  int Reach;
  std::vector<double> CrossPairs;
};

}

#endif
