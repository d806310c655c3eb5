// SPDX-License-Identifier: BSD-3-Clause
// Media of the Monte Carlo solver: extinction and albedo of an image against ReferenceMedium,
// extinction ranges of cells, and transmittance against numerical integration.
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceMedium.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Transport/CellMedium.h"
#include "Support/Transport/FunctionMedium.h"
#include "Support/Transport/TransportFlight.h"
#include "Support/Transport/VolumeMedium.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

namespace
{

using namespace reference;

glm::dvec3 ToVector(const std::array<double, 3>& v)
{
  return { v[0], v[1], v[2] };
}

/// Returns a ray that starts outside the unit cube centered at the origin and intersects it.
TransportRay MakeRay(Random& random)
{
  const glm::dvec3 direction = ToVector(random.GetDirection());
  return { ToVector(random.GetPoint(0.4)) - 3.0 * direction, direction };
}

/// Integrates the extinction along a ray by the midpoint rule, with equal steps in each cell.
double SumDepth(const TransportMedium& medium, const TransportRay& ray, double end, Check& check)
{
  constexpr int Steps = 40;
  double depth = 0.0;
  medium.Walk(ray, end,
    [&](double a, double b, const ExtinctionRange& range)
    {
      for (int step = 0; step < Steps; ++step)
      {
        const double value = medium.GetExtinction(ray.At(a + (b - a) * (step + 0.5) / Steps));
        check.That(
          value >= range.Minimum - 1e-6 * range.Largest && value <= range.Largest * (1.0 + 1e-6),
          "the extinction is in the range of its cell");
        depth += value * (b - a) / Steps;
      }
      return true;
    });
  return depth;
}

/// Compares both transmittance estimators with exp(-depth). The rays end inside the box.
void CheckFlights(const TransportMedium& medium, const std::string& name, Check& check)
{
  Random random(5);
  constexpr int Paths = 4000;
  for (int line = 0; line < 8; ++line)
  {
    check.SetContext(name + ", line " + std::to_string(line));
    const TransportRay ray = MakeRay(random);
    const double end = 3.1;
    const double expected = std::exp(-SumDepth(medium, ray, end, check));
    double uncollided = 0.0;
    double mean = 0.0;
    double square = 0.0;
    for (int path = 0; path < Paths; ++path)
    {
      TransportRandom numbers(7, static_cast<std::uint64_t>(line * Paths + path));
      uncollided +=
        TransportFlight::SampleCollision(medium, ray, numbers) >= end ? 1.0 / Paths : 0.0;
      const double transmittance =
        TransportFlight::EstimateTransmittance(medium, ray, end, numbers);
      mean += transmittance / Paths;
      square += transmittance * transmittance / Paths;
    }
    // Four standard deviations, and the error of the numerical integration.
    const double noise = std::sqrt(expected * (1.0 - expected) / Paths);
    check.Near(
      uncollided, expected, 4.0 * noise + 1e-3, "fraction of paths without collision", 1.0);
    const double deviation = std::sqrt(std::max(square - mean * mean, 0.0) / Paths);
    check.Near(mean, expected, 4.0 * deviation + 1e-3, "mean transmittance", 1.0);
  }
}

void CheckFunction(Check& check)
{
  const FunctionMedium medium(
    glm::dvec3(-0.5), glm::dvec3(0.5), { 0.0, 9.0 },
    [](const glm::dvec3& x) { return 4.5 + 4.5 * std::sin(9.0 * x.x + 4.0 * x.y - 6.0 * x.z); },
    [](const glm::dvec3&) { return glm::dvec3(1.0); });
  CheckFlights(medium, "a formula", check);
}

void CheckCells(Check& check)
{
  Random random(2);
  std::vector<double> extinction;
  for (int cell = 0; cell < 3 * 5 * 7; ++cell)
  {
    extinction.push_back(cell % 3 == 0 ? 0.0 : random.Get(0.0, 6.0));
  }
  const CellMedium medium(glm::dvec3(-0.5), glm::dvec3(1.0 / 3.0, 0.2, 1.0 / 7.0), { { 3, 5, 7 } },
    extinction, { glm::dvec3(0.3) });
  check.SetContext("cells");
  // A position in cell (2, 1, 4).
  check.Near(medium.GetExtinction({ 0.4, -0.2, 0.1 }), extinction[2 + 3 * (1 + 5 * 4)], 0.0,
    "extinction of one cell");
  CheckFlights(medium, "cells", check);
}

void CheckVolume(Check& check)
{
  const auto field = [](const Double3& x)
  { return std::max(std::sin(5.0 * x[0] + 1.0) * std::cos(4.0 * x[1]) + 0.5 * x[2], 0.0); };
  // 17 cells, so that the last block of four cells extends past the image.
  ShadowScene scene = MakeScene(MakeImage(17, field), MakeTranslucentProperty(0.7, false));
  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  albedo->AddRGBPoint(1.0, 0.2, 0.5, 0.9);
  const VolumeMedium medium(scene.Image, scene.Property);
  const VolumeMedium colored(scene.Image, scene.Property, albedo);
  const ReferenceMedium expected(scene);
  Random random(3);
  check.SetContext("volume");
  for (int i = 0; i < 500; ++i)
  {
    const std::array<double, 3> position = random.GetPoint(0.55);
    const glm::dvec3 x = ToVector(position);
    if (std::max({ std::abs(x.x), std::abs(x.y), std::abs(x.z) }) >= 0.5)
    {
      check.Near(medium.GetExtinction(x), 0.0, 0.0, "no extinction outside the volume", 1.0);
      continue;
    }
    const IndexLine line = expected.GetImage().ToIndex(position, { { 0.0, 0.0, 1.0 } });
    std::array<ReferenceMedium::Part, 4> parts;
    const int count = expected.GetParts(line.Begin, true, parts);
    const double extinction = count > 0 ? parts[0].Extinction : 0.0;
    check.Near(medium.GetExtinction(x), extinction, 1e-4, "extinction", 1.0);
    const double value = expected.GetImage().At(line.Begin).Values[0];
    for (int channel = 0; channel < 3; ++channel)
    {
      check.Near(colored.GetAlbedo(x)[channel], albedo->GetColor(std::min(value, 1.0))[channel],
        1e-4, "albedo", 1.0);
      if (count > 0)
      {
        check.Near(medium.GetAlbedo(x)[channel], parts[0].Color[static_cast<std::size_t>(channel)],
          1e-4, "color", 1.0);
      }
    }
  }
  CheckFlights(medium, "volume", check);
}
}

int TestTransportMedia(int, char*[])
{
  return RunChecks({ CheckFunction, CheckCells, CheckVolume });
}
