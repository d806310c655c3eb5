// SPDX-License-Identifier: BSD-3-Clause
// Mode FORWARD: the lateral variance of a light beam follows the theory of small-angle multiple
// scattering for any number of layers, and the light per layer follows the one-dimensional
// equation.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Scattering/Solver/ScatteringCases.h"

#include "Scattering/ForwardLight.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <iostream>
#include <tuple>

namespace
{

using namespace reference;
using namespace interlume;

constexpr double Depth = 3.0;
constexpr double Variance = 0.004;

/// A beam in the central column of cells of a box, parallel to an axis.
struct Pencil
{
  Pencil(int lateral, int along, int axis, bool isBackwards)
    : Axis(axis)
    , IsBackwards(isBackwards)
  {
    glm::ivec3 cells(lateral);
    cells[axis] = along;
    this->Medium = MakeMedium(cells, Depth, glm::vec3(1.0f), 0.9);
    this->Medium.CellSize = 1.0 / glm::dvec3(cells);
    this->Light.Direction = glm::dvec3(0.0);
    this->Light.Direction[axis] = isBackwards ? -1.0 : 1.0;
    this->Light.Fill(this->Medium, glm::vec3(1.0f));
    for (std::size_t i = 0; i < this->Light.Direct.size(); ++i)
    {
      glm::ivec3 cell = this->GetCell(i);
      cell[axis] = lateral / 2;
      this->Light.Direct[i] *= cell == glm::ivec3(lateral / 2) ? 1.0f : 0.0f;
    }
  }

  glm::ivec3 GetCell(std::size_t index) const
  {
    const glm::ivec3& cells = this->Medium.Cells;
    const int number = static_cast<int>(index);
    return { number % cells.x, number / cells.x % cells.y, number / (cells.x * cells.y) };
  }

  /// Sums over the cells of a layer: direct light, scattered light, and scattered light times its
  /// squared lateral distance from the center.
  void Measure(const std::vector<glm::vec3>& forward, int layer, double& direct, double& scattered,
    double& squares) const
  {
    direct = scattered = squares = 0.0;
    const int across = (this->Axis + 1) % 3;
    for (std::size_t i = 0; i < this->Light.Direct.size(); ++i)
    {
      const glm::ivec3 cell = this->GetCell(i);
      const int position = this->IsBackwards ? this->Medium.Cells[this->Axis] - 1 - cell[this->Axis]
                                             : cell[this->Axis];
      if (position == layer)
      {
        const double distance =
          (cell[across] - this->Medium.Cells[across] / 2) * this->Medium.CellSize[across];
        direct += this->Light.Direct[i].x;
        scattered += forward[i].x;
        squares += distance * distance * forward[i].x;
      }
    }
  }

