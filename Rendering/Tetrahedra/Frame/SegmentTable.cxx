// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/SegmentTable.h"

#include <array>

namespace interlume
{

namespace
{
// Positive abscissas and their weights for 8-point Gauss-Legendre quadrature on [-1, 1].
constexpr std::array<double, 4> ABSCISSAS = { { 0.1834346424956498, 0.5255324099163290,
  0.7966664774136267, 0.9602898564975363 } };
constexpr std::array<double, 4> WEIGHTS = { { 0.3626837833783620, 0.3137066458778873,
  0.2223810344533745, 0.1012285362903763 } };

double IntegrateTransmittance(double depth, double delta, double from, double to)
{
  const double midpoint = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0.0;
  for (std::size_t i = 0; i < ABSCISSAS.size(); ++i)
  {
    for (double s : { midpoint - half * ABSCISSAS[i], midpoint + half * ABSCISSAS[i] })
    {
      sum += WEIGHTS[i] * std::exp(-depth * s * (1.0 - delta + delta * s));
    }
  }
  return half * sum;
}

double ComputeFrontWeight(double depth, double delta)
{
  if (depth < 1e-4)
  {
    return 0.5 - delta / 6.0;
  }
  // The first quadrature panel is as long as the decay length of the transmittance. Each later
  // panel is longer.
  const double decay = 1.0 / (depth * (1.0 - delta) + std::sqrt(depth) + 1.0);
  double psi = 0.0;
  double from = 0.0;
  for (double to = decay; from < 1.0; to *= 1.5)
  {
    psi += IntegrateTransmittance(depth, delta, from, std::min(to, 1.0));
    from = to;
  }
  return (1.0 - psi) / -std::expm1(-depth);
}
}

SegmentTable::SegmentTable()
  : Values(static_cast<std::size_t>(COLUMNS) * ROWS)
{
  const int steps = 1 << STEPS_LOG2;
  for (int row = 0; row < ROWS; ++row)
  {
    const double v = 1.0 - static_cast<double>(row) / (ROWS - 1);
    for (int column = 0; column < COLUMNS; ++column)
    {
      const double step = 1.0 + static_cast<double>(column % steps) / steps;
      const double depth = std::ldexp(step, column / steps) - 1.0;
      this->Values[row * COLUMNS + column] =
        static_cast<float>(ComputeFrontWeight(depth, 1.0 - 2.0 * v * v));
    }
  }
}

const SegmentTable& SegmentTable::Get()
{
  static const SegmentTable table;
  return table;
}

}
