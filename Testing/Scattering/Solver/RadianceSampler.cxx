// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/Solver/RadianceSampler.h"

#include "Support/Checks/ReferenceRandom.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reference
{

using namespace interlume;

namespace
{
constexpr double Pi = 3.14159265358979323846;

glm::dvec3 GetDirection(Random& random)
{
  const std::array<double, 3> direction = random.GetDirection();
  return glm::make_vec3(direction.data());
}
}

/// Visits the cells along a ray. Positions are in units of cells from the lower corner, and lengths
/// are in world units.
class RadianceSampler::Walk
{
public:
  Walk(const ScatteringMedium& medium, const glm::dvec3& position, const glm::dvec3& direction)
    : Medium(medium)
    , Position(position)
    , Speed(direction / medium.CellSize)
    , Cell(glm::clamp(glm::ivec3(glm::floor(position)), glm::ivec3(0), medium.Cells - 1))
  {
    this->FindExit();
  }

  bool Next()
  {
    this->Entry = this->Exit;
    this->Cell[this->Axis] += this->Speed[this->Axis] > 0.0 ? 1 : -1;
    if (this->Cell[this->Axis] < 0 || this->Cell[this->Axis] >= this->Medium.Cells[this->Axis])
    {
      return false;
    }
    this->FindExit();
    return true;
  }

  std::size_t GetIndex() const { return this->Medium.GetIndex(this->Cell); }
  double GetExtinction() const { return this->Medium.Extinction[this->GetIndex()]; }
  bool IsBlocked() const { return this->Medium.IsBlocked(this->GetIndex()); }
  glm::dvec3 GetPosition(double distance) const { return this->Position + distance * this->Speed; }

  double Entry = 0.0;
  double Exit = 0.0;

private:
  void FindExit()
  {
    this->Exit = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Speed[axis] != 0.0)
      {
        const double border = this->Cell[axis] + (this->Speed[axis] > 0.0 ? 1.0 : 0.0);
        const double to = (border - this->Position[axis]) / this->Speed[axis];
        if (to < this->Exit)
        {
          this->Exit = to;
          this->Axis = axis;
        }
      }
    }
    this->Exit = std::max(this->Exit, this->Entry);
  }

  const ScatteringMedium& Medium;
  glm::dvec3 Position;
  glm::dvec3 Speed;
  glm::ivec3 Cell;
  int Axis = 0;
};

RadianceSampler::RadianceSampler(
  const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights, double g)
  : Medium(medium)
  , Lights(lights)
  , Anisotropy(g)
{
}

double RadianceSampler::GetPhase(double cosine) const
{
  const double g = this->Anisotropy;
  const double square = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (square * std::sqrt(square));
}

glm::dvec3 RadianceSampler::Scatter(const glm::dvec3& direction, Random& random) const
{
  const double g = this->Anisotropy;
  const double fraction = random.Get(0.0, 1.0);
  double cosine = 2.0 * fraction - 1.0;
  if (std::abs(g) > 1e-3)
  {
    const double part = (1.0 - g * g) / (1.0 - g + 2.0 * g * fraction);
    cosine = (1.0 + g * g - part * part) / (2.0 * g);
  }
  glm::dvec3 across = glm::cross(direction, GetDirection(random));
  across /= std::max(glm::length(across), 1e-12);
  return cosine * direction + std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) * across;
}

glm::dvec3 RadianceSampler::SampleBoundary(
  const glm::dvec3& direction, Random& random, double& area) const
{
  const glm::dvec3 size = glm::dvec3(this->Medium.Cells) * this->Medium.CellSize;
  const glm::dvec3 areas =
    glm::abs(direction) * glm::dvec3(size.y * size.z, size.z * size.x, size.x * size.y);
  area = areas.x + areas.y + areas.z;
  const double pick = random.Get(0.0, area);
  const int axis = pick < areas.x ? 0 : pick < areas.x + areas.y ? 1 : 2;
  glm::dvec3 position(random.Get(0.0, 1.0), random.Get(0.0, 1.0), random.Get(0.0, 1.0));
  position[axis] = direction[axis] > 0.0 ? 0.0 : 1.0;
  return position * glm::dvec3(this->Medium.Cells);
}

