// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/SingleScatteringEscape.h"

#include "Common/Vectors.h"
#include "Scattering/CellRay.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace interlume
{

namespace
{

/// Number of paths per light, and number of paths each time a cell is selected. The escaping
/// fraction of a cell is a ratio of two sums over its paths, which is biased if there are too few:
/// thick cells would lose too little light.
constexpr int Paths = 16384;
constexpr int PathsOfCell = 16;
constexpr std::size_t Angles = 4096;

/// A low-discrepancy sequence of six numbers between 0 and 1 per path.
class PathNumbers
{
public:
  explicit PathNumbers(std::size_t path)
    : Path(static_cast<double>(path))
  {
  }
  double Next()
  {
    // The root of x^7 = x + 1, which generates the sequence.
    this->Factor /= 1.1127756842787055;
    const double position = 0.5 + this->Path * this->Factor;
    return position - std::floor(position);
  }

private:
  double Path;
  double Factor = 1.0;
};

/// Follows the paths of one light.
class LightPaths
{
public:
  LightPaths(const SanitizedMedium& medium, const ScatteringLight& light,
    const std::vector<double>& cumulative, const glm::dvec3& back)
    : Medium(medium)
    , Light(light)
    , CumulativeProbability(cumulative)
    , MainDirection(back)
    , LightPosition((light.Position - medium.Box.Origin) / medium.Box.CellSize)
  {
  }

  /// Weight of all light scattered by a cell, and weights of the parts that escape or end in
  /// blocked cells.
  struct Out
  {
    double All = 0.0;
    double Backward = 0.0;
    double Forward = 0.0;
    double Blocked = 0.0;
  };

  void Follow(const glm::ivec3& cell, PathNumbers numbers, Out& out) const
  {
    const ScatteringMedium& box = this->Medium.Box;
    glm::dvec3 position(0.0);
    glm::dvec3 way(0.0);
    double incident = 1.0;
    if (this->Start(cell, numbers, position, way))
    {
      incident = this->GetTransmittance(position, way, cell);
    }
    const double extinction = this->Medium.Extinction[box.GetIndex(cell)];
    const double length = GetLength(box, cell, position, way);
    const double extinguished = -std::expm1(-extinction * length);
    const double weight = incident * extinguished;
    if (!(weight > 0.0))
    {
      return;
    }
    const double depth = -std::log1p(-numbers.Next() * extinguished);
    position += std::min(depth / extinction, length) * way / box.CellSize;
    position = glm::clamp(position, glm::dvec3(cell), glm::dvec3(cell + 1));
    const glm::dvec3 scattered = this->SampleDirection(way, numbers);
    bool isBlocked = false;
    const double seen = weight * this->GetEscape(cell, position, scattered, isBlocked);
    const bool isBack = glm::dot(scattered, this->MainDirection) < 0.0;
    out.All += weight;
    (isBlocked ? out.Blocked : isBack ? out.Backward : out.Forward) += seen;
  }

private:
  /// Sets the position and direction where a path enters a cell. Returns false if it starts at a
  /// light inside the cell.
  bool Start(
    const glm::ivec3& cell, PathNumbers& numbers, glm::dvec3& position, glm::dvec3& way) const
  {
    const ScatteringMedium& box = this->Medium.Box;
    const glm::dvec3 lower(cell);
    const std::array<double, 3> picks = { { numbers.Next(), numbers.Next(), numbers.Next() } };
    if (this->Light.IsPositional && glm::all(glm::greaterThanEqual(this->LightPosition, lower)) &&
      glm::all(glm::lessThanEqual(this->LightPosition, lower + 1.0)))
    {
      const double cosine = 2.0 * picks[0] - 1.0;
      const double across = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      const double angle = 2.0 * vtkMath::Pi() * picks[1];
      position = this->LightPosition;
      way = { across * std::cos(angle), across * std::sin(angle), cosine };
      return false;
    }
    const glm::dvec3 center = box.Origin + (lower + 0.5) * box.CellSize;
    way = this->Light.GetDirection(center);
    // Choose the entry face with a probability proportional to its area projected along the light.
    glm::dvec3 areas;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double border = way[axis] > 0.0 ? lower[axis] : lower[axis] + 1.0;
      const bool isLit =
        !this->Light.IsPositional || (border - this->LightPosition[axis]) * way[axis] > 0.0;
      areas[axis] = isLit ? std::abs(way[axis]) / box.CellSize[axis] : 0.0;
    }
    const double pick = picks[0] * (areas.x + areas.y + areas.z);
    const int axis = pick < areas.x ? 0 : pick < areas.x + areas.y ? 1 : 2;
    position[axis] = way[axis] > 0.0 ? lower[axis] : lower[axis] + 1.0;
    position[(axis + 1) % 3] = lower[(axis + 1) % 3] + picks[1];
    position[(axis + 2) % 3] = lower[(axis + 2) % 3] + picks[2];
    way = this->Light.GetDirection(box.Origin + position * box.CellSize);
    return true;
  }

  /// Returns the distance from a position to the cell's boundary along \a way.
  static double GetLength(const ScatteringMedium& box, const glm::ivec3& cell,
    const glm::dvec3& position, const glm::dvec3& way)
  {
    double length = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (way[axis] != 0.0)
      {
        const double border = cell[axis] + (way[axis] > 0.0 ? 1.0 : 0.0);
        length = std::min(
          length, std::max((border - position[axis]) * box.CellSize[axis] / way[axis], 0.0));
      }
    }
    return length;
  }

  /// Returns the transmittance from the light to \a position, where the light ray enters \a cell.
  double GetTransmittance(
    const glm::dvec3& position, const glm::dvec3& way, const glm::ivec3& cell) const
  {
    const ScatteringMedium& box = this->Medium.Box;
    const double reach = this->Light.IsPositional
      ? glm::length((position - this->LightPosition) * box.CellSize)
      : std::numeric_limits<double>::max();
    CellRay ray(box, cell, position, -way);
    double depth = 0.0;
    int crossedCells = 0;
    while (ray.GetExit() < reach && depth < 50.0 && ++crossedCells < MaximumCells && ray.Advance())
    {
      const std::size_t index = ray.GetIndex();
      if (box.IsBlocked(index))
      {
        return 0.0;
      }
      depth += this->Medium.Extinction[index] * (std::min(ray.GetExit(), reach) - ray.GetEntry());
    }
    return std::exp(-depth);
  }

  /// Returns the escaping fraction of light that is scattered at \a position into direction \a way.
  /// Sets \a isBlocked to true if the path ends in a blocked cell.
  double GetEscape(const glm::ivec3& cell, const glm::dvec3& position, const glm::dvec3& way,
    bool& isBlocked) const
  {
    const ScatteringMedium& box = this->Medium.Box;
    CellRay ray(box, cell, position, way);
    double depth = 0.0;
    int crossedCells = 0;
    do
    {
      const std::size_t index = ray.GetIndex();
      if (box.IsBlocked(index))
      {
        isBlocked = true;
        break;
      }
      depth += this->Medium.Extinction[index] * (ray.GetExit() - ray.GetEntry());
    } while (depth < 50.0 && ++crossedCells < MaximumCells && ray.Advance());
    return crossedCells < MaximumCells ? std::exp(-depth) : 0.0;
  }

  glm::dvec3 SampleDirection(const glm::dvec3& way, PathNumbers& numbers) const
  {
    const double fraction = numbers.Next();
    const auto found = std::upper_bound(
      this->CumulativeProbability.begin() + 1, this->CumulativeProbability.end() - 1, fraction);
    const double rest = *found > found[-1] ? (fraction - found[-1]) / (*found - found[-1]) : 0.0;
    const double angle = vtkMath::Pi() / static_cast<double>(Angles) *
      (static_cast<double>(found - this->CumulativeProbability.begin()) - 1.0 + rest);
    const double turn = 2.0 * vtkMath::Pi() * numbers.Next();
    const glm::dvec3 other =
      std::abs(way.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(way, other));
    const glm::dvec3 v = glm::cross(way, u);
    return std::cos(angle) * way + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v);
  }

  /// Maximum number of cells along a ray between mirrors.
  static constexpr int MaximumCells = 10000;

  const SanitizedMedium& Medium;
  const ScatteringLight& Light;
  const std::vector<double>& CumulativeProbability;
  glm::dvec3 MainDirection;
  /// Position of the light, in cells.
  glm::dvec3 LightPosition;
};

}

