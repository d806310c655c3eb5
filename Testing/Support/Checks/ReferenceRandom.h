// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceRandom_h
#define ReferenceRandom_h

#include <array>
#include <cmath>
#include <random>

namespace reference
{

/**
 * @class   Random
 * @brief   reproducible random numbers and directions
 */
class Random
{
public:
  explicit Random(unsigned seed)
    : Engine(seed)
  {
  }

  double Get(double lower, double upper)
  {
    return std::uniform_real_distribution<double>(lower, upper)(this->Engine);
  }

  std::array<double, 3> GetPoint(double size)
  {
    return { { this->Get(-size, size), this->Get(-size, size), this->Get(-size, size) } };
  }

  /// Returns a random unit vector, uniformly distributed over the unit sphere.
  std::array<double, 3> GetDirection()
  {
    const double z = this->Get(-1.0, 1.0);
    const double turn = this->Get(0.0, 2.0 * 3.14159265358979324);
    const double radius = std::sqrt(1.0 - z * z);
    return { { radius * std::cos(turn), radius * std::sin(turn), z } };
  }

private:
  std::mt19937 Engine;
};

}

#endif
