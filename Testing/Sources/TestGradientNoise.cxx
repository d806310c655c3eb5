// SPDX-License-Identifier: BSD-3-Clause
// Values of the noise compared with the published implementation, and its zeros, period, mean,
// bound and smoothness. Also tests sums of octaves, compared with their formula, and seeds.
#include "Analytic/GradientNoise.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkTurbulenceSource.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace reference;
using Vector = std::array<double, 3>;

Vector GetRandomPoint(vtkMinimalStandardRandomSequence* random, double size)
{
  Vector x;
  for (double& coordinate : x)
  {
    coordinate = random->GetNextRangeValue(-size, size);
  }
  return x;
}

// The expected values come from a separate program that directly translates the published code to
// exact rational arithmetic.
void CheckPublished(Check& check)
{
  check.SetContext("published");
  const interlume::GradientNoise noise;
  check.Near(
    noise.Evaluate(Vector{ { 3.14, 42.0, 7.0 } }.data()), 0.13691995878400012, 1e-13, "value", 1.0);
  check.Near(noise.Evaluate(Vector{ { -1.25, 0.375, 200.5 } }.data()), -0.22939785569906235, 1e-13,
    "value", 1.0);
  check.Near(noise.Evaluate(Vector{ { 0.5, 0.5, 0.5 } }.data()), -0.25, 1e-13, "value", 1.0);
  check.Near(noise.Evaluate(Vector{ { 255.75, -0.75, 17.125 } }.data()), -0.059248086792649701,
    1e-13, "value", 1.0);
  check.Near(noise.Evaluate(Vector{ { 12.7, -300.2, 1000.9 } }.data()), -0.1560002547689554, 1e-13,
    "value", 1.0);
}

void CheckGridPoints(Check& check)
{
  check.SetContext("lattice");
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (int seed : { 0, 1, -5 })
  {
    const interlume::GradientNoise noise(seed);
    for (int i = 0; i < 1000; ++i)
    {
      const Vector x = GetRandomPoint(random, 600.0);
      const Vector corner{ { std::round(x[0]), std::round(x[1]), std::round(x[2]) } };
      check.Near(noise.Evaluate(corner.data()), 0.0, 0.0, "noise at a lattice point");
      // Multiples of 1/8 are exact in floating point.
      const Vector y{ { std::round(8.0 * x[0]) / 8.0, std::round(8.0 * x[1]) / 8.0,
        std::round(8.0 * x[2]) / 8.0 } };
      const Vector next{ { y[0] + 256.0, y[1] - 512.0, y[2] + 256.0 * 8388608.0 } };
      check.Near(noise.Evaluate(next.data()), noise.Evaluate(y.data()), 0.0, "noise is periodic");
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : { infinity, -infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    const Vector x{ { 0.5, bad, 0.5 } };
    check.Near(
      interlume::GradientNoise().Evaluate(x.data()), 0.0, 0.0, "noise at a non-finite point");
    check.Near(interlume::GradientNoise().Sum(x.data(), vtkTurbulenceSource::TURBULENCE, 16), 0.0,
      0.0, "sum at a non-finite point");
  }
  check.That(
    std::isfinite(interlume::GradientNoise().Evaluate(Vector{ { 1e300, -1e300, 0.5 } }.data())),
    "noise far from the origin is finite");
}

// Derivatives are continuous across cell faces, and the mean over a period is 0.
void CheckSmoothness(Check& check)
{
  check.SetContext("smoothness");
  const interlume::GradientNoise noise(7);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  const double h = 1e-5;
  double largest = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    Vector x = GetRandomPoint(random, 100.0);
    x[i % 3] = std::round(x[i % 3]);
    Vector before = x;
    Vector after = x;
    before[i % 3] -= h;
    after[i % 3] += h;
    const double midpoint = noise.Evaluate(x.data());
    const double left = (midpoint - noise.Evaluate(before.data())) / h;
    const double right = (noise.Evaluate(after.data()) - midpoint) / h;
    reference::KeepLargest(largest, std::fabs(right - left));
  }
  // The second derivative is below 100 in magnitude.
  check.Near(largest, 0.0, 100.0 * h, "jump of the derivative", 1.0);
  double sum = 0.0;
  double bound = 0.0;
  const int number = 2000000;
  for (int i = 0; i < number; ++i)
  {
    const double value = noise.Evaluate(GetRandomPoint(random, 128.0).data());
    sum += value;
    bound = std::max(bound, std::fabs(value));
  }
  check.Near(sum / number, 0.0, 1e-3, "mean", 1.0);
  check.That(bound > 0.8 && bound <= interlume::GradientNoise::LargestNoise, "the largest value");
}

void CheckSums(Check& check)
{
  check.SetContext("sums");
  const interlume::GradientNoise noise(3);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (int i = 0; i < 500; ++i)
  {
    const Vector x = GetRandomPoint(random, 9.0);
    double fractal = 0.0;
    double turbulence = 0.0;
    for (int octave = 0; octave < 6; ++octave)
    {
      const double scale = std::pow(2.0, octave);
      const Vector y{ { scale * x[0], scale * x[1], scale * x[2] } };
      fractal += noise.Evaluate(y.data()) / scale;
      turbulence += std::fabs(noise.Evaluate(y.data())) / scale;
    }
    check.Near(noise.Sum(x.data(), vtkTurbulenceSource::NOISE, 6), noise.Evaluate(x.data()), 0.0,
      "noise of one octave");
    check.Near(
      noise.Sum(x.data(), vtkTurbulenceSource::FRACTAL_SUM, 6), fractal, 1e-14, "fractal sum", 1.0);
    check.Near(noise.Sum(x.data(), vtkTurbulenceSource::TURBULENCE, 6), turbulence, 1e-14,
      "turbulence", 1.0);
  }
  check.That(vtkTurbulenceSource::GetSumName(3) == nullptr &&
      std::string(vtkTurbulenceSource::GetSumName(vtkTurbulenceSource::TURBULENCE)) == "turbulence",
    "names");
}

void CheckSeeds(Check& check)
{
  check.SetContext("seeds");
  vtkNew<vtkMinimalStandardRandomSequence> random;
  int equal = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Vector x = GetRandomPoint(random, 50.0);
    check.Near(interlume::GradientNoise(11).Evaluate(x.data()),
      interlume::GradientNoise(11).Evaluate(x.data()), 0.0, "the same seed yields the same noise");
    equal += interlume::GradientNoise(11).Evaluate(x.data()) ==
      interlume::GradientNoise(12).Evaluate(x.data());
    equal += interlume::GradientNoise(0).Evaluate(x.data()) ==
      interlume::GradientNoise(1).Evaluate(x.data());
  }
  check.That(equal < 100, "other seeds yield other noise");
  // The values do not depend on the C++ standard library.
  check.Near(interlume::GradientNoise(1).Evaluate(Vector{ { 0.25, 3.5, -7.625 } }.data()),
    -0.18859511613845825, 1e-13, "value", 1.0);
  check.Near(interlume::GradientNoise(-20).Evaluate(Vector{ { 100.5, 31.25, 8.75 } }.data()),
    -0.023576259613037109, 1e-13, "value", 1.0);
}

}

int TestGradientNoise(int, char*[])
{
  return RunChecks({ CheckPublished, CheckGridPoints, CheckSmoothness, CheckSums, CheckSeeds });
}
