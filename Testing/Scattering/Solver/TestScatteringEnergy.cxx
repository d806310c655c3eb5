// SPDX-License-Identifier: BSD-3-Clause
// Mode FULL conserves energy for random settings. A medium without absorption is invisible in a
// white furnace. Results are identical for any number of threads. BackwardLayers truncates
// backscattering.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Scattering/Solver/ScatteringCases.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>

namespace
{

using namespace reference;
using namespace interlume;

ScatteringMedium MakeRandomMedium(Random& random)
{
  const auto integer = [&random](int lower, int upper)
  { return static_cast<int>(random.Get(lower, upper + 0.999)); };
  const glm::ivec3 cells(integer(1, 9), integer(1, 9), integer(1, 9));
  const double depth = std::pow(10.0, random.Get(-6.0, 4.0));
  ScatteringMedium medium = MakeMedium(cells, depth, glm::vec3(1.0f), random.Get(-0.99, 0.99));
  medium.CellSize = { random.Get(0.5, 2.0), random.Get(0.5, 2.0), random.Get(0.5, 2.0) };
  const double empty = random.Get(-0.5, 0.7);
  const double blocked = random.Get(-0.5, 0.3);
  const double albedo = std::min(random.Get(0.0, 1.5), 1.0);
  const bool isSmooth = random.Get(0.0, 1.0) < 0.5;
  medium.Blocked.assign(medium.GetNumberOfCells(), 0);
  for (std::size_t i = 0; i < medium.GetNumberOfCells(); ++i)
  {
    medium.Extinction[i] *= static_cast<float>(random.Get(0.0, 1.0) < empty
        ? 0.0
        : (isSmooth ? 1.0 : std::pow(10.0, random.Get(-3.0, 0.0))));
    medium.Albedo[i] = glm::vec3(static_cast<float>(albedo),
      static_cast<float>(random.Get(0.0, 1.0)), static_cast<float>(random.Get(0.9, 1.0)));
    medium.Blocked[i] = random.Get(0.0, 1.0) < blocked ? 1 : 0;
  }
  return medium;
}

void CheckRandom(Check& check)
{
  Random random(20);
  double maximum = 0.0;
  double minimum = 2.0;
  for (int i = 0; i < 500; ++i)
  {
    const ScatteringMedium medium = MakeRandomMedium(random);
    const std::array<double, 3> direction = random.GetDirection();
    std::vector<ScatteringLight> lights = { MakeLight(medium, glm::make_vec3(direction.data())) };
    if (random.Get(0.0, 1.0) < 0.4)
    {
      const std::array<double, 3> position = random.GetPoint(8.0);
      lights.push_back(MakeScatteringPointLight(medium, glm::make_vec3(position.data())));
    }
    ScatteringSettings settings;
    settings.BackwardLayers = random.Get(0.0, 1.0) < 0.3 ? 3 : 0;
    settings.AngleVariance = random.Get(-0.1, 0.5);
    for (const ScatteringMode mode : { ScatteringMode::Forward, ScatteringMode::Full })
    {
      const Solved solved = Solve(medium, lights, mode, settings);
      if (!(solved.Report.Taken > 0.0))
      {
        continue;
      }
      const double fraction = solved.GetSum() / solved.Report.Taken;
      maximum = std::max(maximum, fraction);
      minimum = std::min(minimum, fraction);
      check.SetContext("case " + std::to_string(i) + ": ");
      check.That(fraction < 1.0 + 1e-5 && fraction > 0.999,
        "energy fraction " + std::to_string(fraction) + " near 1");
      check.That(
        solved.Report.Residual <= settings.Tolerance, "the residual is within the tolerance");
      for (std::size_t cell = 0; cell < medium.GetNumberOfCells(); ++cell)
      {
        const glm::vec3& fluence = solved.Field.Fluence[cell];
        check.That(fluence.x >= 0.0f && fluence.y >= 0.0f && fluence.z >= 0.0f &&
            std::isfinite(fluence.x + fluence.y + fluence.z) &&
            glm::length(solved.Field.NetFlux[cell]) < 0.3334f,
          "the fluence is finite and not negative, and the normalized net flux is bounded");
      }
    }
  }
  check.SetContext("");
  std::cout << "energy fraction for random settings: " << minimum << " to " << maximum << "\n";
}

/// An infinite slab without absorption, lit from all directions, is as bright as its background in
/// all directions.
void CheckFurnace(Check& check)
{
  constexpr int layers = 32;
  constexpr int levels = 32;
  for (const double g : { 0.0, 0.75 })
  {
    for (const double depth : { 0.1, 1.0, 10.0 })
    {
      Slab slab;
      slab.G = g;
      slab.Depth = depth;
      slab.Layers = layers;
      const ScatteringMedium medium = slab.MakeMedium();
      std::vector<ScatteringLight> lights;
      for (int level = 0; level < levels; ++level)
      {
        slab.Cosine = (level + 0.5) / levels;
        ScatteringLight light = slab.MakeLight(medium);
        for (glm::vec3& direct : light.Direct)
        {
          direct *= 0.5f / levels;
        }
        lights.push_back(light);
        light.Direction.z = -light.Direction.z;
        std::reverse(light.Direct.begin(), light.Direct.end());
        lights.push_back(light);
      }
      const Solved solved = Solve(medium, lights, ScatteringMode::Full);
      double worst = 0.0;
      double flux = 0.0;
      for (const double mu : { 0.1, 0.3, 0.5, 0.7, 0.9 })
      {
        double seen = 1.0;
        for (int layer = 0; layer < layers; ++layer)
        {
          const std::size_t cell = static_cast<std::size_t>(layer) * 4;
          double source =
            solved.Field.Fluence[cell].x * (1.0 + 3.0 * g * solved.Field.NetFlux[cell].z * mu);
          for (std::size_t light = 0; light < lights.size(); ++light)
          {
            // The mean of the phase function over rotations about the slab's normal.
            double phase = 0.0;
            for (int azimuth = 0; azimuth < 32; ++azimuth)
            {
              const double across = std::sqrt(1.0 - mu * mu) * lights[light].Direction.x *
                std::cos(0.19634954 * azimuth);
              phase +=
                12.566370614 / 32.0 * medium.Phase.Value(mu * lights[light].Direction.z + across);
            }
            const double forward =
              solved.Field.Forward.empty() ? 0.0 : solved.Field.Forward[light][cell].x;
            source += (lights[light].Direct[cell].x + forward) * phase;
          }
          const double step = depth / layers / mu;
          seen = seen * std::exp(-step) - source * std::expm1(-step);
        }
        flux += mu * seen / 2.5;
        reference::KeepLargest(worst, std::abs(seen - 1.0));
      }
      std::cout << "furnace, g " << g << ", depth " << depth << ": largest error " << worst
                << ", flux " << flux << "\n";
      check.Near(worst, 0.0, g > 0.0 ? 0.22 : 0.031, "brightness in the furnace", 1.0);
      check.Near(flux, 1.0, g > 0.0 ? 0.05 : 0.03, "flux out of the furnace");
    }
  }
}

bool IsSame(const ScatteredLight& a, const ScatteredLight& b)
{
  const auto same = [](const std::vector<glm::vec3>& one, const std::vector<glm::vec3>& other)
  {
    return one.size() == other.size() &&
      std::memcmp(one.data(), other.data(), one.size() * sizeof(glm::vec3)) == 0;
  };
  bool isSame = same(a.Fluence, b.Fluence) && same(a.NetFlux, b.NetFlux) &&
    a.Forward.size() == b.Forward.size();
  for (std::size_t i = 0; i < a.Forward.size() && isSame; ++i)
  {
    isSame = same(a.Forward[i], b.Forward[i]);
  }
  return isSame;
}

void CheckThreads(Check& check)
{
  const ScatteringMedium medium = MakeCloud(28, 20.0, { 0.99f, 0.95f, 0.9f }, 0.8);
  const std::vector<ScatteringLight> lights = { MakeLight(medium, { 1.0, 2.0, 2.0 }),
    MakeScatteringPointLight(medium, { 0.3, 0.4, 0.5 }) };
  const std::string backend = vtkSMPTools::GetBackend();
  check.That(vtkSMPTools::SetBackend("STDThread"), "the threading backend exists");
  for (const ScatteringMode mode : { ScatteringMode::Forward, ScatteringMode::Full })
  {
    ScatteredLight first;
    for (const int threads : { 1, 3 })
    {
      SetThreads(threads);
      const Solved solved = Solve(medium, lights, mode);
      check.That(
        threads == 1 || IsSame(first, solved.Field), "the field is identical for 3 threads");
      first = solved.Field;
    }
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// With more backscattering layers, the result approaches the result with all layers.
void CheckBackwardLayers(Check& check)
{
  Slab slab;
  slab.G = 0.75;
  slab.Depth = 8.0;
  const ScatteringMedium medium = slab.MakeMedium();
  const ScatteringLight light = slab.MakeLight(medium);
  const double all = Solve(medium, { light }, ScatteringMode::Full).Report.Reflected;
  double before = 1.0;
  for (const int layers : { 3, 6, 12, 24, 48, 96 })
  {
    ScatteringSettings settings;
    settings.BackwardLayers = layers;
    const Solved solved = Solve(medium, { light }, ScatteringMode::Full, settings);
    const double error = 1.0 - solved.Report.Reflected / all;
    std::cout << "backscattering from " << layers << " of 64 layers: " << error << " is missing\n";
    check.That(error > 0.0 && error < before, "more layers are closer to all layers");
    check.Near(solved.GetSum() / solved.Report.Taken, 1.0, 1e-5, "sum of the energy");
    before = error;
  }
  check.That(before < 0.125, "96 layers include all but an eighth of the light");
}

}

int TestScatteringEnergy(int, char*[])
{
  Check check;
  CheckRandom(check);
  CheckFurnace(check);
  CheckThreads(check);
  CheckBackwardLayers(check);
  return check.Result();
}
