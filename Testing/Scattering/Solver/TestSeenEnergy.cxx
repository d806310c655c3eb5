// SPDX-License-Identifier: BSD-3-Clause
// Eyes around a medium see no more light than matter takes from the lights, whatever the settings.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Scattering/Solver/ScatteringCases.h"
#include "Scattering/Solver/SeenLight.h"

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
  const auto whole = [&random](int lower, int upper)
  { return static_cast<int>(random.Get(lower, upper + 0.999)); };
  Setting setting;
  const glm::ivec3 cells(whole(1, 8), whole(1, 8), whole(1, 8));
  const double depth = std::pow(10.0, random.Get(-2.0, 4.0));
  setting.G = random.Get(-0.95, 0.95);
  setting.Medium = MakeMedium(cells, depth, glm::vec3(1.0f), setting.G);
  ScatteringMedium& medium = setting.Medium;
  const int shape = whole(0, 3);
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
        const double away = 2.0 * glm::length((glm::dvec3(cell) + 0.5) / glm::dvec3(cells) - 0.5);
        const double factor = shape == 0 ? 1.0
          : shape == 1                   ? (random.Get(0.0, 1.0) < empty ? 0.0 : 1.0)
          : shape == 2                   ? std::pow(10.0, random.Get(-3.0, 0.0))
                                         : glm::clamp(3.0 * (1.0 - away), 0.0, 1.0);
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
    const std::array<double, 3> place = random.GetPoint(2.0);
    setting.Lights.push_back(MakeLightAt(medium, glm::make_vec3(place.data())));
  }
  setting.Settings.BackwardLayers = random.Get(0.0, 1.0) < 0.2 ? whole(1, 4) : 0;
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

/// Whether all of the light comes out again.
bool IsConserving(const Setting& setting)
{
  const ScatteringMedium& medium = setting.Medium;
  return setting.Settings.BackwardLayers == 0 && medium.Albedo.front().x == 1.0f &&
    std::count(medium.Blocked.begin(), medium.Blocked.end(), 1) == 0;
}

void CheckSeen(Check& check, int number)
{
  double most = 0.0;
  double least = 2.0;
  int conserving = 0;
  for (int i = 0; i < number; ++i)
  {
    const Setting setting = MakeSetting(static_cast<unsigned>(i));
    const Solved forward =
      Solve(setting.Medium, setting.Lights, ScatteringMode::Forward, setting.Settings);
    const Solved full =
      Solve(setting.Medium, setting.Lights, ScatteringMode::Full, setting.Settings);
    const SeenLight seen(setting.Medium, setting.Lights, setting.G);
    const auto find = [&](int rays)
    {
      return seen.GetEnergy(
        { nullptr, &forward.Field, &full.Field }, rays, 1000u + static_cast<unsigned>(i));
    };
    std::vector<SeenLight::Energy> energies = find(1024);
    // What stands out is looked at again, with more rays.
    const bool standsOut = std::any_of(energies.begin(), energies.end(),
      [](const SeenLight::Energy& energy)
      {
        return std::abs(energy.Seen / energy.Incoming - 1.0) >
          0.03 + 2.0 * energy.Error / energy.Incoming;
      });
    if (standsOut)
    {
      energies = find(4096);
    }
    const char* const names[] = { "single", "forward", "full" };
    for (std::size_t mode = 0; mode < energies.size(); ++mode)
    {
      const SeenLight::Energy& energy = energies[mode];
      const double share = energy.Seen / energy.Incoming;
      const double noise = 3.0 * energy.Error / energy.Incoming;
      check.SetContext(
        "setting " + std::to_string(i) + ", " + names[mode] + ", " + setting.Text + ": ");
      check.That(share < 1.01 + noise,
        "seen of 1: " + std::to_string(share) + ", noise " + std::to_string(noise));
      if (mode == 2)
      {
        most = std::max(most, share - noise);
        if (IsConserving(setting))
        {
          ++conserving;
          least = std::min(least, share + noise);
          check.That(share > 0.92 - noise, "seen of all: " + std::to_string(share));
        }
      }
    }
    check.SetContext("");
  }
  std::cout << "full, " << number << " settings: at most " << most << " of the light is seen, and "
            << least << " at least where nothing is absorbed (" << conserving
            << "), three standard deviations off\n";
}

/// A ball with a sharp surface, of that depth through its middle.
ScatteringMedium MakeBall(int cells, double depth)
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
        const glm::dvec3 place = (glm::dvec3(part) + 0.5) / static_cast<double>(columns) - 0.5;
        medium.Extinction[medium.GetIndex(part / parts)] += glm::length(place) < radius
          ? static_cast<float>(depth / (2.0 * radius) / (parts * parts * parts))
          : 0.0f;
      }
    }
  }
  return medium;
}

/// Thick matter that absorbs nothing sends out what it takes, within a percent and the noise.
void CheckThick(Check& check)
{
  constexpr int rays = 400000;
  const auto expect = [&check](const std::string& name, const ScatteringMedium& medium)
  {
    const std::vector<ScatteringLight> lights{ MakeLight(medium, { 0.3, 0.5, 1.0 }) };
    const Solved solved = Solve(medium, lights, ScatteringMode::Full);
    const SeenLight seen(medium, lights, 0.0);
    const SeenLight::Energy energy = seen.GetEnergy({ &solved.Field }, rays, 7).front();
    const double share = energy.Seen / energy.Incoming;
    const double noise = 2.0 * energy.Error / energy.Incoming;
    std::cout << name << ": " << share << " of the light is seen, noise " << noise << "\n";
    check.Near(share, 1.0, 0.01 + noise, name + ": light that is seen", 1.0);
  };
  for (const double depth : { 20.0, 60.0, 200.0, 1000.0 })
  {
    expect("ball of depth " + std::to_string(depth), MakeBall(32, depth));
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
