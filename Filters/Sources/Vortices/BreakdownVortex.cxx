// SPDX-License-Identifier: BSD-3-Clause
#include "Vortices/BreakdownVortex.h"

#include "Vortices/BentAxis.h"

#include "vtkMath.h"

#include <cmath>

namespace interlume
{

namespace
{
// The constants of the formula in vtkDeltaWingSource.h: lengths are in half spans, those along the
// wing in its length.
constexpr double AxisAcross = 0.62;
constexpr double AxisAbove = 0.42;
constexpr double CoreRadius = 0.12;
constexpr double CoreSwelling = 0.4;
constexpr double CoreFading = 0.25;
constexpr double SpiralRadius = 0.14;
constexpr double SpiralPitch = 0.34;
constexpr double BreakdownWidth = 0.06;
}

double BreakdownVortex::operator()(const double x[3]) const
{
  const double halfSpan = this->Slope * x[0];
  const double beyond = x[0] - this->Breakdown;
  // The step is 0 upstream of the breakdown, 1 downstream; its derivative follows.
  const double tanh = std::tanh(beyond / BreakdownWidth);
  const double broken = 0.5 * (1.0 + tanh);
  const double breaking = 0.5 * (1.0 - tanh * tanh) / BreakdownWidth;
  const double turn = 2.0 * vtkMath::Pi() / SpiralPitch;
  const double angle = turn * beyond - this->Phase;
  const double radius = SpiralRadius * halfSpan * broken;
  const double radiusSlope = SpiralRadius * (this->Slope * broken + halfSpan * breaking);
  const double offset[2] = { this->Side * x[1] - AxisAcross * halfSpan - radius * std::cos(angle),
    x[2] - AxisAbove * halfSpan - radius * std::sin(angle) };
  const double slope[2] = { AxisAcross * this->Slope + radiusSlope * std::cos(angle) -
      radius * turn * std::sin(angle),
    AxisAbove * this->Slope + radiusSlope * std::sin(angle) + radius * turn * std::cos(angle) };
  const double core = CoreRadius * halfSpan * (1.0 + CoreSwelling * broken);
  return (1.0 - CoreFading * broken) *
    std::exp(-BentAxis::SquaredDistance(offset, slope) / (core * core));
}

}
