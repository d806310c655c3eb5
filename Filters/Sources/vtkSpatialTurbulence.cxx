// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialTurbulence.h"

#include "Analytic/GradientNoise.h"
#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Sampling/PartPrinter.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <climits>
#include <cmath>

vtkStandardNewMacro(vtkSpatialTurbulence);

vtkSpatialTurbulence::vtkSpatialTurbulence()
{
  this->MakeNoises();
}

vtkSpatialTurbulence::~vtkSpatialTurbulence() = default;

const char* vtkSpatialTurbulence::GetModeName(int mode)
{
  static const char* const names[NUMBER_OF_MODES] = { "displacement", "modulation", "erosion" };
  return mode >= 0 && mode < NUMBER_OF_MODES ? names[mode] : nullptr;
}

void vtkSpatialTurbulence::SetOperand(vtkSpatialObject* operand)
{
  if (operand && operand->Contains(this))
  {
    vtkErrorMacro(
      "SetOperand: the operand contains this vtkSpatialTurbulence and was ignored. Pass "
      "an object that does not contain it.");
    return;
  }
  if (this->Operand != operand)
  {
    this->Operand = operand;
    this->Modified();
  }
}

vtkSpatialObject* vtkSpatialTurbulence::GetOperand() const
{
  return this->Operand;
}

void vtkSpatialTurbulence::SetFrequency(double x, double y, double z)
{
  interlume::ClampedValue::Set(
    this, this->Frequency, { x, y, z }, 0.0, interlume::ClampedValue::Largest);
}

void vtkSpatialTurbulence::SetAmplitude(double amplitude)
{
  interlume::ClampedValue::Set(this, this->Amplitude, amplitude);
}

void vtkSpatialTurbulence::SetGain(double gain)
{
  interlume::ClampedValue::Set(this, this->Gain, gain, 0.0, interlume::ClampedValue::Largest);
}

void vtkSpatialTurbulence::SetSeed(int seed)
{
  if (this->Seed != seed)
  {
    this->Seed = seed;
    this->MakeNoises();
    this->Modified();
  }
}

void vtkSpatialTurbulence::MakeNoises()
{
  // Multiples of this number distinguish the seeds of the three directions. It is large, because
  // users choose small seeds, and two objects with adjacent seeds must not share a noise function.
  constexpr int distance = INT_MAX / 3;
  this->Noises.clear();
  for (int i = 0; i < 3; ++i)
  {
    this->Noises.emplace_back(this->Seed ^ (i * distance));
  }
}

bool vtkSpatialTurbulence::Contains(const vtkSpatialObject* object) const
{
  return object == this || (this->Operand && this->Operand->Contains(object));
}

vtkMTimeType vtkSpatialTurbulence::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Operand ? std::max(own, this->Operand->GetMTime()) : own;
}

std::string vtkSpatialTurbulence::Prepare(double bounds[6])
{
  if (!this->Operand)
  {
    return "A vtkSpatialTurbulence has no operand. Call SetOperand.";
  }
  std::string error = this->Operand->Update();
  if (error.empty())
  {
    this->Operand->GetBounds(bounds);
    const double largest = this->Sum == vtkTurbulenceSource::NOISE
      ? interlume::GradientNoise::LargestNoise
      : 2.0 * interlume::GradientNoise::LargestNoise;
    const double reach = this->Mode == DISPLACEMENT ? largest * std::fabs(this->Amplitude) : 0.0;
    // Sums of absolute values are never negative, so they displace in one direction only.
    const bool isOneSided = this->Sum == vtkTurbulenceSource::TURBULENCE;
    for (int side = 0; side < 6; ++side)
    {
      const bool isLower = side % 2 == 0;
      const bool moves = !isOneSided || isLower == (this->Amplitude > 0.0);
      bounds[side] += !moves ? 0.0 : (isLower ? -reach : reach);
    }
  }
  return error;
}

double vtkSpatialTurbulence::GetNoise(
  const interlume::GradientNoise& noise, const double x[3]) const
{
  const double scaled[3] = { this->Frequency[0] * x[0], this->Frequency[1] * x[1],
    this->Frequency[2] * x[2] };
  return noise.Sum(scaled, this->Sum, this->NumberOfOctaves);
}

bool vtkSpatialTurbulence::Displace(const double (*points)[3], int number, Sample* samples) const
{
  double displaced[SpanLength][3];
  for (int i = 0; i < number; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      displaced[i][axis] =
        points[i][axis] + this->Amplitude * this->GetNoise(this->Noises[axis], points[i]);
    }
  }
  return this->Operand->EvaluateSpan(displaced, number, samples);
}

bool vtkSpatialTurbulence::EvaluateLocally(
  const double (*points)[3], int number, Sample* samples) const
{
  if (this->Mode == DISPLACEMENT)
  {
    return this->Displace(points, number, samples);
  }
  if (!this->Operand->EvaluateSpan(points, number, samples))
  {
    return false;
  }
  for (int i = 0; i < number; ++i)
  {
    double& density = samples[i].Density;
    if (density > 0.0)
    {
      const double noise = this->Amplitude * this->GetNoise(this->Noises[0], points[i]);
      const double changed = this->Mode == MODULATION ? density * (1.0 + noise)
                                                      : 0.5 + this->Gain * (density - noise - 0.5);
      density = std::max(0.0, std::min(changed, 1.0));
    }
  }
  return true;
}

void vtkSpatialTurbulence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Mode", GetModeName(this->Mode) }, { "Sum", vtkTurbulenceSource::GetSumName(this->Sum) },
      { "NumberOfOctaves", this->NumberOfOctaves }, { "Frequency", this->Frequency },
      { "Amplitude", this->Amplitude }, { "Gain", this->Gain }, { "Seed", this->Seed } });
  interlume::PartPrinter::Print(os, indent, "Operand", this->Operand);
}