SingleScatteringEscape::SingleScatteringEscape(const PhaseFunction& phase)
  : CumulativeProbability(Angles + 1, 0.0)
{
  for (std::size_t i = 0; i < Angles; ++i)
  {
    const double angle = vtkMath::Pi() * (static_cast<double>(i) + 0.5) / Angles;
    this->CumulativeProbability[i + 1] =
      this->CumulativeProbability[i] + std::sin(angle) * phase.Value(std::cos(angle));
  }
  for (double& fraction : this->CumulativeProbability)
  {
    fraction /= this->CumulativeProbability.back();
  }
}

EscapeRays::Sums SingleScatteringEscape::Find(
  const SanitizedMedium& medium, std::size_t light, const glm::dvec3& direction) const
{
  const ScatteringMedium& box = medium.Box;
  const auto getSent = [&](std::size_t cell)
  {
    return medium.CellVolume * medium.Extinction[cell] *
      glm::dvec3(medium.Albedo[cell] * medium.Direct[light][cell]);
  };
  const std::size_t cells = medium.Extinction.size();
  glm::dvec3 sent(0.0);
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    sent += getSent(cell);
  }
  EscapeRays::Sums sums;
  const double total = Vectors::Mean(sent);
  if (!(total > 0.0))
  {
    return sums;
  }
  // Sample cells in proportion to their scattered light, with stratification. Each entry contains a
  // cell and its number of samples.
  constexpr int draws = Paths / PathsOfCell;
  std::vector<std::pair<std::size_t, int>> sampledCells;
  double accumulated = 0.0;
  int samples = 0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    accumulated += Vectors::Mean(getSent(cell));
    const int upTo = std::min(static_cast<int>(accumulated / total * draws + 0.5), draws);
    if (upTo > samples)
    {
      sampledCells.emplace_back(cell, upTo - samples);
      samples = upTo;
    }
  }
  const LightPaths paths(medium, medium.Lights[light], this->CumulativeProbability, direction);
  std::vector<LightPaths::Out> outs(sampledCells.size());
  std::vector<std::size_t> starts(sampledCells.size(), 0);
  for (std::size_t i = 1; i < sampledCells.size(); ++i)
  {
    starts[i] = starts[i - 1] + static_cast<std::size_t>(sampledCells[i - 1].second * PathsOfCell);
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(sampledCells.size()), 32,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const int index = static_cast<int>(sampledCells[i].first);
        const glm::ivec3 cell(index % box.Cells.x, index / box.Cells.x % box.Cells.y,
          index / (box.Cells.x * box.Cells.y));
        for (int path = 0; path < sampledCells[i].second * PathsOfCell; ++path)
        {
          paths.Follow(cell, PathNumbers(starts[i] + static_cast<std::size_t>(path)), outs[i]);
        }
      }
    });
  glm::dvec3 counted(0.0);
  for (std::size_t i = 0; i < sampledCells.size(); ++i)
  {
    const LightPaths::Out& out = outs[i];
    const glm::dvec3 cell = getSent(sampledCells[i].first);
    if (out.All > 0.0 && Vectors::Mean(cell) > 0.0)
    {
      const glm::dvec3 fraction = sampledCells[i].second / Vectors::Mean(cell) * cell;
      counted += fraction;
      sums.Backward += out.Backward / out.All * fraction;
      sums.Forward += out.Forward / out.All * fraction;
      sums.Blocked += out.Blocked / out.All * fraction;
      sums.Recaptured += (1.0 - (out.Backward + out.Forward + out.Blocked) / out.All) * fraction;
    }
  }
  glm::dvec3 factor(1.0);
  for (int color = 0; color < 3; ++color)
  {
    // If no path carries light, all scattered light is recaptured.
    factor[color] = counted[color] > 0.0 ? sent[color] / counted[color] : 1.0;
    sums.Recaptured[color] = counted[color] > 0.0 ? sums.Recaptured[color] : sent[color];
  }
  sums.Scale(factor);
  return sums;
}

}
