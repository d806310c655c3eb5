// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzRandom_h
#define FuzzRandom_h

#include <cstdint> // for the state
#include <vector>  // for choices

namespace fuzz
{

/**
 * @class   FuzzRandom
 * @brief   random choices that are identical on every machine for the same seed
 *
 * SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators",
 * OOPSLA 2014) is used because the distributions of the C++ standard library differ between
 * implementations.
 */
class FuzzRandom
{
public:
  explicit FuzzRandom(std::uint64_t seed)
    : State(seed)
  {
  }
  std::uint64_t Next()
  {
    std::uint64_t z = (this->State += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// Returns a number in [0, 1).
  double Unit() { return static_cast<double>(this->Next() >> 11) * 0x1p-53; }
  double Between(double lower, double upper) { return lower + (upper - lower) * this->Unit(); }
  /// Returns an integer in [lower, upper].
  int Integer(int lower, int upper)
  {
    return lower + static_cast<int>(this->Next() % static_cast<std::uint64_t>(upper - lower + 1));
  }
  bool Chance(double probability) { return this->Unit() < probability; }
  template <typename T>
  T Pick(const std::vector<T>& choices)
  {
    return choices[this->Next() % choices.size()];
  }

private:
  std::uint64_t State;
};

}

#endif