  int Axis;
  bool IsBackwards;
  ScatteringMedium Medium;
  ScatteringLight Light;
};

void CheckSpread(Check& check)
{
  // The last two printed columns are the largest relative errors of variance and sum, for layers
  // beyond a quarter of the depth.
  std::cout << "lateral along axis  largest error of variance, of sum\n";
  for (const auto& [lateral, along, axis, isBackwards, bound] :
    std::vector<std::tuple<int, int, int, bool, double>>{ { 33, 32, 2, false, 3e-4 },
      { 33, 64, 2, false, 4e-5 }, { 65, 32, 0, true, 3e-4 }, { 65, 64, 1, false, 4e-5 } })
  {
    const Pencil pencil(lateral, along, axis, isBackwards);
    const double fraction = pencil.Medium.Phase.ForwardFraction();
    int layers = 0;
    const std::vector<glm::vec3> forward = ForwardLight::Solve(
      SanitizedMedium(pencil.Medium, { pencil.Light }), 0, fraction, Variance, layers);
    check.Equal(layers, along, "number of layers");
    double worst = 0.0;
    double worstSum = 0.0;
    for (int layer = along / 4; layer < along; ++layer)
    {
      double direct = 0.0;
      double scattered = 0.0;
      double squares = 0.0;
      pencil.Measure(forward, layer, direct, scattered, squares);
      const double position = (layer + 0.5) / along;
      const double sum =
        std::exp(-Depth * (1.0 - fraction) * position) - std::exp(-Depth * position);
      reference::KeepLargest(worstSum, std::abs(scattered / sum - 1.0));
      // The angular variance, averaged over direct and scattered light, grows linearly with depth.
      // The lateral variance therefore grows with the cube of the depth.
      const double variance = Variance * Depth * fraction * position * position * position / 3.0;
      reference::KeepLargest(worst, std::abs(squares / (direct + scattered) / variance - 1.0));
    }
    std::cout << lateral << " " << along << " " << axis << "  " << worst << " " << worstSum << "\n";
    check.Near(worst, 0.0, bound, "error of the lateral variance", 1.0);
    check.Near(worstSum, 0.0, 4e-4, "error of the sum over a layer", 1.0);
  }
}

/// Oblique light: the centroid of scattered light follows the light direction, and no energy is
/// gained.
void CheckOblique(Check& check)
{
  for (const glm::dvec3& given :
    { glm::dvec3(1.0, 0.0, 2.0), glm::dvec3(-1.0, 2.0, -2.0), glm::dvec3(1.0, 1.0, 1.0) })
  {
    const ScatteringMedium medium = MakeCloud(24, 8.0, glm::vec3(1.0f, 0.9f, 0.5f), 0.8);
    const ScatteringLight light = MakeLight(medium, given);
    const Solved solved = Solve(medium, { light }, ScatteringMode::Forward);
    check.Near(solved.GetSum() / solved.Report.Taken, 1.0, 1e-5, "sum of the energy");
    check.That(
      solved.Report.Transmitted > 0.1 * solved.Report.Taken, "light passes through the cloud");
    glm::dvec3 centroid(0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < medium.GetNumberOfCells(); ++i)
    {
      const int number = static_cast<int>(i);
      const glm::dvec3 position(number % 24, number / 24 % 24, number / 576);
      sum += solved.Field.Forward[0][i].x;
      centroid += (position - 11.5) * static_cast<double>(solved.Field.Forward[0][i].x);
    }
    centroid /= sum;
    check.That(glm::dot(centroid, light.Direction) > 0.8 * glm::length(centroid),
      "the centroid of scattered light is displaced along the light direction");
  }
}

/// A distant point light is equivalent to a directional light, and a light inside the medium causes
/// symmetric scattering.
void CheckLocations(Check& check)
{
  const ScatteringMedium medium = MakeCloud(20, 6.0, glm::vec3(1.0f), 0.7);
  const ScatteringLight far = MakeScatteringPointLight(medium, glm::dvec3(0.5, 0.5, -1000.0));
  const ScatteringLight along = MakeLight(medium, glm::dvec3(0.0, 0.0, 1.0));
  ScatteringSettings settings;
  settings.AngleVariance = Variance;
  const Solved one = Solve(medium, { far }, ScatteringMode::Forward, settings);
  const Solved other = Solve(medium, { along }, ScatteringMode::Forward, settings);
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < medium.GetNumberOfCells(); ++i)
  {
    sum += other.Field.Forward[0][i].x;
    difference += std::abs(one.Field.Forward[0][i].x - other.Field.Forward[0][i].x);
  }
  std::cout << "far point light against directional light: " << difference / sum << "\n";
  check.Near(difference / sum, 0.0, 0.05, "a far point light", 1.0);

  const ScatteringMedium homogeneous = MakeMedium(glm::ivec3(15), 4.0, glm::vec3(1.0f), 0.7);
  const Solved inside = Solve(homogeneous,
    { MakeScatteringPointLight(homogeneous, glm::dvec3(0.5)) }, ScatteringMode::Forward);
  const std::vector<glm::vec3>& forward = inside.Field.Forward[0];
  const auto at = [&](int x, int y, int z) { return forward[homogeneous.GetIndex({ x, y, z })].x; };
  check.That(at(7, 7, 12) > 0.1f, "a light inside is forward-scattered");
  check.Near(at(7, 7, 2), at(7, 7, 12), 1e-5, "symmetric to both sides");
  check.Near(at(12, 7, 7), at(7, 7, 12), 0.02, "symmetric along the axes");
  check.Near(at(2, 2, 2), at(12, 12, 12), 0.02, "symmetric along diagonals");
}

}

int TestForwardLight(int, char*[])
{
  Check check;
  CheckSpread(check);
  CheckOblique(check);
  CheckLocations(check);
  return check.Result();
}
