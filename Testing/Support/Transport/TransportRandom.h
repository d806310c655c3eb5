// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportRandom_h
#define TransportRandom_h

#include <cstdint>

namespace reference
{

/**
 * @class   TransportRandom
 * @brief   random numbers of one path, determined by a seed and the path's index
 *
 * The n-th number is a hash of a counter (G. Steele, D. Lea and C. Flood, "Fast splittable
 * pseudorandom number generators", OOPSLA 2014). Therefore, a path's numbers do not depend on
 * the thread.
 */
class TransportRandom
{
public:
  TransportRandom(std::uint64_t seed, std::uint64_t path)
    : Counter(Mix(Mix(seed + Golden) + path * Golden))
  {
  }

  /// Returns a number between 0 and 1, exclusive.
  double Get()
  {
    this->Counter += Golden;
    return (static_cast<double>(Mix(this->Counter) >> 11) + 0.5) * 0x1p-53;
  }

private:
  static constexpr std::uint64_t Golden = 0x9e3779b97f4a7c15ULL;

  static std::uint64_t Mix(std::uint64_t x)
  {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }

  std::uint64_t Counter;
};

}

#endif
