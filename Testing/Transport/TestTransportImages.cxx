// SPDX-License-Identifier: BSD-3-Clause
// Images of the Monte Carlo solver: published intensities of a slab at six angles, the closed form
// of single scattering, a white furnace, colored albedo.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Transport/FunctionMedium.h"
#include "Support/Transport/ImageTransport.h"

#include "vtkSMPTools.h"

#include <array>
#include <cmath>
#include <sstream>

namespace
{

using namespace reference;

constexpr double SolidAngleOfAll = 4.0 * 3.14159265358979324;

/// Returns a view ray to a slab, with the given cosine of the angle between the ray and the normal.
/// Rays of row 0 start on the lit side.
TransportRay MakeSightLine(double cosine, int row, double thickness)
{
  const double across = std::sqrt(1.0 - cosine * cosine);
  return row == 0 ? TransportRay{ { 0.0, 0.0, -1.0 }, { across, 0.0, cosine } }
                  : TransportRay{ { 0.0, 0.0, thickness + 1.0 }, { across, 0.0, -cosine } };
}

/// Compares diffuse intensities I of a slab with van de Hulst, "Multiple Light Scattering", 1980,
/// volume II, table 35: optical depth 2, albedo 0.9, Henyey-Greenstein g = 0.75, light along the
/// normal. I is scaled so that the reflection R is the integral of 2 mu I over mu from 0 to 1. The
/// published limits at mu = 0 are skipped, since no view ray has mu = 0.
void CheckPublished(Check& check)
{
  const std::array<double, 6> cosines = { { 0.1, 0.3, 0.5, 0.7, 0.9, 1.0 } };
  const double expected[2][6] = { { 0.13304, 0.13856, 0.11956, 0.09411, 0.07132, 0.06180 },
    { 0.16486, 0.22473, 0.27785, 0.36889, 0.72155, 2.40270 } };
  ImageTransportSettings settings;
  settings.Phase = TransportPhase::HenyeyGreenstein(0.75);
  settings.Lights = { {} };
  settings.PathsPerPixel = 60000;
  const FunctionMedium slab = FunctionMedium::Slab(2.0, 1.0, glm::dvec3(0.9));
  const TransportImage image = TraceImage(
    slab, 6, 2,
    [&](int i, int j) { return MakeSightLine(cosines[static_cast<std::size_t>(i)], j, 2.0); },
    settings);
  for (const auto& [j, i] : AllIndices(2, 6))
  {
    // A light of color 1 has an irradiance of 4 pi. The published I is for an irradiance of pi.
    const double found = 0.25 * image.Mean.At(i, j)[0];
    const double error = 0.25 * image.StandardError.At(i, j)[0];
    std::ostringstream what;
    what << (j == 0 ? "reflected" : "transmitted") << " at " << cosines[static_cast<std::size_t>(i)]
         << ": " << found << " +- " << error << ", published " << expected[j][i];
    check.That(std::abs(found - expected[j][i]) <= 3.0 * error + 5e-6, what.str());
    check.That(error < 0.015 * expected[j][i], what.str() + ": standard error below 1.5 %");
  }
}

/// Tests single scattering in a slab that is lit at an oblique angle. The albedo differs between
/// color channels.
void CheckSingle(Check& check)
{
  ImageTransportSettings settings;
  settings.Phase = TransportPhase::HenyeyGreenstein(-0.4);
  const double incidence = 0.6;
  settings.Lights = { { { 0.0, 0.8, incidence }, { 1.0, 2.0, 1.0 } } };
  settings.MaximumScatterings = 1;
  settings.PathsPerPixel = 20000;
  const glm::dvec3 albedo(1.0, 0.5, 0.0);
  const double depth = 1.3;
  const FunctionMedium slab = FunctionMedium::Slab(0.5, depth / 0.5, albedo);
  const TransportImage image = TraceImage(
    slab, 2, 1, [](int i, int) { return MakeSightLine(i == 0 ? 0.8 : 0.3, 0, 0.5); }, settings);
  for (int i = 0; i < 2; ++i)
  {
    const double mu = i == 0 ? 0.8 : 0.3;
    const double cosine = -mu * incidence;
    const double path = depth * (1.0 / mu + 1.0 / incidence);
    const double expected = SolidAngleOfAll * settings.Phase.GetValue(cosine) * incidence /
      (mu + incidence) * -std::expm1(-path);
    const double* found = image.Mean.At(i, 0);
    const double* error = image.StandardError.At(i, 0);
    check.That(std::abs(found[0] - expected) < 3.5 * error[0], "albedo 1");
    check.That(std::abs(found[1] - expected) < 3.5 * error[1], "albedo 0.5 with twice the light");
    check.Near(found[2], 0.0, 0.0, "albedo 0", 1.0);
    check.That(std::abs(found[3] + std::expm1(-depth / mu)) < 3.5 * error[3], "opacity");
    check.That(error[0] < 0.02 * expected, "noise");
  }
}

/// Tests that a medium without absorption is invisible in uniform light from all directions.
void CheckFurnace(Check& check)
{
  const FunctionMedium sphere(
    glm::dvec3(-1.0), glm::dvec3(1.0), { 0.0, 12.0 },
    [](const glm::dvec3& x)
    { return 12.0 * std::max(1.0 - x.x * x.x - x.y * x.y - x.z * x.z, 0.0); },
    [](const glm::dvec3&) { return glm::dvec3(1.0); });
  ImageTransportSettings settings;
  settings.Phase = TransportPhase::HenyeyGreenstein(0.8);
  settings.Surroundings = { 0.2, 0.5, 1.0 };
  settings.PathsPerPixel = 100;
  const TransportImage image = TraceImage(
    sphere, 8, 1,
    [](int i, int) {
      return TransportRay{ { -0.9 + 0.25 * i, 0.1, -4.0 }, { 0.0, 0.0, 1.0 } };
    },
    settings);
  for (int i = 0; i < 8; ++i)
  {
    const double* pixel = image.Mean.At(i, 0);
    for (int channel = 0; channel < 3; ++channel)
    {
      check.Near(pixel[channel], pixel[3] * settings.Surroundings[channel], 1e-12,
        "radiance equals the surroundings");
    }
  }
}

void CheckThreads(Check& check)
{
  ImageTransportSettings settings;
  settings.Lights = { {} };
  settings.PathsPerPixel = 20;
  const FunctionMedium slab = FunctionMedium::Slab(3.0, 1.0, glm::dvec3(0.9, 0.8, 0.7));
  const auto trace = [&]
  {
    return TraceImage(
      slab, 20, 20, [](int i, int j) { return MakeSightLine(0.04 * (i + 1), j % 2, 3.0); },
      settings);
  };
  const TransportImage expected = trace();
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 8 })
  {
    SetThreads(threads);
    const TransportImage found = trace();
    check.That(found.Mean.Values == expected.Mean.Values &&
        found.StandardError.Values == expected.StandardError.Values,
      "the result is identical with " + std::to_string(threads) + " threads");
  }
}
}

int TestTransportImages(int, char*[])
{
  return RunChecks({ CheckPublished, CheckSingle, CheckFurnace, CheckThreads });
}
