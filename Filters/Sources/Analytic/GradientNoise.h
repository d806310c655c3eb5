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
 * The noise is from K. Perlin, "Improving noise", SIGGRAPH 2002. A permutation of 0 ... 255 assigns
 * to each integer point one of twelve gradients, which point to the edges of a cube. Between
 * integer points, the linear functions with these gradients are blended with 6 t^5 - 15 t^4 +
 * 10 t^3. The noise has continuous second derivatives, a mean of 0, values between about -1 and 1,
 * and a period of 256 in each direction. It is 0 at integer points and at positions that are not
 * finite.
 *
 * Seed 0 uses the published permutation. Other seeds shuffle 0 ... 255 with a built-in generator,
 * so that a seed produces the same noise with every compiler and library.
 */
class GradientNoise
{
public:
  /// Upper bound of |noise|. The absolute values of sums of octaves are below twice this bound.
  static constexpr double LargestNoise = 1.04;

  explicit GradientNoise(int seed = 0);

  /// Returns the noise at \a x. Gradients are at integer coordinates.
  double Evaluate(const double x[3]) const;

  /**
   * Returns the sum over i = 0 ... octaves - 1 of noise(2^i x) / 2^i or |noise(2^i x)| / 2^i,
   * depending on \a sum, a value of vtkTurbulenceSource::Sums. NOISE uses one octave.
   */
  double Sum(const double x[3], int sum, int octaves) const;

private:
  // The permutation, stored twice to avoid wrapping indices.
  std::array<unsigned char, 512> Permutation;
};

}

#endif