double RadianceSampler::SampleIncomingLight(std::size_t light, Random& random) const
{
  const ScatteringLight& source = this->Lights[light];
  glm::dvec3 position;
  glm::dvec3 direction = source.Direction;
  double weight = 0.0;
  double start = 0.0;
  if (!source.IsPositional)
  {
    position = this->SampleBoundary(direction, random, weight);
  }
  else
  {
    const glm::dvec3 at = (source.Position - this->Medium.Origin) / this->Medium.CellSize;
    position = at;
    weight = 4.0 * Pi;
    direction = GetDirection(random);
    if (glm::any(glm::lessThan(at, glm::dvec3(0.0))) ||
      glm::any(glm::greaterThan(at, glm::dvec3(this->Medium.Cells))))
    {
      // Sample only the faces that the light illuminates.
      glm::dvec3 toward;
      for (int axis = 0; axis < 3; ++axis)
      {
        toward[axis] = at[axis] < 0.0 ? 1.0 : at[axis] > this->Medium.Cells[axis] ? -1.0 : 0.0;
      }
      position = this->SampleBoundary(toward, random, weight);
      direction = (position - at) * this->Medium.CellSize;
      start = glm::length(direction);
      direction /= start;
      const glm::dvec3 cells(this->Medium.Cells);
      double cosine = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double side = toward[axis] > 0.0 ? 0.0 : cells[axis];
        cosine = toward[axis] != 0.0 && position[axis] == side ? std::abs(direction[axis]) : cosine;
      }
      weight *= cosine / (start * start);
    }
  }
  double transmittance = 1.0;
  double incoming = 0.0;
  Walk walk(this->Medium, position, direction);
  do
  {
    if (walk.IsBlocked())
    {
      break;
    }
    const double extinction = walk.GetExtinction();
    const double opacity = -std::expm1(-extinction * (walk.Exit - walk.Entry));
    if (opacity > 0.0)
    {
      const double depth = -std::log1p(-opacity * random.Get(0.0, 1.0)) / extinction;
      const double distance = start + walk.Entry + std::min(depth, walk.Exit - walk.Entry);
      incoming += transmittance * opacity * (source.IsPositional ? distance * distance : 1.0);
    }
    transmittance *= 1.0 - opacity;
  } while (walk.Next());
  return weight * incoming;
}

double RadianceSampler::GetTransmittance(std::size_t light, const glm::dvec3& position) const
{
  const ScatteringLight& source = this->Lights[light];
  const glm::dvec3 world = this->Medium.Origin + position * this->Medium.CellSize;
  const double reach =
    source.IsPositional ? glm::length(world - source.Position) : std::numeric_limits<double>::max();
  double depth = 0.0;
  Walk walk(this->Medium, position, -source.GetDirection(world));
  do
  {
    if (walk.IsBlocked())
    {
      return 0.0;
    }
    depth += walk.GetExtinction() * (std::min(walk.Exit, reach) - walk.Entry);
  } while (walk.Exit < reach && depth < 50.0 && walk.Next());
  return std::exp(-depth);
}

double RadianceSampler::GetSource(const glm::dvec3& position, const glm::dvec3& out,
  const ScatteredLight* field, const std::vector<double>& phases,
  const std::vector<double>& lights) const
{
  double sum = 0.0;
  for (std::size_t light = 0; light < lights.size(); ++light)
  {
    sum += phases[light] * lights[light];
  }
  if (!field)
  {
    return sum;
  }
  const glm::dvec3 at =
    glm::clamp(position - 0.5, glm::dvec3(0.0), glm::dvec3(this->Medium.Cells - 1));
  const glm::ivec3 lower(at);
  const glm::dvec3 fraction = at - glm::dvec3(lower);
  double fluence = 0.0;
  glm::dvec3 netFlux(0.0);
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    glm::ivec3 cell = lower;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = (corner >> axis & 1u) != 0;
      weight *= isUpper ? fraction[axis] : 1.0 - fraction[axis];
      cell[axis] = std::min(cell[axis] + (isUpper ? 1 : 0), this->Medium.Cells[axis] - 1);
    }
    if (weight > 0.0)
    {
      const std::size_t index = this->Medium.GetIndex(cell);
      fluence += weight * field->Fluence[index].x;
      netFlux += weight * glm::dvec3(field->NetFlux[index]);
      for (std::size_t light = 0; light < field->Forward.size(); ++light)
      {
        sum += weight * phases[light] * field->Forward[light][index].x;
      }
    }
  }
  return sum + fluence * std::max(1.0 + 3.0 * this->Anisotropy * glm::dot(netFlux, out), 0.0);
}

