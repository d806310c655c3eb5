// SPDX-License-Identifier: BSD-3-Clause
#include "Support/AnalyticFlows/ReferenceNoise.h"

#include <cmath>
#include <cstdint>

namespace reference
{
namespace
{
double GetLatticeValue(int seed, const std::int64_t index[3])
{
  const auto mix = [](std::uint64_t z)
  {
    z += 11400714819323198485u;
    z ^= z >> 30;
    z *= 13787848793156543929u;
    z ^= z >> 27;
    z *= 10723151780598845931u;
    return z ^ (z >> 31);
  };
  std::uint64_t hash = mix(static_cast<std::uint64_t>(seed));
  for (int axis = 0; axis < 3; ++axis)
  {
    hash = mix(hash + static_cast<std::uint64_t>(index[axis]));
  }
  return static_cast<double>(hash >> 11) / 9007199254740992.0;
}
}

double GetTent(double t)
{
  const double a = std::abs(t);
  return a < 1.0 ? 1.0 - (6.0 * std::pow(a, 5) - 15.0 * std::pow(a, 4) + 10.0 * std::pow(a, 3))
                 : 0.0;
}

double GetNoise(const std::array<double, 3>& x, double scale, int seed)
{
  std::int64_t first[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = static_cast<std::int64_t>(std::floor(x[axis] / scale));
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::int64_t index[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = first[axis] + (corner >> axis & 1);
      weight *= GetTent(x[axis] / scale - static_cast<double>(index[axis]));
    }
    sum += weight * GetLatticeValue(seed, index);
  }
  return sum;
}

}
