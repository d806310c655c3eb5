// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/OrdinateSweep.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"
#include "Scattering/MediumLoop.h"

#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace interlume
{

namespace
{

constexpr std::size_t Octants = 8;
/// Decay rate of the sweep's weight, per unit of a cell's optical depth. Tests constrain it
/// from both sides: at 1 the corners of a uniformly lit cube are too bright; at 2 the result
/// depends too much on the cell size.
constexpr float DepthFalloff = 1.5f;

/// S4 directions in the first octant. The second moments of all directions equal those of the
/// uniform distribution on the sphere.
constexpr double Low = 0.3500212;
constexpr double High = 0.8688903;
const std::array<glm::dvec3, 3> Ordinates = { { { High, Low, Low }, { Low, High, Low },
  { Low, Low, High } } };
constexpr float OrdinateWeight = 1.0f / (Octants * 3);

/// Light that a cell scatters into direction w per unit length, Isotropic + Linear . w, and the
/// delta-scaled extinction of the cell.
struct Source
{
  glm::vec4 Isotropic{ 0.0f };
  std::array<glm::vec4, 3> Linear{};
  glm::vec4 Extinction{ 0.0f };
};

std::vector<Source> MakeSources(const SanitizedMedium& medium, const DiffuseLight::Input& input,
  const DiffuseLight::Output& output)
{
  const ScatteringMedium& box = medium.Box;
  const auto isotropic = static_cast<float>(1.0 - input.Peak);
  const auto linear = static_cast<float>(3.0 * (input.Cosine - input.Peak));
  std::vector<Source> sources(medium.Extinction.size());
  ForEachOccupiedCell(medium,
    [&](const glm::ivec3& cell, std::size_t at)
    {
      const float extinction = medium.Extinction[at];
      const glm::dvec3 center = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
      glm::vec3 sum = output.Mean[at];
      std::array<glm::vec3, 3> flux{};
      for (int axis = 0; axis < 3; ++axis)
      {
        flux[static_cast<std::size_t>(axis)] = output.NetFlux[at][axis] * output.Mean[at];
      }
      for (std::size_t light = 0; light < input.Lights.size(); ++light)
      {
        const glm::vec3& here = input.Lights[light][at];
        const glm::vec3 way(medium.Lights[light].GetDirection(center));
        sum += here;
        for (int axis = 0; axis < 3; ++axis)
        {
          flux[static_cast<std::size_t>(axis)] += way[axis] * here;
        }
      }
      Source& source = sources[at];
      const glm::vec3 scattered = extinction * medium.Albedo[at];
      source.Isotropic = glm::vec4(isotropic * scattered * sum, 0.0f);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        source.Linear[axis] = glm::vec4(linear * scattered * flux[axis], 0.0f);
      }
      source.Extinction =
        glm::vec4(extinction - scattered * static_cast<float>(input.Peak), extinction);
    });
  return sources;
}

/// Sweeps the cells along the directions of one octant.
class OctantSweep
{
public:
  OctantSweep(const SanitizedMedium& medium, const std::vector<Source>& sources, std::size_t octant)
    : Box(medium.Box)
    , Sources(sources)
    , Signs(octant & 1u ? -1.0 : 1.0, octant & 2u ? -1.0 : 1.0, octant & 4u ? -1.0 : 1.0)
    , Light(sources.size())
    , Means(sources.size(), glm::vec4(0.0f))
    , Fluxes(sources.size(), glm::vec3(0.0f))
  {
  }

  void Run()
  {
    for (const glm::dvec3& ordinate : Ordinates)
    {
      this->SweepDirection(this->Signs * ordinate);
    }
  }

  const glm::vec4& GetMean(std::size_t cell) const { return this->Means[cell]; }
  /// Returns the flux, summed over the color channels.
  const glm::vec3& GetFlux(std::size_t cell) const { return this->Fluxes[cell]; }

private:
  void SweepDirection(const glm::dvec3& way)
  {
    const glm::ivec3& cells = this->Box.Cells;
    const glm::ivec3 steps(this->Signs);
    const std::array<std::ptrdiff_t, 3> back = { { -steps.x,
      -static_cast<std::ptrdiff_t>(steps.y) * cells.x,
      -static_cast<std::ptrdiff_t>(steps.z) * cells.x * cells.y } };
    const glm::vec3 speed(glm::abs(way) / this->Box.CellSize);
    const float totalSpeed = speed.x + speed.y + speed.z;
    const glm::vec3 direction(way);
    glm::ivec3 passed;
    for (passed.z = 0; passed.z < cells.z; ++passed.z)
    {
      for (passed.y = 0; passed.y < cells.y; ++passed.y)
      {
        for (passed.x = 0; passed.x < cells.x; ++passed.x)
        {
          const glm::ivec3 cell(steps.x > 0 ? passed.x : cells.x - 1 - passed.x,
            steps.y > 0 ? passed.y : cells.y - 1 - passed.y,
            steps.z > 0 ? passed.z : cells.z - 1 - passed.z);
          const std::size_t at = this->Box.GetIndex(cell);
          const glm::vec4* here = this->Light.data() + at;
          glm::vec4 light(0.0f);
          for (int axis = 0; axis < 3; ++axis)
          {
            light += passed[axis] > 0 ? speed[axis] * here[back[static_cast<std::size_t>(axis)]]
                                      : glm::vec4(0.0f);
          }
          const Source& source = this->Sources[at];
          light += glm::max(source.Isotropic + direction.x * source.Linear[0] +
              direction.y * source.Linear[1] + direction.z * source.Linear[2],
            0.0f);
          light =
            this->Box.IsBlocked(at) ? glm::vec4(0.0f) : light / (totalSpeed + source.Extinction);
          this->Light[at] = light;
          light *= OrdinateWeight;
          this->Means[at] += light;
          this->Fluxes[at] += (light.x + light.y + light.z) * direction;
        }
      }
    }
  }

  const ScatteringMedium& Box;
  const std::vector<Source>& Sources;
  glm::dvec3 Signs;
  /// Radiance in the current direction.
  std::vector<glm::vec4> Light;
  std::vector<glm::vec4> Means;
  std::vector<glm::vec3> Fluxes;
};

}

