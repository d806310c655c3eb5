// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTaperedCylinderSource.h"

#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Vortices/BentAxis.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkTaperedCylinderSource);

namespace
{
// Constants of the formula in Documentation/methods/sources.md.
constexpr double ConvectionRatio = 0.85;
constexpr double Deficit = 0.018;
constexpr double Slant = 2.2;
constexpr double CellBlend = 0.08;
constexpr double RowOffset = 0.5;
constexpr double CoreRadius = 0.55;
constexpr double Spreading = 0.008;
constexpr double FormationTime = 0.7;

// Returns a smooth step from 0 to 1.
double Step(double u)
{
  return 0.5 * (1.0 + std::tanh(u));
}

// Density deficit of a von Karman vortex street behind a tapered cylinder, at one time.
struct VortexStreet
{
  static constexpr int NumberOfCells = 3;

  std::array<double, 2> Radii; // at z = 0 and z = Height
  double Height;
  double OuterRadius;
  double Speed;
  double StrouhalNumber;
  double Time;

  // Returns the deficit at a point.
  double operator()(const double x[3]) const;
  // Returns the diameter of the cylinder at a height, which is clamped to the cylinder's ends.
  double GetDiameter(double z) const;
  // Returns the deficit at a point if the given shedding cell extended along the whole cylinder.
  double GetDeficitOfCell(int cell, const double x[3]) const;
};

double VortexStreet::GetDiameter(double z) const
{
  const double fraction = std::max(0.0, std::min(z / this->Height, 1.0));
  return 2.0 * ((1.0 - fraction) * this->Radii[0] + fraction * this->Radii[1]);
}

double VortexStreet::operator()(const double x[3]) const
{
  const double fraction = x[2] / this->Height;
  double sum = 0.0;
  for (int cell = 0; cell < NumberOfCells; ++cell)
  {
    const double begin =
      cell == 0 ? 1.0 : Step((fraction - static_cast<double>(cell) / NumberOfCells) / CellBlend);
    const double end = cell == NumberOfCells - 1
      ? 0.0
      : Step((fraction - static_cast<double>(cell + 1) / NumberOfCells) / CellBlend);
    sum += (begin - end) * this->GetDeficitOfCell(cell, x);
  }
  return sum;
}

double VortexStreet::GetDeficitOfCell(int cell, const double x[3]) const
{
  const double speed = this->Speed;
  const double center = (cell + 0.5) / NumberOfCells;
  const double frequency = this->StrouhalNumber * speed / this->GetDiameter(center * this->Height);
  const double diameter = this->GetDiameter(x[2]);
  const double convection = ConvectionRatio * speed;
  const double lifeTime = this->OuterRadius / convection;
  // Number of half shedding periods since time 0. Slant delays vortices at larger heights.
  const double halfPeriods = 2.0 * frequency * this->Time - Slant * x[2] / this->Height;
  const double slope[2] = { -Slant / this->Height * convection / (2.0 * frequency), 0.0 };
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
    const double fraction = age / lifeTime;
    sum += Deficit * (1.0 - std::exp(-age * speed / (FormationTime * diameter))) *
      (1.0 - fraction * fraction) *
      std::exp(-interlume::BentAxis::SquaredDistance(offset, slope) / core);
  }
  return sum;
}

// Strength of the clustering of grid points toward the wall and toward the wake.
constexpr double Clustering = 2.0;
constexpr double ClusteringAround = 0.75;
}

vtkTaperedCylinderSource::vtkTaperedCylinderSource()
  : Superclass("density", 64, 64, 32)
{
}

void vtkTaperedCylinderSource::SetRadii(double bottom, double top)
{
  interlume::ClampedValue::Set(this, this->Radii, { bottom, top }, 0.05, 50.0);
}

void vtkTaperedCylinderSource::SetHeight(double height)
{
  interlume::ClampedValue::Set(this, this->Height, height, 0.1, 1000.0);
}

void vtkTaperedCylinderSource::SetOuterRadius(double radius)
{
  interlume::ClampedValue::Set(this, this->OuterRadius, radius, 0.1, 200.0);
}

void vtkTaperedCylinderSource::SetSpeed(double speed)
{
  interlume::ClampedValue::Set(this, this->Speed, speed, 0.001, 1000.0);
}

void vtkTaperedCylinderSource::SetStrouhalNumber(double number)
{
  interlume::ClampedValue::Set(this, this->StrouhalNumber, number, 0.01, 1.0);
}

double vtkTaperedCylinderSource::GetGridRadius() const
{
  return std::max(this->OuterRadius, 2.0 * std::max(this->Radii[0], this->Radii[1]));
}

void vtkTaperedCylinderSource::GetPosition(const int ijk[3], double x[3]) const
{
  const double height = static_cast<double>(ijk[2]) / (this->GetDimension(2) - 1);
  const double wall = (1.0 - height) * this->Radii[0] + height * this->Radii[1];
  const double outward = static_cast<double>(ijk[0]) / (this->GetDimension(0) - 1);
  const double radius = wall +
    (this->GetGridRadius() - wall) * std::expm1(Clustering * outward) / std::expm1(Clustering);
  // The modulo operation makes the first and last points in j bit-identical.
  const double around =
    static_cast<double>(ijk[1] % (this->GetDimension(1) - 1)) / (this->GetDimension(1) - 1);
  const double fullAngle = 2.0 * vtkMath::Pi() * around;
  const double angle = fullAngle - vtkMath::Pi() + ClusteringAround * std::sin(fullAngle);
  x[0] = radius * std::cos(angle);
  x[1] = radius * std::sin(angle);
  x[2] = height * this->Height;
}

vtkTaperedCylinderSource::Field vtkTaperedCylinderSource::GetFieldAtTime(double t) const
{
  const VortexStreet street{ { { this->Radii[0], this->Radii[1] } }, this->Height,
    this->GetGridRadius(), this->Speed, this->StrouhalNumber, t };
  return [street](const double x[3]) { return 1.0 - street(x); };
}

void vtkTaperedCylinderSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Radii", this->Radii }, { "Height", this->Height }, { "OuterRadius", this->OuterRadius },
      { "Speed", this->Speed }, { "StrouhalNumber", this->StrouhalNumber } });
}
