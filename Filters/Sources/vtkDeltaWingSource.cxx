// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDeltaWingSource.h"

#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Vortices/BreakdownVortex.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkDeltaWingSource);

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
  double way[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    way[axis] = static_cast<double>(ijk[axis]) / (this->GetDimension(axis) - 1);
  }
  x[0] = 0.1 + 1.1 * way[0];
  const double halfSpan = this->GetHalfSpan() * x[0];
  x[1] = 1.5 * halfSpan * (2.0 * way[1] - 1.0);
  x[2] = 0.7 * halfSpan * way[2] * (1.0 + way[2]);
}

vtkFieldSampler::Field vtkDeltaWingSource::GetFieldAtTime(double t) const
{
  const double twoPi = 2.0 * vtkMath::Pi();
  const double swing = this->BreakdownAmplitude * std::sin(twoPi * this->BreakdownFrequency * t);
  const double phase = twoPi * this->SpiralFrequency * t;
  const interlume::BreakdownVortex right(
    1.0, this->GetHalfSpan(), this->BreakdownPosition + swing, phase);
  const interlume::BreakdownVortex left(
    -1.0, this->GetHalfSpan(), this->BreakdownPosition - swing, phase);
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
