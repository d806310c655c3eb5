// SPDX-License-Identifier: BSD-3-Clause
// Values compared with the formula for every sum, falloff and envelope. Also tests seeds, pieces,
// threads, progress, abort and settings.
#include "Analytic/GradientNoise.h"
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTurbulenceSource.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;

void Configure(vtkTurbulenceSource* source)
{
  source->SetWholeExtent(-4, 20, 0, 15, 2, 13);
  source->SetBounds(-1.0, 2.0, 0.0, 4.0, -3.0, -2.0);
  source->SetFrequency(1.7);
  source->SetNumberOfOctaves(4);
  source->SetAmplitude(0.8);
  source->SetOffset(0.3);
  source->SetSeed(5);
  source->SetTopFraction(0.2);
}

double GetFalloff(int falloff, double h)
{
  const double factors[3] = { 1.0, 1.0 - 0.8 * h, std::exp(h * std::log(0.2)) };
  return factors[falloff];
}

double GetExpected(vtkTurbulenceSource* source, const double x[3])
{
  const double low[3] = { -1.0, 0.0, -3.0 };
  const double size[3] = { 3.0, 4.0, 1.0 };
  const double y[3] = { 1.7 * x[0], 1.7 * x[1], 1.7 * x[2] };
  const int axis = source->GetVerticalAxis();
  const double noise = interlume::GradientNoise(5).Sum(y, source->GetSum(), 4);
  const double value =
    GetFalloff(source->GetFalloff(), (x[axis] - low[axis]) / size[axis]) * (0.3 + 0.8 * noise);
  double r2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    r2 += std::pow((x[i] - low[i] - 0.5 * size[i]) / (0.5 * size[i]), 2);
  }
  const double envelope = r2 < 1.0 ? 1.0 - r2 : 0.0;
  const double values[3] = { value, envelope * value, std::max(0.0, envelope + value - 1.0) };
  return values[source->GetEnvelope()];
}

void CheckValues(Check& check)
{
  vtkNew<vtkTurbulenceSource> source;
  Configure(source);
  for (const auto& [sum, falloff, envelope] : AllIndices(
         3, vtkTurbulenceSource::NUMBER_OF_FALLOFFS, vtkTurbulenceSource::NUMBER_OF_ENVELOPES))
  {
    check.SetContext(std::string(vtkTurbulenceSource::GetSumName(sum)) + ", falloff " +
      vtkTurbulenceSource::GetFalloffName(falloff) + ", envelope " +
      vtkTurbulenceSource::GetEnvelopeName(envelope));
    source->SetSum(sum);
    source->SetFalloff(falloff);
    source->SetEnvelope(envelope);
    source->SetVerticalAxis((falloff + envelope) % 3);
    source->Update();
    vtkImageData* image = source->GetOutput();
    vtkDataArray* values = image->GetPointData()->GetArray("Turbulence");
    if (!check.That(values && values == image->GetPointData()->GetScalars(), "the array"))
    {
      return;
    }
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double x[3];
      image->GetPoint(i, x);
      const double expected = GetExpected(source, x);
      check.Near(values->GetTuple1(i), expected, 1e-6, "value", 1.0);
      check.Near(source->Evaluate(x), expected, 1e-13, "value at a point", 1.0);
    }
  }
}

void CheckSettings(Check& check)
{
  check.SetContext("settings");
  vtkNew<vtkTurbulenceSource> source;
  source->SetDimensions(8, 8, 8);
  source->Update();
  const std::string bytes = GetBytes(source->GetOutput());
  source->SetSeed(1);
  source->Update();
  check.That(GetBytes(source->GetOutput()) != bytes, "another seed yields other values");
  source->SetSeed(0);
  source->Update();
  check.That(GetBytes(source->GetOutput()) == bytes, "the same seed yields the same values");
  const double nan = std::nan("");
  source->SetFrequency(nan);
  source->SetAmplitude(nan);
  source->SetOffset(nan);
  source->SetTopFraction(nan);
  CheckPrinted(Print(source),
    { "Sum: turbulence", "NumberOfOctaves: 5", "Frequency: 2", "Amplitude: 1", "Offset: 0",
      "Seed: 0", "Falloff: none", "VerticalAxis: 2", "TopFraction: 0.1", "Envelope: none" },
    check);
  source->SetTopFraction(-1.0);
  source->SetFrequency(-1.0);
  source->SetNumberOfOctaves(0);
  source->SetAmplitude(1e300);
  check.That(source->GetTopFraction() == 1e-6 && source->GetFrequency() == 0.0 &&
      source->GetNumberOfOctaves() == 1 && source->GetAmplitude() == 1e12,
    "clamped values");
  source->SetFrequency(1e300);
  source->Update();
  double range[2];
  source->GetOutput()->GetPointData()->GetScalars()->GetRange(range);
  check.That(
    std::isfinite(range[0]) && std::isfinite(range[1]), "values at extreme settings are finite");
  check.That(!vtkTurbulenceSource::GetFalloffName(3) && !vtkTurbulenceSource::GetEnvelopeName(-1),
    "invalid indices have no name");
}

}

int TestTurbulenceSource(int, char*[])
{
  Check check;
  CheckValues(check);
  vtkNew<vtkTurbulenceSource> source;
  Configure(source);
  check.SetContext("execution");
  CheckImageSource(source, check);
  CheckSettings(check);
  return check.Result();
}
