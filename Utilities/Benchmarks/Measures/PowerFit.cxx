// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/PowerFit.h"

#include <cmath>
#include <cstddef>

double FitExponent(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto n = static_cast<double>(x.size());
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double a = std::log(x[i]);
    const double b = std::log(y[i]);
    sums[0] += a;
    sums[1] += b;
    sums[2] += a * a;
    sums[3] += a * b;
  }
  return (n * sums[3] - sums[0] * sums[1]) / (n * sums[2] - sums[0] * sums[0]);
}
