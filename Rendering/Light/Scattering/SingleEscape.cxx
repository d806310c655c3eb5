// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/SingleEscape.h"

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

/// The number of paths of one light, and of paths that begin in a cell each time it is chosen. The
/// escaping fraction of a cell is a ratio of two sums over its paths, which few paths bias: with 4
/// paths, thick cells let out a twelfth too little.
constexpr int Paths = 16384;
constexpr int PathsOfCell = 16;
constexpr std::size_t Angles = 4096;

/// Six numbers between 0 and 1 for each path, evenly spread in their space.
class PathNumbers
{
public:
  explicit PathNumbers(std::size_t path)
    : Path(static_cast<double>(path))
  {
  }
  double Next()
  {
    // The root of x^7 = x + 1.
    this->Factor /= 1.1127756842787055;
    const double place = 0.5 + this->Path * this->Factor;
    return place - std::floor(place);
  }

private:
  double Path;
  double Factor = 1.0;
};

double MeanOf(const glm::dvec3& color)
{
  return (color.x + color.y + color.z) / 3.0;
}

/// The paths of one light.
class LightPaths
{
public:
  LightPaths(const MatterCells& matter, const ScatteringLight& light,
    const std::vector<double>& shares, const glm::dvec3& back)
    : Matter(matter)
    , Light(light)
    , Shares(shares)
    , Main(back)
    , At((light.Position - matter.Box.Origin) / matter.Box.CellSize)
  {
  }

  /// What leaves of the light that a cell scatters, as shares of it.
  struct Out
  {
    double All = 0.0;
    double Back = 0.0;
    double On = 0.0;
    double Blocked = 0.0;
  };

  void Follow(const glm::ivec3& cell, PathNumbers numbers, Out& out) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    glm::dvec3 place(0.0);
    glm::dvec3 way(0.0);
    double coming = 1.0;
    if (this->Start(cell, numbers, place, way))
    {
      coming = this->GetTransmittance(place, way, cell);
    }
    const double extinction = this->Matter.Extinction[box.GetIndex(cell)];
    const double length = GetLength(box, cell, place, way);
    const double taken = -std::expm1(-extinction * length);
    const double weight = coming * taken;
    if (!(weight > 0.0))
    {
      return;
    }
    const double depth = -std::log1p(-numbers.Next() * taken);
    place += std::min(depth / extinction, length) * way / box.CellSize;
    place = glm::clamp(place, glm::dvec3(cell), glm::dvec3(cell + 1));
    const glm::dvec3 scattered = this->Turn(way, numbers);
    bool isBlocked = false;
    const double seen = weight * this->GetEscape(cell, place, scattered, isBlocked);
    const bool isBack = glm::dot(scattered, this->Main) < 0.0;
    out.All += weight;
    (isBlocked ? out.Blocked : isBack ? out.Back : out.On) += seen;
  }

private:
  /// Sets where a path of light enters a cell, and returns whether it comes from outside.
  bool Start(const glm::ivec3& cell, PathNumbers& numbers, glm::dvec3& place, glm::dvec3& way) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    const glm::dvec3 lower(cell);
    const std::array<double, 3> picks = { { numbers.Next(), numbers.Next(), numbers.Next() } };
    if (this->Light.IsPositional && glm::all(glm::greaterThanEqual(this->At, lower)) &&
      glm::all(glm::lessThanEqual(this->At, lower + 1.0)))
    {
      const double cosine = 2.0 * picks[0] - 1.0;
      const double across = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      const double angle = 2.0 * vtkMath::Pi() * picks[1];
      place = this->At;
      way = { across * std::cos(angle), across * std::sin(angle), cosine };
      return false;
    }
    const glm::dvec3 middle = box.Origin + (lower + 0.5) * box.CellSize;
    way = this->Light.GetDirection(middle);
    // The side that it enters by, by the areas that the light sees of them.
    glm::dvec3 areas;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double border = way[axis] > 0.0 ? lower[axis] : lower[axis] + 1.0;
      const bool isLit = !this->Light.IsPositional || (border - this->At[axis]) * way[axis] > 0.0;
      areas[axis] = isLit ? std::abs(way[axis]) / box.CellSize[axis] : 0.0;
    }
    const double pick = picks[0] * (areas.x + areas.y + areas.z);
    const int axis = pick < areas.x ? 0 : pick < areas.x + areas.y ? 1 : 2;
    place[axis] = way[axis] > 0.0 ? lower[axis] : lower[axis] + 1.0;
    place[(axis + 1) % 3] = lower[(axis + 1) % 3] + picks[1];
    place[(axis + 2) % 3] = lower[(axis + 2) % 3] + picks[2];
    way = this->Light.GetDirection(box.Origin + place * box.CellSize);
    return true;
  }

  /// Returns how far it is from a place to where the cell ends.
  static double GetLength(const ScatteringMedium& box, const glm::ivec3& cell,
    const glm::dvec3& place, const glm::dvec3& way)
  {
    double length = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (way[axis] != 0.0)
      {
        const double border = cell[axis] + (way[axis] > 0.0 ? 1.0 : 0.0);
        length =
          std::min(length, std::max((border - place[axis]) * box.CellSize[axis] / way[axis], 0.0));
      }
    }
    return length;
  }

  /// Returns the transmittance from the light to the place where it enters a cell.
  double GetTransmittance(
    const glm::dvec3& place, const glm::dvec3& way, const glm::ivec3& cell) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    const double reach = this->Light.IsPositional ? glm::length((place - this->At) * box.CellSize)
                                                  : std::numeric_limits<double>::max();
    CellRay ray(box, cell, place, -way);
    double depth = 0.0;
    int turns = 0;
    while (ray.GetExit() < reach && depth < 50.0 && ++turns < MostTurns && ray.Advance())
    {
      const std::size_t index = ray.GetIndex();
      if (box.IsBlocked(index))
      {
        return 0.0;
      }
      depth += this->Matter.Extinction[index] * (std::min(ray.GetExit(), reach) - ray.GetEntry());
    }
    return std::exp(-depth);
  }

  /// Returns what leaves of light that was scattered.
  double GetEscape(
    const glm::ivec3& cell, const glm::dvec3& place, const glm::dvec3& way, bool& isBlocked) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    CellRay ray(box, cell, place, way);
    double depth = 0.0;
    int turns = 0;
    do
    {
      const std::size_t index = ray.GetIndex();
      if (box.IsBlocked(index))
      {
        isBlocked = true;
        break;
      }
      depth += this->Matter.Extinction[index] * (ray.GetExit() - ray.GetEntry());
    } while (depth < 50.0 && ++turns < MostTurns && ray.Advance());
    return turns < MostTurns ? std::exp(-depth) : 0.0;
  }

  glm::dvec3 Turn(const glm::dvec3& way, PathNumbers& numbers) const
  {
    const double share = numbers.Next();
    const auto found = std::upper_bound(this->Shares.begin() + 1, this->Shares.end() - 1, share);
    const double rest = *found > found[-1] ? (share - found[-1]) / (*found - found[-1]) : 0.0;
    const double angle = vtkMath::Pi() / static_cast<double>(Angles) *
      (static_cast<double>(found - this->Shares.begin()) - 1.0 + rest);
    const double turn = 2.0 * vtkMath::Pi() * numbers.Next();
    const glm::dvec3 other =
      std::abs(way.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(way, other));
    const glm::dvec3 v = glm::cross(way, u);
    return std::cos(angle) * way + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v);
  }

  /// The cells after which a ray between mirrors ends.
  static constexpr int MostTurns = 10000;

  const MatterCells& Matter;
  const ScatteringLight& Light;
  const std::vector<double>& Shares;
  glm::dvec3 Main;
  /// The light's place, in cells.
  glm::dvec3 At;
};

}

