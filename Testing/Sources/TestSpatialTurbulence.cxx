// SPDX-License-Identifier: BSD-3-Clause
// Every mode compared with its definition in terms of the operand and the noise. Also tests bounds,
// seeds, zero frequencies and errors.
#include "Analytic/GradientNoise.h"
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkSpatialPrimitive.h"
#include "vtkSpatialTurbulence.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <string>

namespace
{

using namespace reference;
using Sample = vtkSpatialObject::Sample;

vtkSmartPointer<vtkSpatialPrimitive> MakeSphere()
{
  auto sphere = vtkSmartPointer<vtkSpatialPrimitive>::New();
  sphere->SetRadius(0.6);
  sphere->SetEdgeWidth(0.4);
  sphere->SetColor(0.2, 0.4, 0.6);
  return sphere;
}

double GetNoise(vtkSpatialTurbulence* object, int axis, const double x[3])
{
  const interlume::GradientNoise noise(object->GetSeed() ^ (axis * (INT_MAX / 3)));
  const double* frequency = object->GetFrequency();
  const double y[3] = { frequency[0] * x[0], frequency[1] * x[1], frequency[2] * x[2] };
  return object->GetAmplitude() * noise.Sum(y, object->GetSum(), object->GetNumberOfOctaves());
}

double GetExpected(vtkSpatialTurbulence* object, vtkSpatialObject* sphere, const double x[3])
{
  Sample sample;
  if (object->GetMode() == vtkSpatialTurbulence::DISPLACEMENT)
  {
    const double moved[3] = { x[0] + GetNoise(object, 0, x), x[1] + GetNoise(object, 1, x),
      x[2] + GetNoise(object, 2, x) };
    sphere->Evaluate(moved, sample);
    return sample.Density;
  }
  sphere->Evaluate(x, sample);
  const double d = sample.Density;
  const double noise = GetNoise(object, 0, x);
  const double changed = object->GetMode() == vtkSpatialTurbulence::MODULATION
    ? d + d * noise
    : 0.5 + object->GetGain() * (d - noise - 0.5);
  return d > 0.0 ? std::max(0.0, std::min(changed, 1.0)) : 0.0;
}

void CheckModes(Check& check)
{
  const auto sphere = MakeSphere();
  vtkNew<vtkSpatialTurbulence> object;
  object->SetOperand(sphere);
  object->SetFrequency(3.0, 5.0, 7.0);
  object->SetNumberOfOctaves(3);
  object->SetGain(2.5);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (const auto& [mode, sum] : AllIndices(vtkSpatialTurbulence::NUMBER_OF_MODES, 3))
  {
    for (double amplitude : { 0.4, -0.4 })
    {
      object->SetMode(mode);
      object->SetSum(sum);
      object->SetAmplitude(amplitude);
      object->SetSeed(mode);
      check.SetContext(std::string(vtkSpatialTurbulence::GetModeName(mode)) + " by " +
        vtkTurbulenceSource::GetSumName(sum) + " times " + std::to_string(amplitude));
      double bounds[6];
      object->GetBounds(bounds);
      int changed = 0;
      for (int i = 0; i < 1500; ++i)
      {
        double x[3];
        for (double& coordinate : x)
        {
          coordinate = random->GetNextRangeValue(-1.0, 1.0);
        }
        Sample sample;
        object->Evaluate(x, sample);
        check.Near(sample.Density, GetExpected(object, sphere, x), 1e-14, "density", 1.0);
        if (sample.Density > 0.0)
        {
          check.Near(sample.Color[1], 0.4, 0.0, "green");
          check.That(x[0] >= bounds[0] && x[0] <= bounds[1] && x[1] >= bounds[2] &&
              x[1] <= bounds[3] && x[2] >= bounds[4] && x[2] <= bounds[5],
            "density is inside the bounds");
        }
        Sample plain;
        sphere->Evaluate(x, plain);
        changed += plain.Density != sample.Density;
      }
      check.That(changed > 100, "densities are modified");
    }
  }
}

void CheckSettings(Check& check)
{
  check.SetContext("settings");
  vtkNew<vtkSpatialTurbulence> object;
  Sample sample;
  const double x[3] = { 0.5, 0.1, 0.2 };
  check.Contains(CaptureErrors(object, [&] { object->Evaluate(x, sample); }), "no operand");
  const auto sphere = MakeSphere();
  object->SetOperand(sphere);
  double densities[2];
  for (int seed : { 0, 1 })
  {
    object->SetSeed(seed);
    object->Evaluate(x, sample);
    densities[seed] = sample.Density;
  }
  check.That(densities[0] != densities[1], "another seed yields another density");
  // A negative frequency is clamped to 0, which maps all points to the origin, where the noise
  // is 0.
  object->SetFrequency(-3.0);
  object->Evaluate(x, sample);
  Sample plain;
  sphere->Evaluate(x, plain);
  check.Near(sample.Density, plain.Density, 0.0, "density at frequency 0");
  object->SetFrequency(1e300);
  object->SetAmplitude(std::nan(""));
  object->SetGain(-1.0);
  object->SetNumberOfOctaves(99);
  object->Evaluate(x, sample);
  check.That(sample.Density >= 0.0 && sample.Density <= 1.0, "density at an extreme frequency");
  CheckPrinted(Print(object),
    { "Mode: displacement", "Sum: turbulence", "NumberOfOctaves: 16",
      "Frequency: 1e+12 1e+12 1e+12", "Amplitude: 0.1", "Gain: 0", "Seed: 1", "Operand:" },
    check);
}

}

int TestSpatialTurbulence(int, char*[])
{
  return RunChecks({ CheckModes, CheckSettings });
}
