// SPDX-License-Identifier: BSD-3-Clause
// For random settings, the light that leaves a medium is at most the light that the medium
// extinguishes.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Scattering/Solver/ScatteringCases.h"
#include "Scattering/Solver/RadianceSampler.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace
{

using namespace reference;
using namespace interlume;

struct Setting
{
  ScatteringMedium Medium;
  std::vector<ScatteringLight> Lights;
  ScatteringSettings Settings;
  double G = 0.0;
  std::string Text;
};

Setting MakeSetting(unsigned seed)
{
  Random random(seed);
  const auto integer = [&random](int lower, int upper)
  { return static_cast<int>(random.Get(lower, upper + 0.999)); };
  Setting setting;
  const glm::ivec3 cells(integer(1, 8), integer(1, 8), integer(1, 8));
  const double depth = std::pow(10.0, random.Get(-2.0, 4.0));
  setting.G = random.Get(-0.95, 0.95);
  setting.Medium = MakeMedium(cells, depth, glm::vec3(1.0f), setting.G);
  ScatteringMedium& medium = setting.Medium;
  const int shape = integer(0, 3);
  const double empty = random.Get(0.0, 0.7);
  const bool isBlocked = random.Get(0.0, 1.0) < 0.2;
  const double albedo = random.Get(0.0, 1.0) < 0.7 ? 1.0 : random.Get(0.5, 1.0);
  medium.Blocked.assign(medium.GetNumberOfCells(), 0);
  glm::ivec3 cell(0);
  std::size_t i = 0;
  for (cell.z = 0; cell.z < cells.z; ++cell.z)
  {
    for (cell.y = 0; cell.y < cells.y; ++cell.y)
    {
      for (cell.x = 0; cell.x < cells.x; ++cell.x, ++i)
      {
        const double distance =
          2.0 * glm::length((glm::dvec3(cell) + 0.5) / glm::dvec3(cells) - 0.5);
        const double factor = shape == 0 ? 1.0
          : shape == 1                   ? (random.Get(0.0, 1.0) < empty ? 0.0 : 1.0)
          : shape == 2                   ? std::pow(10.0, random.Get(-3.0, 0.0))
                                         : glm::clamp(3.0 * (1.0 - distance), 0.0, 1.0);
        medium.Extinction[i] *= static_cast<float>(factor);
        medium.Albedo[i].x = static_cast<float>(albedo);
        medium.Albedo[i].y = static_cast<float>(random.Get(0.0, 1.0));
        medium.Blocked[i] = isBlocked && random.Get(0.0, 1.0) < 0.1 ? 1 : 0;
      }
    }
  }
  const std::array<double, 3> direction = random.GetDirection();
  setting.Lights = { MakeLight(medium, glm::make_vec3(direction.data())) };
  if (random.Get(0.0, 1.0) < 0.3)
  {
    const std::array<double, 3> position = random.GetPoint(2.0);
    setting.Lights.push_back(MakeScatteringPointLight(medium, glm::make_vec3(position.data())));
  }
  setting.Settings.BackwardLayers = random.Get(0.0, 1.0) < 0.2 ? integer(1, 4) : 0;
  setting.Settings.AngleVariance = random.Get(-0.1, 0.5);
  std::ostringstream text;
  text << "cells " << cells.x << " " << cells.y << " " << cells.z << ", depth " << depth << ", g "
       << setting.G << ", shape " << shape << ", albedo " << albedo << ", lights "
       << setting.Lights.size() << ", blocked " << isBlocked << ", layers "
       << setting.Settings.BackwardLayers << ", light " << direction[0] << " " << direction[1]
       << " " << direction[2];
  setting.Text = text.str();
  return setting;
}

/// Returns true if all light leaves the medium.
bool IsConserving(const Setting& setting)
{
  const ScatteringMedium& medium = setting.Medium;
  return setting.Settings.BackwardLayers == 0 && medium.Albedo.front().x == 1.0f &&
    std::count(medium.Blocked.begin(), medium.Blocked.end(), 1) == 0;
}

void CheckSeen(Check& check, int number)
{
  double maximum = 0.0;
  double minimum = 2.0;
  int conserving = 0;
  for (int i = 0; i < number; ++i)
  {
    const Setting setting = MakeSetting(static_cast<unsigned>(i));
    const Solved forward =
      Solve(setting.Medium, setting.Lights, ScatteringMode::Forward, setting.Settings);
    const Solved full =
      Solve(setting.Medium, setting.Lights, ScatteringMode::Full, setting.Settings);
    const RadianceSampler seen(setting.Medium, setting.Lights, setting.G);
    const auto find = [&](int rays)
    {
      return seen.GetEnergy(
        { nullptr, &forward.Field, &full.Field }, rays, 1000u + static_cast<unsigned>(i));
    };
    std::vector<RadianceSampler::Energy> energies = find(1024);
    // Suspicious results are computed again with more rays.
    const bool isSuspicious = std::any_of(energies.begin(), energies.end(),
      [](const RadianceSampler::Energy& energy)
      {
        return std::abs(energy.Seen / energy.Incoming - 1.0) >
          0.03 + 2.0 * energy.Error / energy.Incoming;
      });
    if (isSuspicious)
    {
      energies = find(4096);
    }
    const char* const names[] = { "single", "forward", "full" };
    for (std::size_t mode = 0; mode < energies.size(); ++mode)
    {
      const RadianceSampler::Energy& energy = energies[mode];
      const double fraction = energy.Seen / energy.Incoming;
      const double noise = 3.0 * energy.Error / energy.Incoming;
      check.SetContext(
        "setting " + std::to_string(i) + ", " + names[mode] + ", " + setting.Text + ": ");
      check.That(fraction < 1.01 + noise,
        "outgoing fraction " + std::to_string(fraction) + ", noise " + std::to_string(noise));
      if (mode == 2)
      {
        maximum = std::max(maximum, fraction - noise);
        if (IsConserving(setting))
        {
          ++conserving;
          minimum = std::min(minimum, fraction + noise);
          check.That(
            fraction > 0.92 - noise, "outgoing fraction without loss: " + std::to_string(fraction));
        }
      }
    }
    check.SetContext("");
  }
  std::cout << "full, " << number << " settings: at most " << maximum
            << " of the light leaves, and at least " << minimum << " without absorption ("
            << conserving << " settings), three standard deviations subtracted\n";
}

/// Returns a sphere with a sharp boundary. \a depth is the optical depth along its diameter.
ScatteringMedium MakeSphereMedium(int cells, double depth)
{
  constexpr double radius = 0.4;
  constexpr int parts = 4;
  ScatteringMedium medium = MakeMedium(glm::ivec3(cells), 0.0, glm::vec3(1.0f), 0.0);
  const int columns = parts * cells;
  glm::ivec3 part(0);
  for (part.z = 0; part.z < columns; ++part.z)
  {
    for (part.y = 0; part.y < columns; ++part.y)
    {
      for (part.x = 0; part.x < columns; ++part.x)
      {
        const glm::dvec3 position = (glm::dvec3(part) + 0.5) / static_cast<double>(columns) - 0.5;
        medium.Extinction[medium.GetIndex(part / parts)] += glm::length(position) < radius
          ? static_cast<float>(depth / (2.0 * radius) / (parts * parts * parts))
          : 0.0f;
      }
    }
  }
  return medium;
}

/// Without absorption, all extinguished light leaves dense media, within 1 % plus the noise.
void CheckThick(Check& check)
{
  constexpr int rays = 400000;
  const auto expect = [&check](const std::string& name, const ScatteringMedium& medium)
  {
    const std::vector<ScatteringLight> lights{ MakeLight(medium, { 0.3, 0.5, 1.0 }) };
    const Solved solved = Solve(medium, lights, ScatteringMode::Full);
    const RadianceSampler seen(medium, lights, 0.0);
    const RadianceSampler::Energy energy = seen.GetEnergy({ &solved.Field }, rays, 7).front();
    const double fraction = energy.Seen / energy.Incoming;
    const double noise = 2.0 * energy.Error / energy.Incoming;
    std::cout << name << ": " << fraction << " of the light leaves, noise " << noise << "\n";
    check.Near(fraction, 1.0, 0.01 + noise, name + ": outgoing fraction", 1.0);
  };
  for (const double depth : { 20.0, 60.0, 200.0, 1000.0 })
  {
    expect("sphere of depth " + std::to_string(depth), MakeSphereMedium(32, depth));
  }
  for (const int cells : { 8, 32 })
  {
    expect("cloud of depth 200 in " + std::to_string(cells) + " cells",
      MakeCloud(cells, 200.0, glm::vec3(1.0f), 0.0));
  }
}

}

int TestSeenEnergy(int, char*[])
{
  Check check;
  CheckSeen(check, 500);
  CheckThick(check);
  return check.Result();
}