SingleEscape::SingleEscape(const PhaseFunction& phase)
  : Shares(Angles + 1, 0.0)
{
  for (std::size_t i = 0; i < Angles; ++i)
  {
    const double angle = vtkMath::Pi() * (static_cast<double>(i) + 0.5) / Angles;
    this->Shares[i + 1] = this->Shares[i] + std::sin(angle) * phase.Value(std::cos(angle));
  }
  for (double& share : this->Shares)
  {
    share /= this->Shares.back();
  }
}

EscapeRays::Sums SingleEscape::Find(
  const MatterCells& matter, std::size_t light, const glm::dvec3& direction) const
{
  const ScatteringMedium& box = matter.Box;
  const auto getSent = [&](std::size_t cell)
  {
    return matter.CellVolume * matter.Extinction[cell] *
      glm::dvec3(matter.Albedo[cell] * matter.Direct[light][cell]);
  };
  const std::size_t cells = matter.Extinction.size();
  glm::dvec3 sent(0.0);
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    sent += getSent(cell);
  }
  EscapeRays::Sums sums;
  const double total = MeanOf(sent);
  if (!(total > 0.0))
  {
    return sums;
  }
  // The cells that steps of equal light meet, and how often.
  constexpr int draws = Paths / PathsOfCell;
  std::vector<std::pair<std::size_t, int>> chosen;
  double passed = 0.0;
  int drawn = 0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    passed += MeanOf(getSent(cell));
    const int upTo = std::min(static_cast<int>(passed / total * draws + 0.5), draws);
    if (upTo > drawn)
    {
      chosen.emplace_back(cell, upTo - drawn);
      drawn = upTo;
    }
  }
  const LightPaths paths(matter, matter.Lights[light], this->Shares, direction);
  std::vector<LightPaths::Out> outs(chosen.size());
  std::vector<std::size_t> starts(chosen.size(), 0);
  for (std::size_t i = 1; i < chosen.size(); ++i)
  {
    starts[i] = starts[i - 1] + static_cast<std::size_t>(chosen[i - 1].second * PathsOfCell);
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(chosen.size()), 32,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const int index = static_cast<int>(chosen[i].first);
        const glm::ivec3 cell(index % box.Cells.x, index / box.Cells.x % box.Cells.y,
          index / (box.Cells.x * box.Cells.y));
        for (int path = 0; path < chosen[i].second * PathsOfCell; ++path)
        {
          paths.Follow(cell, PathNumbers(starts[i] + static_cast<std::size_t>(path)), outs[i]);
        }
      }
    });
  glm::dvec3 counted(0.0);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const LightPaths::Out& out = outs[i];
    const glm::dvec3 cell = getSent(chosen[i].first);
    if (out.All > 0.0 && MeanOf(cell) > 0.0)
    {
      const glm::dvec3 share = chosen[i].second / MeanOf(cell) * cell;
      counted += share;
      sums.Back += out.Back / out.All * share;
      sums.On += out.On / out.All * share;
      sums.Blocked += out.Blocked / out.All * share;
      sums.Kept += (1.0 - (out.Back + out.On + out.Blocked) / out.All) * share;
    }
  }
  glm::dvec3 factor(1.0);
  for (int color = 0; color < 3; ++color)
  {
    // No path has light where it comes out of no side.
    factor[color] = counted[color] > 0.0 ? sent[color] / counted[color] : 1.0;
    sums.Kept[color] = counted[color] > 0.0 ? sums.Kept[color] : sent[color];
  }
  sums.Scale(factor);
  return sums;
}

}
