// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTurbulenceSource.h"

#include "Analytic/GradientNoise.h"
#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Sampling/ExtentRows.h"
#include "Sampling/SourceReport.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTurbulenceSource);

namespace
{
constexpr double MinimumTopFraction = 1e-6;
}

const char* vtkTurbulenceSource::GetSumName(int sum)
{
  static const char* const names[] = { "noise", "fractal sum", "turbulence" };
  return sum >= NOISE && sum <= TURBULENCE ? names[sum] : nullptr;
}

const char* vtkTurbulenceSource::GetFalloffName(int falloff)
{
  static const char* const names[NUMBER_OF_FALLOFFS] = { "none", "linear", "exponential" };
  return falloff >= 0 && falloff < NUMBER_OF_FALLOFFS ? names[falloff] : nullptr;
}

const char* vtkTurbulenceSource::GetEnvelopeName(int envelope)
{
  static const char* const names[NUMBER_OF_ENVELOPES] = { "none", "sphere", "cloud" };
  return envelope >= 0 && envelope < NUMBER_OF_ENVELOPES ? names[envelope] : nullptr;
}

void vtkTurbulenceSource::SetFrequency(double frequency)
{
  interlume::ClampedValue::Set(
    this, this->Frequency, frequency, 0.0, interlume::ClampedValue::Largest);
}

void vtkTurbulenceSource::SetAmplitude(double amplitude)
{
  interlume::ClampedValue::Set(this, this->Amplitude, amplitude);
}

void vtkTurbulenceSource::SetOffset(double offset)
{
  interlume::ClampedValue::Set(this, this->Offset, offset);
}

void vtkTurbulenceSource::SetTopFraction(double fraction)
{
  interlume::ClampedValue::Set(this, this->TopFraction, fraction, MinimumTopFraction, 1.0);
}

double vtkTurbulenceSource::GetFalloffFactor(const double x[3]) const
{
  const double lower = this->GetLowerBound(this->VerticalAxis);
  const double upper = this->GetUpperBound(this->VerticalAxis);
  const double height = (x[this->VerticalAxis] - lower) / (upper - lower);
  switch (this->Falloff)
  {
    case LINEAR:
      return 1.0 - (1.0 - this->TopFraction) * height;
    case EXPONENTIAL:
      return std::pow(this->TopFraction, height);
    default:
      return 1.0;
  }
}

double vtkTurbulenceSource::GetEnvelopeFactor(const double x[3]) const
{
  if (this->Envelope == NO_ENVELOPE)
  {
    return 1.0;
  }
  double r2 = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lower = this->GetLowerBound(axis);
    const double upper = this->GetUpperBound(axis);
    const double offset = (2.0 * x[axis] - lower - upper) / (upper - lower);
    r2 += offset * offset;
  }
  return std::max(0.0, 1.0 - r2);
}

double vtkTurbulenceSource::Evaluate(const interlume::GradientNoise& noise, const double x[3]) const
{
  const double envelope = this->GetEnvelopeFactor(x);
  const double scaled[3] = { this->Frequency * x[0], this->Frequency * x[1],
    this->Frequency * x[2] };
  const double value = this->GetFalloffFactor(x) *
    (this->Offset + this->Amplitude * noise.Sum(scaled, this->Sum, this->NumberOfOctaves));
  return this->Envelope == CLOUD ? std::max(0.0, envelope + value - 1.0) : envelope * value;
}

double vtkTurbulenceSource::Evaluate(const double x[3]) const
{
  return this->Evaluate(interlume::GradientNoise(this->Seed), x);
}

int vtkTurbulenceSource::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestInformation(request, inputs, outputs);
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), VTK_FLOAT, 1);
  return 1;
}

int vtkTurbulenceSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  interlume::SourceReport().CopyTo(this->GetReport());
  this->SetGeometry(image, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  vtkNew<vtkFloatArray> values;
  values->SetName("Turbulence");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  const interlume::GradientNoise noise(this->Seed);
  const auto makeValue = [&](const double x[3], vtkIdType point)
  { values->SetValue(point, static_cast<float>(this->Evaluate(noise, x))); };
  if (!interlume::ExtentRows::RunPoints(image, this, makeValue))
  {
    image->Initialize();
    return 1;
  }
  image->GetPointData()->SetScalars(values);
  interlume::SourceReport::Of(image, image->GetNumberOfPoints()).CopyTo(this->GetReport());
  this->UpdateProgress(1.0);
  return 1;
}

void vtkTurbulenceSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Sum", GetSumName(this->Sum) }, { "NumberOfOctaves", this->NumberOfOctaves },
      { "Frequency", this->Frequency }, { "Amplitude", this->Amplitude },
      { "Offset", this->Offset }, { "Seed", this->Seed },
      { "Falloff", GetFalloffName(this->Falloff) }, { "VerticalAxis", this->VerticalAxis },
      { "TopFraction", this->TopFraction }, { "Envelope", GetEnvelopeName(this->Envelope) } });
}