void RadianceSampler::TraceRay(const glm::dvec3& position, const glm::dvec3& direction,
  const std::vector<const ScatteredLight*>& fields, Random& random, std::vector<double>& seen,
  double& transmittance) const
{
  std::fill(seen.begin(), seen.end(), 0.0);
  transmittance = 1.0;
  std::vector<double> phases(this->Lights.size());
  std::vector<double> lights(this->Lights.size());
  Walk walk(this->Medium, position, direction);
  do
  {
    if (walk.IsBlocked())
    {
      transmittance = 0.0;
      return;
    }
    const double extinction = walk.GetExtinction();
    const double opacity = -std::expm1(-extinction * (walk.Exit - walk.Entry));
    if (opacity > 0.0)
    {
      const double depth = -std::log1p(-opacity * random.Get(0.0, 1.0)) / extinction;
      const glm::dvec3 at = walk.GetPosition(walk.Entry + std::min(depth, walk.Exit - walk.Entry));
      const glm::dvec3 world = this->Medium.Origin + at * this->Medium.CellSize;
      for (std::size_t light = 0; light < phases.size(); ++light)
      {
        phases[light] =
          this->GetPhase(glm::dot(this->Lights[light].GetDirection(world), -direction));
        lights[light] = this->GetTransmittance(light, at);
      }
      const double weight = transmittance * opacity * this->Medium.Albedo[walk.GetIndex()].x;
      for (std::size_t i = 0; i < fields.size(); ++i)
      {
        seen[i] += weight * this->GetSource(at, -direction, fields[i], phases, lights);
      }
      transmittance *= 1.0 - opacity;
    }
  } while (transmittance > 1e-6 && walk.Next());
}

std::vector<RadianceSampler::Energy> RadianceSampler::GetEnergy(
  const std::vector<const ScatteredLight*>& fields, int rays, unsigned seed) const
{
  constexpr int batches = 16;
  Random random(seed);
  const bool hasPointLights = std::any_of(this->Lights.begin(), this->Lights.end(),
    [](const ScatteringLight& light) { return light.IsPositional; });
  std::vector<Energy> result(fields.size());
  std::vector<double> squares(fields.size(), 0.0);
  std::vector<double> seen(fields.size());
  for (int batch = 0; batch < batches; ++batch)
  {
    double incoming = 0.0;
    std::vector<double> sums(fields.size(), 0.0);
    for (int ray = 0; ray < rays / batches; ++ray)
    {
      for (std::size_t light = 0; light < this->Lights.size(); ++light)
      {
        incoming += this->SampleIncomingLight(light, random);
      }
      // Without point lights, half of the ray directions are distributed like the single scattering
      // of the lights.
      glm::dvec3 out = GetDirection(random);
      double density = 1.0;
      if (!hasPointLights)
      {
        const std::size_t light = static_cast<std::size_t>(ray / 2) % this->Lights.size();
        out = ray % 2 == 0 ? out : this->Scatter(this->Lights[light].Direction, random);
        density = 0.5;
        for (const ScatteringLight& other : this->Lights)
        {
          density += 0.5 * this->GetPhase(glm::dot(other.Direction, out)) /
            static_cast<double>(this->Lights.size());
        }
      }
      double area = 0.0;
      double transmittance = 1.0;
      const glm::dvec3 position = this->SampleBoundary(-out, random, area);
      this->TraceRay(position, -out, fields, random, seen, transmittance);
      for (std::size_t i = 0; i < fields.size(); ++i)
      {
        sums[i] += area / density * seen[i];
      }
    }
    const double scale = static_cast<double>(batches) / rays;
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      result[i].Incoming += scale * incoming / batches;
      result[i].Seen += scale * sums[i] / batches;
      squares[i] += std::pow(scale * (sums[i] - incoming), 2.0) / batches;
    }
  }
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    const double difference = result[i].Seen - result[i].Incoming;
    result[i].Error =
      std::sqrt(std::max(squares[i] - difference * difference, 0.0) / (batches - 1));
  }
  return result;
}

}
