// SPDX-License-Identifier: BSD-3-Clause
#include "Vortices/VortexStreet.h"

#include "Vortices/BentAxis.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// The constants of the formula in vtkTaperedCylinderSource.h.
constexpr double ConvectionRatio = 0.85;
constexpr double Deficit = 0.018;
constexpr double Slant = 2.2;
constexpr double CellBlend = 0.08;
constexpr double RowOffset = 0.5;
constexpr double CoreRadius = 0.55;
constexpr double Spreading = 0.008;
constexpr double FormationTime = 0.7;

// Computes a smooth step from 0 to 1.
double Step(double u)
{
  return 0.5 * (1.0 + std::tanh(u));
}
}

double VortexStreet::GetDiameter(double z) const
{
  const double way = std::max(0.0, std::min(z / this->Flow.Height, 1.0));
  return 2.0 * ((1.0 - way) * this->Flow.Radii[0] + way * this->Flow.Radii[1]);
}

double VortexStreet::operator()(const double x[3]) const
{
  const double way = x[2] / this->Flow.Height;
  double sum = 0.0;
  for (int cell = 0; cell < NumberOfCells; ++cell)
  {
    const double begin =
      cell == 0 ? 1.0 : Step((way - static_cast<double>(cell) / NumberOfCells) / CellBlend);
    const double end = cell == NumberOfCells - 1
      ? 0.0
      : Step((way - static_cast<double>(cell + 1) / NumberOfCells) / CellBlend);
    sum += (begin - end) * this->GetDeficitOfCell(cell, x);
  }
  return sum;
}

double VortexStreet::GetDeficitOfCell(int cell, const double x[3]) const
{
  const double speed = this->Flow.Speed;
  const double middle = (cell + 0.5) / NumberOfCells;
  const double frequency =
    this->Flow.StrouhalNumber * speed / this->GetDiameter(middle * this->Flow.Height);
  const double diameter = this->GetDiameter(x[2]);
  const double convection = ConvectionRatio * speed;
  const double lifeTime = this->Flow.OuterRadius / convection;
  // The half period that it is, later upwards by the slant.
  const double halfPeriods = 2.0 * frequency * this->Time - Slant * x[2] / this->Flow.Height;
  const double slope[2] = { -Slant / this->Flow.Height * convection / (2.0 * frequency), 0.0 };
  double sum = 0.0;
  const double last = std::floor(halfPeriods);
  const int number = static_cast<int>(2.0 * frequency * lifeTime) + 1;
  for (int i = 0; i < number; ++i)
  {
    const double vortex = last - i;
    const double age = (halfPeriods - vortex) / (2.0 * frequency);
    if (age > lifeTime)
    {
      break;
    }
    const double side = std::fmod(std::fabs(vortex), 2.0) == 0.0 ? 1.0 : -1.0;
    const double offset[2] = { x[0] - 0.5 * diameter - convection * age,
      x[1] - side * RowOffset * diameter };
    const double core =
      CoreRadius * CoreRadius * diameter * diameter + 4.0 * Spreading * speed * diameter * age;
    const double way = age / lifeTime;
    sum += Deficit * (1.0 - std::exp(-age * speed / (FormationTime * diameter))) *
      (1.0 - way * way) * std::exp(-BentAxis::SquaredDistance(offset, slope) / core);
  }
  return sum;
}

}
