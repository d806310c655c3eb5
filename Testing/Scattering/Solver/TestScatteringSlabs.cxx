// SPDX-License-Identifier: BSD-3-Clause
// Compares reflection and transmission of slabs with H. C. van de Hulst, "Multiple Light
// Scattering", 1980, tables 12, 35 and 37, for single scattering and both modes of multiple
// scattering. The field is evaluated along view rays and integrated over all directions.
#include "Support/Checks/ReferenceCheck.h"
#include "Scattering/Solver/ScatteringCases.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using namespace interlume;

struct Row
{
  std::string Name;
  Slab Case;
  double Reflected;
  /// Scattered light only. Negative if no value is published.
  double Transmitted;
  /// Bounds of the relative errors of mode FULL, 10 % above the measured errors.
  double ReflectedBound;
  double TransmittedBound;
};

std::vector<Row> MakeRows()
{
  const double thinDirect = std::exp(-10.0 / 32.0);
  return {
    { "II, 35: HG 0.75, depth 2, albedo 0.9", { 0.75, 1.0, 2.0, 0.9 }, 0.09739, 0.66096 - 0.13534,
      0.04, 0.005 },
    { "II, 37: HG 0.75, depth 1, albedo 1", { 0.75, 1.0, 1.0, 1.0 }, 0.07874, 0.55338, 0.05, 0.01 },
    { "II, 37: HG 0.75, depth 8, albedo 1", { 0.75, 1.0, 8.0, 1.0 }, 0.50642, 0.49325, 0.03, 0.02 },
    { "I, 12: isotropic, mu 0.1, depth 1/32, albedo 0.2", { 0.0, 0.1, 1.0 / 32.0, 0.2 }, 0.025447,
      -1.0, 0.01, 0.0 },
    { "I, 12: isotropic, mu 0.1, depth 1/32, albedo 1", { 0.0, 0.1, 1.0 / 32.0, 1.0 }, 0.13462,
      1.0 - 0.13462 - thinDirect, 0.035, 0.035 },
    { "I, 12: isotropic, mu 0.1, depth 32, albedo 0.2", { 0.0, 0.1, 32.0, 0.2 }, 0.082661, -1.0,
      0.1, 0.0 },
    { "I, 12: isotropic, mu 0.1, depth 32, albedo 1", { 0.0, 0.1, 32.0, 1.0 }, 0.978453, 0.021548,
      0.05, 0.4 },
  };
}

double ErrorOf(double found, double expected)
{
  return expected > 0.0 ? found / expected - 1.0 : 0.0;
}

}

int TestScatteringSlabs(int, char*[])
{
  // Each layer is subdivided for the direct light, since slices resolve it more finely than the
  // grid.
  constexpr int parts = 8;
  Check check;
  std::printf(
    "%-50s  %16s  %16s  %16s\n", "relative errors of R and T", "single", "forward", "full");
  for (const Row& row : MakeRows())
  {
    const ScatteringMedium medium = row.Case.MakeMedium();
    const ScatteringLight light = row.Case.MakeLight(medium);
    ScatteredLight none;
    none.Fluence.assign(medium.GetNumberOfCells(), glm::vec3(0.0f));
    none.NetFlux = none.Fluence;
    std::vector<SlabFlux> fluxes = { IntegrateSlabFlux(row.Case, medium, none, parts) };
    for (const ScatteringMode mode : { ScatteringMode::Forward, ScatteringMode::Full })
    {
      const Solved solved = Solve(medium, { light }, mode);
      fluxes.push_back(IntegrateSlabFlux(row.Case, medium, solved.Field, parts));
      check.SetContext(row.Name + ": ");
      check.Near(solved.GetSum() / solved.Report.Taken, 1.0, 1e-5, "sum of the energy");
    }
    std::printf("%-50s", row.Name.c_str());
    for (const SlabFlux& flux : fluxes)
    {
      std::printf("  %7.1f%% %6.1f%%", 100.0 * ErrorOf(flux.Reflected, row.Reflected),
        100.0 * ErrorOf(flux.Transmitted, row.Transmitted));
    }
    std::printf("\n");
    const double reflected = ErrorOf(fluxes[2].Reflected, row.Reflected);
    const double transmitted = ErrorOf(fluxes[2].Transmitted, row.Transmitted);
    check.Near(reflected, 0.0, row.ReflectedBound, "reflection", 1.0);
    check.Near(transmitted, 0.0, row.TransmittedBound, "transmission", 1.0);
    check.That(std::abs(reflected) <= std::abs(ErrorOf(fluxes[0].Reflected, row.Reflected)),
      "mode FULL reflects more accurately than single scattering");
    check.That(std::abs(transmitted) <= std::abs(ErrorOf(fluxes[0].Transmitted, row.Transmitted)),
      "mode FULL transmits more accurately than single scattering");
  }
  return check.Result();
}
