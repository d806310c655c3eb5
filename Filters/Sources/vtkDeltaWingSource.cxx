// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDeltaWingSource.h"

#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Vortices/BentAxis.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkDeltaWingSource);

namespace
{
// Constants of the formula in Documentation/methods/sources.md. Lengths perpendicular to x are
// relative to the half span at x.
constexpr double AxisAcross = 0.62;
constexpr double AxisAbove = 0.42;
constexpr double CoreRadius = 0.12;
constexpr double CoreSwelling = 0.4;
constexpr double CoreFading = 0.25;
constexpr double SpiralRadius = 0.14;
constexpr double SpiralPitch = 0.34;
constexpr double BreakdownWidth = 0.06;

// A leading-edge vortex that widens along a delta wing and breaks down into a spiral, at one time.
struct BreakdownVortex
{
  double Side;      // 1 or -1: the sign of y
  double Slope;     // half span per unit of length along the wing
  double Breakdown; // x of the breakdown
  double Phase;     // angle of the spiral at the breakdown, in radians

  double operator()(const double x[3]) const
  {
    const double halfSpan = this->Slope * x[0];
    if (halfSpan <= 0.0)
    {
      return 0.0; // upstream of the apex, where the vortices start
    }
    const double downstream = x[0] - this->Breakdown;
    // A smooth step, 0 upstream and 1 downstream of the breakdown, and its derivative.
    const double tanh = std::tanh(downstream / BreakdownWidth);
    const double broken = 0.5 * (1.0 + tanh);
    const double breaking = 0.5 * (1.0 - tanh * tanh) / BreakdownWidth;
    const double waveNumber = 2.0 * vtkMath::Pi() / SpiralPitch;
    const double angle = waveNumber * downstream - this->Phase;
    const double radius = SpiralRadius * halfSpan * broken;
    const double radiusSlope = SpiralRadius * (this->Slope * broken + halfSpan * breaking);
    const double offset[2] = { this->Side * x[1] - AxisAcross * halfSpan - radius * std::cos(angle),
      x[2] - AxisAbove * halfSpan - radius * std::sin(angle) };
    const double slope[2] = { AxisAcross * this->Slope + radiusSlope * std::cos(angle) -
        radius * waveNumber * std::sin(angle),
      AxisAbove * this->Slope + radiusSlope * std::sin(angle) +
        radius * waveNumber * std::cos(angle) };
    const double core = CoreRadius * halfSpan * (1.0 + CoreSwelling * broken);
    return (1.0 - CoreFading * broken) *
      std::exp(-interlume::BentAxis::SquaredDistance(offset, slope) / (core * core));
  }
};
}

vtkDeltaWingSource::vtkDeltaWingSource()
  : Superclass("loss", 111, 126, 51)
{
}

void vtkDeltaWingSource::SetSweepAngle(double angle)
{
  interlume::ClampedValue::Set(this, this->SweepAngle, angle, 30.0, 85.0);
}

void vtkDeltaWingSource::SetBreakdownPosition(double position)
{
  interlume::ClampedValue::Set(this, this->BreakdownPosition, position, 0.0, 2.0);
}

void vtkDeltaWingSource::SetBreakdownAmplitude(double amplitude)
{
  interlume::ClampedValue::Set(this, this->BreakdownAmplitude, amplitude, 0.0, 1.0);
}

void vtkDeltaWingSource::SetBreakdownFrequency(double frequency)
{
  interlume::ClampedValue::Set(this, this->BreakdownFrequency, frequency, 0.0, 1000.0);
}

void vtkDeltaWingSource::SetSpiralFrequency(double frequency)
{
  interlume::ClampedValue::Set(this, this->SpiralFrequency, frequency, 0.0, 1000.0);
}

double vtkDeltaWingSource::GetHalfSpan() const
{
  return std::tan(vtkMath::RadiansFromDegrees(90.0 - this->SweepAngle));
}

void vtkDeltaWingSource::GetPosition(const int ijk[3], double x[3]) const
{
  double fraction[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    fraction[axis] = static_cast<double>(ijk[axis]) / (this->GetDimension(axis) - 1);
  }
  x[0] = 0.1 + 1.1 * fraction[0];
  const double halfSpan = this->GetHalfSpan() * x[0];
  x[1] = 1.5 * halfSpan * (2.0 * fraction[1] - 1.0);
  x[2] = 0.7 * halfSpan * fraction[2] * (1.0 + fraction[2]);
}

vtkDeltaWingSource::Field vtkDeltaWingSource::GetFieldAtTime(double t) const
{
  const double twoPi = 2.0 * vtkMath::Pi();
  const double swing = this->BreakdownAmplitude * std::sin(twoPi * this->BreakdownFrequency * t);
  const double phase = twoPi * this->SpiralFrequency * t;
  const BreakdownVortex right{ 1.0, this->GetHalfSpan(), this->BreakdownPosition + swing, phase };
  const BreakdownVortex left{ -1.0, this->GetHalfSpan(), this->BreakdownPosition - swing, phase };
  return [right, left](const double x[3]) { return right(x) + left(x); };
}

void vtkDeltaWingSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "SweepAngle", this->SweepAngle }, { "BreakdownPosition", this->BreakdownPosition },
      { "BreakdownAmplitude", this->BreakdownAmplitude },
      { "BreakdownFrequency", this->BreakdownFrequency },
      { "SpiralFrequency", this->SpiralFrequency } });
}
