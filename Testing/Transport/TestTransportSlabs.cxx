// SPDX-License-Identifier: BSD-3-Clause
// Compares the Monte Carlo solver with published slabs: H. C. van de Hulst, "Multiple Light
// Scattering", Academic Press 1980, volumes I and II, as quoted by public test suites of other
// solvers. Reflection and transmission are fluxes divided by the incident flux. The boundaries do
// not reflect.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Transport/SlabTransport.h"

#include "vtkSMPTools.h"

#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace
{

using namespace reference;

/// A published value, and half a unit of its last digit. A value of 0 means that none is published.
struct Published
{
  double Value = 0.0;
  double Rounding = 0.0;
};

struct Row
{
  const char* Where;
  double Depth;
  double Albedo;
  double G;
  double Cosine;
  std::uint64_t Paths;
  Published Reflected;
  /// Scattered light only.
  Published Transmitted;
  Published Direct;
};

const Row Rows[] = {
  // Henyey-Greenstein phase function, light along the normal. The total transmission is 0.66096;
  // 0.13534 of it is direct light.
  { "II, table 35", 2.0, 0.9, 0.75, 1.0, 1200000, { 0.09739, 5e-6 }, { 0.66096 - 0.13534, 1e-5 },
    { 0.13534, 5e-6 } },
  { "II, table 37, depth 1", 1.0, 1.0, 0.75, 1.0, 1300000, { 0.07874, 5e-6 }, { 0.55338, 5e-6 },
    { 0.36788, 5e-6 } },
  // The published R, T and direct light add up to 1.00001, so the rounding error is larger.
  { "II, table 37, depth 8", 8.0, 1.0, 0.75, 1.0, 60000, { 0.50642, 1e-5 }, { 0.49325, 1e-5 },
    { 0.00034, 5e-6 } },
  // Isotropic scattering, cosine of the angle of incidence 0.1.
  { "I, table 12, depth 1/32, albedo 0.2", 0.03125, 0.2, 0.0, 0.1, 350000, { 0.025447, 5e-7 }, {},
    {} },
  { "I, table 12, depth 1/32, albedo 1", 0.03125, 1.0, 0.0, 0.1, 300000, { 0.13462, 5e-6 }, {},
    {} },
  { "I, table 12, depth 32, albedo 0.2", 32.0, 0.2, 0.0, 0.1, 850000, { 0.082661, 5e-7 }, {}, {} },
  // The direct light, exp(-320), is negligible.
  { "I, table 12, depth 32, albedo 1", 32.0, 1.0, 0.0, 0.1, 200000, { 0.978453, 5e-7 },
    { 0.021548, 5e-7 }, {} },
};

SlabTransportSettings GetSettings(const Row& row)
{
  SlabTransportSettings settings;
  settings.Depth = row.Depth;
  settings.Albedo = row.Albedo;
  settings.Phase = TransportPhase::HenyeyGreenstein(row.G);
  settings.Cosine = row.Cosine;
  settings.Paths = row.Paths;
  return settings;
}

void CheckEstimate(
  Check& check, const TransportEstimate& found, const Published& expected, const std::string& what)
{
  if (expected.Value == 0.0)
  {
    return;
  }
  std::ostringstream line;
  line << what << ": " << found.Value << " +- " << found.StandardError << ", published "
       << expected.Value;
  std::cout << line.str() << " (" << (found.Value - expected.Value) / found.StandardError
            << " deviations)\n";
  check.That(
    std::abs(found.Value - expected.Value) <= 3.0 * found.StandardError + expected.Rounding,
    line.str());
  check.That(
    found.StandardError <= 1e-3 * expected.Value, line.str() + ": standard error below 0.1 %");
}

void CheckRows(Check& check)
{
  for (const Row& row : Rows)
  {
    check.SetContext(row.Where);
    const SlabTransportResult result = TraceSlab(GetSettings(row));
    CheckEstimate(check, result.Reflected, row.Reflected, std::string(row.Where) + ", R");
    CheckEstimate(check, result.Transmitted, row.Transmitted, std::string(row.Where) + ", T");
    if (row.Direct.Value > 0.0)
    {
      check.That(std::abs(result.Direct - row.Direct.Value) <= row.Direct.Rounding, "direct light");
    }
  }
}

// Tests that, without absorption, reflection and transmission add up to 1, for any g and with a
// majorant above the extinction. The control variate is subtracted from one and added to the other,
// so it cancels in the sum.
void CheckFurnace(Check& check)
{
  for (const double g : { -0.99, -0.4, 0.0, 0.0005, 0.6, 0.99 })
  {
    for (const double depth : { 1e-6, 0.1, 1.0, 10.0, 100.0 })
    {
      SlabTransportSettings settings;
      settings.Depth = depth;
      settings.Phase = TransportPhase::HenyeyGreenstein(g);
      settings.Cosine = 0.7;
      settings.Majorant = 1.5;
      settings.Paths = 2000;
      const SlabTransportResult result = TraceSlab(settings);
      const double sum = result.Reflected.Value + result.Transmitted.Value + result.Direct;
      check.Near(sum, 1.0, 1e-12, "R + T = 1 without absorption, g " + std::to_string(g));
    }
  }
}

// Tests a slab of low optical depth, whose first scattering order is known, and a slab with albedo
// 0.
void CheckThin(Check& check)
{
  SlabTransportSettings settings;
  settings.Depth = 1e-6;
  settings.Albedo = 0.5;
  settings.Paths = 100000;
  const SlabTransportResult result = TraceSlab(settings);
  for (const TransportEstimate& side : { result.Reflected, result.Transmitted })
  {
    // Half of the scattered light leaves at each side. The second order is 1e-5 of the first.
    check.That(
      std::abs(side.Value - 0.25e-6) < 4.0 * side.StandardError + 1e-11, "flux of a thin slab");
  }
  settings.Albedo = 0.0;
  const SlabTransportResult black = TraceSlab(settings);
  check.Near(black.Reflected.Value + black.Transmitted.Value, 0.0, 0.0, "albedo 0", 1.0);
}

// Tests that null collisions change the noise but not the mean.
void CheckMajorant(Check& check)
{
  SlabTransportSettings settings = GetSettings(Rows[0]);
  settings.Paths = 200000;
  settings.Majorant = 3.0;
  const SlabTransportResult result = TraceSlab(settings);
  check.That(std::abs(result.Reflected.Value - Rows[0].Reflected.Value) <
      3.5 * result.Reflected.StandardError,
    "R with null collisions");
  check.That(std::abs(result.Transmitted.Value - Rows[0].Transmitted.Value) <
      3.5 * result.Transmitted.StandardError,
    "T with null collisions");
}

// Tests that a tabulated Henyey-Greenstein function scatters like the closed form.
void CheckTable(Check& check)
{
  const TransportPhase formula = TransportPhase::HenyeyGreenstein(0.75);
  std::vector<double> cosines;
  std::vector<double> values;
  for (int i = 0; i <= 2000; ++i)
  {
    // Samples are denser near 1, where the function is steep.
    const double t = 1.0 - i / 2000.0;
    cosines.push_back(1.0 - 2.0 * t * t);
    values.push_back(7.0 * formula.GetValue(cosines.back()));
  }
  const TransportPhase table = TransportPhase::Table(cosines, values);
  check.Near(table.GetMeanCosine(), 0.75, 1e-5, "mean cosine of the table");
  for (const double cosine : { -1.0, -0.3, 0.5, 0.97, 1.0 })
  {
    check.Near(table.GetValue(cosine), formula.GetValue(cosine), 1e-4, "value of the table");
  }
  SlabTransportSettings settings = GetSettings(Rows[1]);
  settings.Paths = 300000;
  settings.Phase = table;
  const SlabTransportResult result = TraceSlab(settings);
  check.That(std::abs(result.Reflected.Value - Rows[1].Reflected.Value) <
      3.5 * result.Reflected.StandardError,
    "R with a tabulated phase function");
}

// Tests that the reported standard errors match the spread of results with different seeds.
void CheckErrors(Check& check)
{
  SlabTransportSettings settings = GetSettings(Rows[2]);
  settings.Paths = 10000;
  double squares = 0.0;
  double stated = 0.0;
  constexpr int Runs = 40;
  for (int run = 0; run < Runs; ++run)
  {
    settings.Seed = static_cast<std::uint64_t>(run) + 10;
    const TransportEstimate found = TraceSlab(settings).Transmitted;
    squares += std::pow(found.Value - Rows[2].Transmitted.Value, 2.0) / Runs;
    stated += found.StandardError * found.StandardError / Runs;
  }
  // The relative standard deviation of a variance that is estimated from 40 values is 0.22.
  check.Near(squares / stated, 1.0, 0.66, "true variance over reported variance");
}

void CheckThreads(Check& check)
{
  SlabTransportSettings settings = GetSettings(Rows[0]);
  settings.Paths = 50000;
  const SlabTransportResult expected = TraceSlab(settings);
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 8 })
  {
    SetThreads(threads);
    const SlabTransportResult found = TraceSlab(settings);
    check.That(found.Reflected.Value == expected.Reflected.Value &&
        found.Reflected.StandardError == expected.Reflected.StandardError &&
        found.Transmitted.Value == expected.Transmitted.Value,
      "the result is identical with " + std::to_string(threads) + " threads");
  }
}
}

int TestTransportSlabs(int, char*[])
{
  Check check;
  CheckRows(check);
  check.SetContext("");
  CheckFurnace(check);
  CheckThin(check);
  CheckMajorant(check);
  CheckTable(check);
  CheckErrors(check);
  CheckThreads(check);
  return check.Result();
}
