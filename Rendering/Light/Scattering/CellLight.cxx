// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/CellLight.h"

#include "Common/ParallelFor.h"
#include "Scattering/CellRay.h"

#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace interlume
{

namespace
{

/// A face of the box through which rays are traced.
struct Side
{
  int Axis = 0;
  bool IsUpper = false;
};

/// For each cell, sums over the rays of one task.
class RaySums
{
public:
  RaySums(const ScatteringMedium& medium, const std::vector<glm::vec3>& fractions)
    : Medium(medium)
    , Fractions(fractions)
    , Sums(medium.GetNumberOfCells())
  {
  }

  /// Traces a ray that starts at distance \a start from the light. \a weight is its cross-sectional
  /// area or, for a positional light, its solid angle.
  void Follow(CellRay ray, double weight, bool isPositional, double start)
  {
    glm::dvec3 through(1.0);
    int cells = 0;
    do
    {
      const std::size_t index = ray.GetIndex();
      const double length = ray.GetExit() - ray.GetEntry();
      const double weightedLength = weight * length;
      const double distance = start + ray.GetEntry();
      Sum& sum = this->Sums[index];
      // The cross section of a diverging ray grows with the square of the distance.
      sum.Length += isPositional
        ? weightedLength * (distance * (distance + length) + length * length / 3.0)
        : weightedLength;
      if (this->Medium.IsBlocked(index))
      {
        through = glm::dvec3(0.0);
      }
      else if (through.x + through.y + through.z > 0.0)
      {
        const double half = distance + this->GetMeanDistance(index, length);
        const double growth = isPositional ? half * half : 1.0;
        sum.Light += growth * weightedLength * this->AttenuateRay(index, length, through);
      }
    } while (ray.Advance() && (!this->HasMirrors || ++cells < MaximumCells));
  }

  struct Sum
  {
    glm::dvec3 Light{ 0.0 };
    double Length = 0.0;
  };
  const std::vector<Sum>& Get() const { return this->Sums; }

private:
  /// Returns the mean transmittance along a ray in a cell and updates \a through to the
  /// transmittance at the exit.
  glm::dvec3 AttenuateRay(std::size_t index, double length, glm::dvec3& through) const
  {
    const float extinction = this->Medium.Extinction[index];
    if (!(extinction > 0.0f) || !std::isfinite(extinction))
    {
      return through;
    }
    const double depth = extinction * length;
    if (this->Fractions.empty())
    {
      const double mean = this->GetMean(depth);
      const double before = through.x;
      through = glm::dvec3(std::max(before * (1.0 - depth * mean), 0.0));
      return glm::dvec3(before * mean);
    }
    const glm::dvec3 depths = depth * glm::dvec3(this->Fractions[index]);
    const glm::dvec3 mean(
      this->GetMean(depths.x), this->GetMean(depths.y), this->GetMean(depths.z));
    const glm::dvec3 before = through;
    through = glm::max(before * (1.0 - depths * mean), glm::dvec3(0.0));
    return before * mean;
  }

  /// Returns the mean distance from a ray's entry at which a cell extinguishes light.
  double GetMeanDistance(std::size_t index, double length) const
  {
    const double depth = std::max(this->Medium.Extinction[index] * length, 0.0);
    return depth > 1e-2 ? length * (1.0 / depth - 1.0 / std::expm1(depth)) : 0.5 * length;
  }

  static double GetMean(double depth)
  {
    return depth > 1e-4 ? -std::expm1(-depth) / depth : 1.0 - 0.5 * depth;
  }

  /// Maximum number of cells that a ray traverses if there are mirrors.
  static constexpr int MaximumCells = 10000;

  const ScatteringMedium& Medium;
  const std::vector<glm::vec3>& Fractions;
  bool HasMirrors = glm::any(Medium.Mirrors);
  std::vector<Sum> Sums;
};

/// Traces the rays through one face.
class SideRays
{
public:
  SideRays(const ScatteringMedium& medium, const ScatteringLight& light, const Side& side, int rays,
    const glm::dvec2& offset)
    : Medium(medium)
    , Light(light)
    , LightPosition((light.Position - medium.Origin) / medium.CellSize)
    , Face(side)
    , Rays(rays)
    , Offset(offset)
  {
    const int axis = side.Axis;
    this->Across = { { (axis + 1) % 3, (axis + 2) % 3 } };
    this->Area = medium.CellSize[this->Across[0]] * medium.CellSize[this->Across[1]] /
      (static_cast<double>(rays) * rays);
  }

  int GetRows() const { return this->Rays * this->Medium.Cells[this->Across[1]]; }

  void FollowRow(int row, RaySums& sums) const
  {
    glm::dvec3 position(0.0);
    position[this->Face.Axis] = this->Face.IsUpper ? this->Medium.Cells[this->Face.Axis] : 0.0;
    position[this->Across[1]] = (row + 0.5 + this->Offset.y) / this->Rays;
    const int columns = this->Rays * this->Medium.Cells[this->Across[0]];
    for (int column = 0; column < columns; ++column)
    {
      position[this->Across[0]] = (column + 0.5 + this->Offset.x) / this->Rays;
      this->FollowTo(position, sums);
    }
  }

private:
  void FollowTo(const glm::dvec3& position, RaySums& sums) const
  {
    if (!this->Light.IsPositional)
    {
      const glm::dvec3& direction = this->Light.Direction;
      sums.Follow(CellRay(this->Medium, position, direction),
        this->Area * std::abs(direction[this->Face.Axis]), false, 0.0);
      return;
    }
    // The ray begins at the light, or at its entry into the box, and ends at the position on the
    // face.
    const glm::dvec3 inCells = position - this->LightPosition;
    double entry = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double border = inCells[axis] > 0.0 ? 0.0 : this->Medium.Cells[axis];
      if (inCells[axis] != 0.0)
      {
        entry =
          std::max(entry, std::min((border - this->LightPosition[axis]) / inCells[axis], 1.0));
      }
    }
    const glm::dvec3 toFace = inCells * this->Medium.CellSize;
    const double reach = glm::length(toFace);
    if (!(reach > 0.0))
    {
      return;
    }
    const glm::dvec3 direction = toFace / reach;
    const glm::dvec3 start = glm::clamp(
      this->LightPosition + entry * inCells, glm::dvec3(0.0), glm::dvec3(this->Medium.Cells));
    sums.Follow(CellRay(this->Medium, start, direction),
      this->Area * std::abs(direction[this->Face.Axis]) / (reach * reach), true, entry * reach);
  }

  const ScatteringMedium& Medium;
  const ScatteringLight& Light;
  /// Position of the light, in cells from the lower corner of the box.
  glm::dvec3 LightPosition;
  Side Face;
  int Rays;
  glm::dvec2 Offset;
  std::array<int, 2> Across{};
  double Area = 0.0;
};

/// Returns the faces through which rays enter or, for a positional light, exit.
std::vector<Side> FindSides(const ScatteringMedium& medium, const ScatteringLight& light)
{
  const glm::dvec3 at = (light.Position - medium.Origin) / medium.CellSize;
  std::vector<Side> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool isUpper : { false, true })
    {
      const double along = isUpper ? -light.Direction[axis] : light.Direction[axis];
      const bool isExited = isUpper ? at[axis] < medium.Cells[axis] : at[axis] > 0.0;
      if (!medium.Mirrors[axis] && (light.IsPositional ? isExited : along > 0.0))
      {
        sides.push_back({ axis, isUpper });
      }
    }
  }
  return sides;
}

}

