// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GradientNoise_h
#define interlume_GradientNoise_h

#include <array>

namespace interlume
{

/**
 * @class   GradientNoise
 * @brief   Perlin's improved gradient noise, and sums of its octaves
 *
 * K. Perlin, "Improving noise", SIGGRAPH 2002: gradients at the points of the unit lattice, chosen
 * from the twelve directions to the edges of a cube by a permutation of 0 ... 255, interpolated
 * with 6 t^5 - 15 t^4 + 10 t^3. The noise is 0 at lattice points, has continuous second
 * derivatives, mean 0, values between about -1 and 1, and period 256 in each direction. At a
 * position that is not finite it is 0.
 *
 * Seed 0 is the published permutation; another seed shuffles 0 ... 255 by a generator of its own,
 * so that a seed means the same noise with every compiler and library.
 */
class GradientNoise
{
public:
  /// A bound of the noise: no noise is larger, and no sum of octaves larger than twice that.
  static constexpr double LargestNoise = 1.04;

  explicit GradientNoise(int seed = 0);

  /// Returns the noise at \a x, in lattice units.
  double Evaluate(const double x[3]) const;

  /**
   * Returns the sum over i = 0 ... octaves - 1 of noise(2^i x) / 2^i or |noise(2^i x)| / 2^i, for a
   * \a sum of vtkTurbulenceSource::Sums. For NOISE the number of octaves is 1.
   */
  double Sum(const double x[3], int sum, int octaves) const;

private:
  // The permutation, stored twice, so that indices need no wrapping.
  std::array<unsigned char, 512> Permutation;
};

}

#endif
