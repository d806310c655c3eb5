// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LatticeNoise_h
#define interlume_LatticeNoise_h

#include <cmath>
#include <cstdint>

namespace interlume
{

/**
 * @class   LatticeNoise
 * @brief   smooth 3D value noise in [0,1]
 *
 * Independent uniform values at the points of an integer lattice are interpolated along each axis
 * with the weight 6 t^5 - 15 t^4 + 10 t^3. A lattice value is a hash of the seed and the three
 * indices. They are added one after another, and each sum is mixed by the finalizer of SplitMix64
 * (Steele, Lea and Flood, OOPSLA 2014). The noise is identical on all machines.
 */
class LatticeNoise
{
public:
  LatticeNoise(double scale, int seed)
    : Scale(scale)
    , Seed(Mix(static_cast<std::uint64_t>(static_cast<std::int64_t>(seed))))
  {
  }

  double Evaluate(const double x[3]) const
  {
    std::int64_t lower[3];
    double weights[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double position = x[axis] / this->Scale;
      const double floor = std::floor(position);
      // Index 0 replaces indices that would overflow. Positions this far from the origin have no
      // fractional part anyway.
      lower[axis] = std::abs(floor) < 4e18 ? static_cast<std::int64_t>(floor) : 0;
      weights[axis] = Fade(position - floor);
    }
    double value = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      const std::uint64_t byX = Add(this->Seed, lower[0] + i);
      for (int j = 0; j < 2; ++j)
      {
        const std::uint64_t byY = Add(byX, lower[1] + j);
        const double weight =
          (i ? weights[0] : 1.0 - weights[0]) * (j ? weights[1] : 1.0 - weights[1]);
        const double first = ToNumber(Add(byY, lower[2]));
        const double second = ToNumber(Add(byY, lower[2] + 1));
        value += weight * (first + weights[2] * (second - first));
      }
    }
    return value;
  }

  /// Variance of a lattice value.
  static constexpr double Variance = 1.0 / 12.0;
  static double Fade(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

private:
  static std::uint64_t Mix(std::uint64_t z)
  {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  static std::uint64_t Add(std::uint64_t hash, std::int64_t index)
  {
    return Mix(hash + static_cast<std::uint64_t>(index));
  }
  static double ToNumber(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

  double Scale;
  std::uint64_t Seed;
};

}

#endif