void OrdinateSweep::Improve(
  const SanitizedMedium& medium, const DiffuseLight::Input& input, DiffuseLight::Output& output)
{
  if (glm::any(medium.Box.Mirrors))
  {
    return;
  }
  const std::vector<Source> sources = MakeSources(medium, input, output);
  std::vector<OctantSweep> sweeps;
  sweeps.reserve(Octants);
  for (std::size_t octant = 0; octant < Octants; ++octant)
  {
    sweeps.emplace_back(medium, sources, octant);
  }
  ParallelFor(0, static_cast<vtkIdType>(Octants), 1,
    [&sweeps](vtkIdType octant) { sweeps[static_cast<std::size_t>(octant)].Run(); });
  const auto size = static_cast<float>(Vectors::InfinityNorm(medium.Box.CellSize));
  for (std::size_t cell = 0; cell < sources.size(); ++cell)
  {
    glm::vec3 mean(0.0f);
    glm::vec3 flux(0.0f);
    for (const OctantSweep& sweep : sweeps)
    {
      mean += glm::vec3(sweep.GetMean(cell));
      flux += sweep.GetFlux(cell);
    }
    const float sum = mean.x + mean.y + mean.z;
    const glm::vec3 netFlux = sum > 0.0f ? flux / sum : glm::vec3(0.0f);
    const glm::vec3 limited = netFlux / std::max(1.0f, 3.0f * glm::length(netFlux));
    const float depth = size * medium.Extinction[cell] * static_cast<float>(1.0 - input.Peak);
    const float weight = std::exp(-DepthFalloff * depth);
    output.Fluence[cell] += weight * (mean - output.Fluence[cell]);
    output.Mean[cell] += weight * (mean - output.Mean[cell]);
    output.NetFlux[cell] += weight * (limited - output.NetFlux[cell]);
  }
}

}