int CellLight::GetRaysPerEdge(const glm::ivec3& cells)
{
  constexpr double maximumRays = 4096.0;
  const double sides = static_cast<double>(cells.x) * cells.y +
    static_cast<double>(cells.y) * cells.z + static_cast<double>(cells.z) * cells.x;
  return glm::clamp(static_cast<int>(std::sqrt(maximumRays / std::max(sides, 1.0)) + 0.5), 2, 16);
}

std::vector<glm::vec3> CellLight::Find(const ScatteringMedium& medium,
  const std::vector<glm::vec3>& fractions, const ScatteringLight& light, int rays,
  const glm::dvec2& offset)
{
  // Each task has separate sums, added in a fixed order for a deterministic result.
  constexpr int number = 4;
  std::vector<RaySums> sums(number, RaySums(medium, fractions));
  std::vector<SideRays> sides;
  for (const Side& side : FindSides(medium, light))
  {
    sides.emplace_back(medium, light, side, rays, offset);
  }
  ParallelFor(0, number, 1,
    [&](vtkIdType part)
    {
      for (const SideRays& side : sides)
      {
        for (int row = static_cast<int>(part); row < side.GetRows(); row += number)
        {
          side.FollowRow(row, sums[static_cast<std::size_t>(part)]);
        }
      }
    });
  std::vector<glm::vec3> means(medium.GetNumberOfCells(), glm::vec3(0.0f));
  const double volume = medium.CellSize.x * medium.CellSize.y * medium.CellSize.z;
  glm::dvec3 rayTotal(0.0);
  glm::dvec3 cellTotal(0.0);
  for (std::size_t cell = 0; cell < means.size(); ++cell)
  {
    RaySums::Sum sum;
    for (const RaySums& part : sums)
    {
      sum.Light += part.Get()[cell].Light;
      sum.Length += part.Get()[cell].Length;
    }
    if (sum.Length > 0.0)
    {
      means[cell] = glm::vec3(sum.Light / sum.Length);
      const float extinction = medium.Extinction[cell];
      if (extinction > 0.0f && std::isfinite(extinction))
      {
        const glm::dvec3 extinctions = static_cast<double>(extinction) *
          (fractions.empty() ? glm::dvec3(1.0) : glm::dvec3(fractions[cell]));
        rayTotal += extinctions * sum.Light;
        cellTotal += extinctions * sum.Light * (volume / sum.Length);
      }
    }
  }
  // The rays in a cell represent slightly more or less than its volume. The cells must not
  // extinguish more light in total than the rays lose.
  glm::vec3 factor(1.0f);
  for (int color = 0; color < 3; ++color)
  {
    factor[color] = cellTotal[color] > rayTotal[color]
      ? static_cast<float>(rayTotal[color] / cellTotal[color])
      : 1.0f;
  }
  for (glm::vec3& mean : means)
  {
    mean *= factor;
  }
  return means;
}

}
