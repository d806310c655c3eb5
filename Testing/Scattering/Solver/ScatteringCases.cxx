// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/Solver/ScatteringCases.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace reference
{

using namespace interlume;

namespace
{
constexpr double Pi = 3.14159265358979323846;
}

ScatteringMedium MakeMedium(
  const glm::ivec3& cells, double extinction, const glm::vec3& albedo, double g)
{
  ScatteringMedium medium;
  medium.Cells = cells;
  medium.CellSize = glm::dvec3(1.0 / std::max({ cells.x, cells.y, cells.z }));
  medium.Extinction.assign(medium.GetNumberOfCells(), static_cast<float>(extinction));
  medium.Albedo.assign(medium.GetNumberOfCells(), albedo);
  static_cast<void>(medium.Phase.SetHenyeyGreenstein(g));
  return medium;
}

ScatteringMedium MakeCloud(int cells, double depth, const glm::vec3& albedo, double g)
{
  ScatteringMedium medium = MakeMedium(glm::ivec3(cells), 0.0, albedo, g);
  glm::ivec3 cell(0);
  for (cell.z = 0; cell.z < cells; ++cell.z)
  {
    for (cell.y = 0; cell.y < cells; ++cell.y)
    {
      for (cell.x = 0; cell.x < cells; ++cell.x)
      {
        const glm::dvec3 position = (glm::dvec3(cell) + 0.5) / static_cast<double>(cells) - 0.5;
        const double lumps =
          0.05 * std::sin(20.0 * position.x) * std::sin(17.0 * position.y + 3.0 * position.z);
        const double within = 0.4 - glm::length(position) - lumps;
        medium.Extinction[medium.GetIndex(cell)] =
          static_cast<float>(depth / 0.8 * glm::clamp(10.0 * within, 0.0, 1.0));
      }
    }
  }
  return medium;
}

ScatteringLight MakeLight(const ScatteringMedium& medium, const glm::dvec3& direction)
{
  ScatteringLight light;
  light.Direction = glm::normalize(direction);
  light.Fill(medium, glm::vec3(1.0f));
  return light;
}

ScatteringLight MakeScatteringPointLight(const ScatteringMedium& medium, const glm::dvec3& position)
{
  ScatteringLight light;
  light.IsPositional = true;
  light.Position = position;
  light.Fill(medium, glm::vec3(1.0f));
  return light;
}

Solved Solve(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights,
  ScatteringMode mode, const ScatteringSettings& settings)
{
  Solved solved;
  solved.Error =
    ScatteringSolver::Solve(medium, lights, mode, settings, solved.Field, solved.Report);
  if (solved.Error)
  {
    std::cerr << solved.Error << "\n";
  }
  return solved;
}

ScatteringMedium Slab::MakeMedium() const
{
  ScatteringMedium medium = reference::MakeMedium(glm::ivec3(2, 2, this->Layers), this->Depth,
    glm::vec3(static_cast<float>(this->Albedo)), this->G);
  medium.Mirrors = glm::bvec3(true, true, false);
  return medium;
}

ScatteringLight Slab::MakeLight(const ScatteringMedium& medium) const
{
  ScatteringLight light;
  light.Direction = glm::dvec3(std::sqrt(1.0 - this->Cosine * this->Cosine), 0.0, this->Cosine);
  light.Direct.resize(medium.GetNumberOfCells());
  const double depth = this->Depth / this->Layers / this->Cosine;
  for (std::size_t i = 0; i < light.Direct.size(); ++i)
  {
    const double before = depth * static_cast<double>(i / 4);
    light.Direct[i] =
      glm::vec3(static_cast<float>(std::exp(-before) * -std::expm1(-depth) / depth));
  }
  return light;
}

SlabFlux IntegrateSlabFlux(
  const Slab& slab, const ScatteringMedium& medium, const ScatteredLight& field, int parts)
{
  constexpr int cosines = 192;
  constexpr int azimuths = 48;
  const int layers = slab.Layers * parts;
  const double depth = slab.Depth / layers;
  const double across = std::sqrt(1.0 - slab.Cosine * slab.Cosine);
  SlabFlux flux;
  for (int c = 0; c < cosines; ++c)
  {
    const double mu = (c + 0.5) / cosines;
    for (const int side : { -1, 1 })
    {
      double phase = 0.0;
      for (int azimuth = 0; azimuth < azimuths; ++azimuth)
      {
        const double cosine = side * mu * slab.Cosine +
          std::sqrt(1.0 - mu * mu) * across * std::cos(2.0 * Pi * (azimuth + 0.5) / azimuths);
        phase += 4.0 * Pi * medium.Phase.Value(cosine) / azimuths;
      }
      double light = 0.0;
      for (int i = 0; i < layers; ++i)
      {
        const int layer = side > 0 ? i : layers - 1 - i;
        const std::size_t cell = static_cast<std::size_t>(layer / parts) * 4;
        const double path = depth / slab.Cosine;
        const double direct = std::exp(-path * layer) * -std::expm1(-path) / path;
        const double forward = field.Forward.empty() ? 0.0 : field.Forward[0][cell].x;
        const double source = slab.Albedo *
          ((direct + forward) * phase +
            field.Fluence[cell].x *
              (1.0 + 3.0 * slab.G * field.NetFlux[cell].z * static_cast<double>(side) * mu));
        light = light * std::exp(-depth / mu) - source * std::expm1(-depth / mu);
      }
      (side < 0 ? flux.Reflected : flux.Transmitted) += 0.5 * mu * light / cosines / slab.Cosine;
    }
  }
  return flux;
}

}
