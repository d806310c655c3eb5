// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ForwardLight.h"

#include "Common/Vectors.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace interlume
{

namespace
{

/// Maximum variance of the angle along one axis: the variance of isotropic light.
constexpr double MaximumAngleVariance = 1.0 / 3.0;
/// Maximum variance of a kernel, in squared cells.
constexpr double MaximumKernelVariance = 400.0;
/// Maximum variance of a kernel of three cells.
constexpr double MaximumThreeCellVariance = 0.75;
/// Width of the margin around the box, relative to the width of the box. Kernels spread some of the
/// light in the margin back into the box.
constexpr double MarginFraction = 0.25;

/// Light passed from a cell to the next layer. The moments are multiplied by the sum of Light over
/// the colors.
struct Beam
{
  glm::dvec3 Light{ 0.0 };
  /// Variance of the angle, and covariance of angle and position.
  double AngleVariance = 0.0;
  double Covariance = 0.0;
  /// Variance of position along two axes, in squared cells, that kernels have not applied yet.
  /// Negative if a kernel was too wide.
  std::array<double, 2> PositionVariance{};

  double GetSum() const { return this->Light.x + this->Light.y + this->Light.z; }
  void Add(double weight, const Beam& other)
  {
    this->Light += weight * other.Light;
    this->AngleVariance += weight * other.AngleVariance;
    this->Covariance += weight * other.Covariance;
    this->PositionVariance[0] += weight * other.PositionVariance[0];
    this->PositionVariance[1] += weight * other.PositionVariance[1];
  }
};

/// One-dimensional weights of cells, with a given mean and variance of position.
struct Kernel
{
  /// Computes weights of three cells or, if \a isWide, of as many as needed. Sets \a variance to
  /// the kernel's actual variance.
  Kernel(double mean, double& variance, bool isWide)
  {
    const double nearest = std::floor(mean + 0.5);
    const double rest = mean - nearest;
    const double minimum = std::abs(rest) * (1.0 - std::abs(rest));
    variance = std::max(variance, minimum);
    if (!isWide || variance + rest * rest <= MaximumThreeCellVariance)
    {
      variance = std::max(std::min(variance, MaximumThreeCellVariance - rest * rest), minimum);
      const double square = variance + rest * rest;
      this->First = static_cast<int>(nearest) - 1;
      this->Count = 3;
      this->Weights[0] = 0.5 * (square - rest);
      this->Weights[1] = 1.0 - square;
      this->Weights[2] = 0.5 * (square + rest);
      return;
    }
    variance = std::min(variance, MaximumKernelVariance);
    const int reach =
      std::min(static_cast<int>(std::ceil(3.5 * std::sqrt(variance))), MaximumRadius);
    this->First = static_cast<int>(nearest) - reach;
    this->Count = 2 * reach + 1;
    // Compute the Gaussian from the center outward by recurrence.
    const double square = std::exp(-1.0 / variance);
    double sum = this->Weights[static_cast<std::size_t>(reach)] =
      std::exp(-0.5 * rest * rest / variance);
    for (const int side : { -1, 1 })
    {
      double weight = this->Weights[static_cast<std::size_t>(reach)];
      double ratio = std::exp((side * rest - 0.5) / variance);
      for (int i = 1; i <= reach; ++i)
      {
        weight *= ratio;
        ratio *= square;
        sum += this->Weights[static_cast<std::size_t>(reach + side * i)] = weight;
      }
    }
    for (int i = 0; i < this->Count; ++i)
    {
      this->Weights[static_cast<std::size_t>(i)] /= sum;
    }
  }

  static constexpr int MaximumRadius = 70;
  int First = 0;
  int Count = 0;
  /// The first Count values are set.
  std::array<double, 2 * MaximumRadius + 1>
    Weights; // NOLINT(cppcoreguidelines-pro-type-member-init)
};

/// Returns \a index, wrapped around if \a isEndless. Otherwise, returns -1 if it is outside the row
/// of \a cells cells.
int WrapIndex(int index, int cells, bool isEndless)
{
  if (isEndless)
  {
    return ((index % cells) + cells) % cells;
  }
  return index >= 0 && index < cells ? index : -1;
}

/// Propagates forward light through one cell.
class CellStep
{
public:
  CellStep(const SanitizedMedium& medium, std::size_t light, double fraction, double variance)
    : Medium(medium)
    , Direct(medium.Direct[light])
    , Fraction(fraction)
    , Variance(variance)
  {
  }

  /**
   * Propagates a beam through a cell, along a path of \a length. Returns the mean light along the
   * path. For each of two axes, \a spread converts a position variance from squared world units to
   * squared cells.
   */
  glm::dvec3 Go(
    std::size_t cell, double length, const std::array<double, 2>& spread, Beam& beam) const
  {
    if (this->Medium.Box.IsBlocked(cell))
    {
      beam = Beam();
      return glm::dvec3(0.0);
    }
    const double depth = this->Medium.Extinction[cell] * length;
    const glm::dvec3 entering = beam.Light;
    const double before = beam.GetSum();
    double retained = before;
    double scatterings = 0.0;
    glm::dvec3 mean = entering;
    if (depth > 0.0)
    {
      const glm::dvec3 on = depth * this->Fraction * glm::dvec3(this->Medium.Albedo[cell]);
      const glm::dvec3 lost = depth - on;
      const glm::dvec3 direct = this->Direct[cell];
      // The direct light at the ray's entry, derived from the cell's mean direct light.
      const glm::dvec3 first = direct * (depth / -std::expm1(-depth));
      retained = 0.0;
      for (int color = 0; color < 3; ++color)
      {
        const double through = std::exp(-lost[color]);
        const double added = first[color] * through * -std::expm1(-on[color]);
        const double leaving = entering[color] * through + added;
        retained += entering[color] * through;
        mean[color] = lost[color] > 1e-3
          ? (entering[color] + on[color] * direct[color] - leaving) / lost[color]
          : (entering[color] + first[color]) * (1.0 - 0.5 * lost[color]) - direct[color];
        mean[color] = std::max(mean[color], 0.0);
        beam.Light[color] = leaving;
        scatterings += on[color] * (direct[color] + mean[color]) * std::exp(-0.5 * lost[color]);
      }
    }
    this->Move(before > 0.0 ? retained / before : 0.0, scatterings, length, spread, beam);
    return mean;
  }

  /**
   * Advances the beam's moments. \a left is the fraction of the entering light that leaves the
   * cell. \a scatterings is the number of scattering events, weighted by light.
   */
  void Move(double left, double scatterings, double length, const std::array<double, 2>& spread,
    Beam& beam) const
  {
    const double after = beam.GetSum();
    if (!(after > 0.0))
    {
      beam = Beam();
      return;
    }
    const double angle = left * beam.AngleVariance;
    const double cross = left * beam.Covariance;
    const double addedAngle = this->Variance * scatterings;
    beam.AngleVariance = std::min(angle + addedAngle, MaximumAngleVariance * after);
    beam.Covariance = cross + angle * length + 0.5 * addedAngle * length;
    // Positions refer to layer centers: add the variance of the first half of the next layer, and
    // subtract that of the first half of this layer, which was added in the previous step.
    const double location = 2.0 * cross * length + (angle + addedAngle / 3.0) * length * length -
      GetDrift(angle, cross, length) + GetDrift(beam.AngleVariance, beam.Covariance, length);
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      beam.PositionVariance[axis] = left * beam.PositionVariance[axis] + spread[axis] * location;
    }
  }

  bool HasSpread() const { return this->Variance > 0.0; }

private:
  /// Returns the variance of position added along half of a path.
  static double GetDrift(double angle, double cross, double length)
  {
    return cross * length + 0.25 * angle * length * length;
  }

  const SanitizedMedium& Medium;
  const std::vector<glm::vec3>& Direct;
  double Fraction;
  double Variance;
};

/// The axis along which light crosses layers, and the two perpendicular axes.
struct Axes
{
  explicit Axes(const glm::dvec3& inCells)
    : Along(std::abs(inCells.x) >= std::abs(inCells.y) && std::abs(inCells.x) >= std::abs(inCells.z)
          ? 0
          : (std::abs(inCells.y) >= std::abs(inCells.z) ? 1 : 2))
    , Across{ { (this->Along + 1) % 3, (this->Along + 2) % 3 } }
  {
  }
  int Along;
  std::array<int, 2> Across;
};

/// Shifts and spreads the beams that leave one layer and enter the next.
class LayerShift
{
public:
  LayerShift(int columns, int rows, const glm::bvec2& mirrors, const std::array<double, 2>& shift)
    : Sizes{ { columns, rows } }
    , Mirrors(mirrors)
    , Shift(shift)
  {
  }

  /// Applies the kernels along each of the two axes in turn.
  void Go(std::vector<Beam>& beams)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Next.assign(beams.size(), Beam());
      for (int row = 0; row < this->Sizes[1]; ++row)
      {
        for (int column = 0; column < this->Sizes[0]; ++column)
        {
          this->Spread(
            axis, column, row, beams[static_cast<std::size_t>(column + row * this->Sizes[0])]);
        }
      }
      beams.swap(this->Next);
    }
  }

private:
  void Spread(int axis, int column, int row, Beam& beam)
  {
    const std::size_t location = static_cast<std::size_t>(axis);
    const double sum = beam.GetSum();
    if (!(sum > 0.0))
    {
      return;
    }
    double variance = beam.PositionVariance[location] / sum;
    const Kernel kernel(this->Shift[location], variance, true);
    beam.PositionVariance[location] -= variance * sum;
    for (int i = 0; i < kernel.Count; ++i)
    {
      const int offset = kernel.First + i;
      const int at =
        WrapIndex((axis == 0 ? column : row) + offset, this->Sizes[location], this->Mirrors[axis]);
      if (at >= 0)
      {
        const int to = axis == 0 ? at + row * this->Sizes[0] : column + at * this->Sizes[0];
        this->Next[static_cast<std::size_t>(to)].Add(
          kernel.Weights[static_cast<std::size_t>(i)], beam);
      }
    }
  }

  std::array<int, 2> Sizes;
  glm::bvec2 Mirrors;
  std::array<double, 2> Shift;
  std::vector<Beam> Next;
};

/// Solves for a directional light, layer by layer. Each layer spreads its outgoing light to cells
/// of the next layer.
std::vector<glm::vec3> SolveLayers(
  const SanitizedMedium& medium, const CellStep& step, const glm::dvec3& direction, int& layers)
{
  const ScatteringMedium& box = medium.Box;
  const glm::dvec3 inCells = direction / box.CellSize;
  // No light enters through mirrors, so layers are perpendicular to an axis without mirrors if
  // possible.
  glm::dvec3 open = inCells;
  for (int axis = 0; axis < 3; ++axis)
  {
    open[axis] *= box.Mirrors[axis] ? 1e-9 : 1.0;
  }
  const Axes axes(open);
  const auto [u, v] = axes.Across;
  const double length = 1.0 / std::abs(inCells[axes.Along]);
  std::array<double, 2> shift{};
  std::array<double, 2> spread{};
  for (std::size_t i = 0; i < 2; ++i)
  {
    const int axis = axes.Across[i];
    const double tilt = direction[axis] / direction[axes.Along];
    shift[i] = inCells[axis] * length;
    spread[i] = (1.0 + tilt * tilt) / (box.CellSize[axis] * box.CellSize[axis]);
  }
  const glm::bvec2 mirrors(box.Mirrors[u], box.Mirrors[v]);
  const glm::ivec2 sizes(box.Cells[u], box.Cells[v]);
  const glm::ivec2 margin = step.HasSpread()
    ? glm::ivec2(MarginFraction * glm::dvec2(sizes)) * glm::ivec2(!mirrors.x, !mirrors.y)
    : glm::ivec2(0);
  LayerShift move(sizes.x + 2 * margin.x, sizes.y + 2 * margin.y, mirrors, shift);
  std::vector<Beam> beams(
    static_cast<std::size_t>((sizes.x + 2 * margin.x) * (sizes.y + 2 * margin.y)));
  std::vector<glm::vec3> result(medium.Extinction.size(), glm::vec3(0.0f));
  const int count = box.Cells[axes.Along];
  for (int layer = 0; layer < count; ++layer)
  {
    glm::ivec3 cell(0);
    cell[axes.Along] = inCells[axes.Along] > 0.0 ? layer : count - 1 - layer;
    std::size_t beam = 0;
    for (cell[v] = -margin.y; cell[v] < sizes.y + margin.y; ++cell[v])
    {
      for (cell[u] = -margin.x; cell[u] < sizes.x + margin.x; ++cell[u], ++beam)
      {
        if (cell[u] < 0 || cell[u] >= sizes.x || cell[v] < 0 || cell[v] >= sizes.y)
        {
          step.Move(1.0, 0.0, length, spread, beams[beam]);
          continue;
        }
        const std::size_t index = box.GetIndex(cell);
        result[index] = step.Go(index, length, spread, beams[beam]);
      }
    }
    move.Go(beams);
  }
  layers += count;
  return result;
}

/// Solves for a positional light. Each cell gathers light from cells closer to the light.
class PointLightSweep
{
public:
  PointLightSweep(const SanitizedMedium& medium, const CellStep& step, const glm::dvec3& position)
    : Medium(medium)
    , Step(step)
    , LightPosition((position - medium.Box.Origin) / medium.Box.CellSize - 0.5)
    , Distances(medium.Extinction.size())
    , Leaving(medium.Extinction.size())
  {
  }

  std::vector<glm::vec3> Solve(int& layers)
  {
    const glm::ivec3& cells = this->Medium.Box.Cells;
    std::vector<std::size_t> order(this->Distances.size());
    std::iota(order.begin(), order.end(), 0);
    for (const std::size_t index : order)
    {
      this->Distances[index] =
        Vectors::InfinityNorm(glm::dvec3(this->GetCell(index)) - this->LightPosition);
    }
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) { return this->Distances[a] < this->Distances[b]; });
    std::vector<glm::vec3> result(order.size(), glm::vec3(0.0f));
    for (const std::size_t index : order)
    {
      result[index] = this->Visit(index);
    }
    layers += std::max({ cells.x, cells.y, cells.z });
    return result;
  }

private:
  glm::ivec3 GetCell(std::size_t index) const
  {
    const glm::ivec3& cells = this->Medium.Box.Cells;
    const int number = static_cast<int>(index);
    return { number % cells.x, number / cells.x % cells.y, number / (cells.x * cells.y) };
  }

  /// Returns the mean light in a cell and stores the cell's outgoing light.
  glm::dvec3 Visit(std::size_t index)
  {
    const glm::ivec3 cell = this->GetCell(index);
    const glm::dvec3 away = glm::dvec3(cell) - this->LightPosition;
    const Axes axes(away);
    const double reach = this->Distances[index];
    const glm::dvec3 inWorld = away * this->Medium.Box.CellSize;
    Beam& beam = this->Leaving[index];
    double length = 0.5 * this->Medium.Box.CellSize[axes.Along];
    std::array<double, 2> spread{};
    if (reach > 0.0)
    {
      // Length of the path from the previous layer, or from the light if the light is closer.
      length = Vectors::SafeLength(inWorld) / reach * std::min(1.0, reach + 0.5);
      for (std::size_t i = 0; i < 2; ++i)
      {
        const double size = this->Medium.Box.CellSize[axes.Across[i]];
        const double tilt = inWorld[axes.Across[i]] / inWorld[axes.Along];
        spread[i] = (1.0 + tilt * tilt) / (size * size);
      }
    }
    if (reach >= 1.0)
    {
      beam = this->Gather(cell, away, axes, reach);
    }
    return this->Step.Go(index, length, spread, beam);
  }

  Beam Gather(const glm::ivec3& cell, const glm::dvec3& away, const Axes& axes, double reach) const
  {
    const ScatteringMedium& box = this->Medium.Box;
    glm::ivec3 from = cell;
    from[axes.Along] -= away[axes.Along] > 0.0 ? 1 : -1;
    Beam sum;
    if (from[axes.Along] < 0 || from[axes.Along] >= box.Cells[axes.Along])
    {
      return sum;
    }
    const glm::dvec3 location = glm::dvec3(cell) - away / reach;
    // The nearest beam's remaining variance determines the kernel.
    std::array<double, 2> variance = { { 0.0, 0.0 } };
    for (std::size_t i = 0; i < 2; ++i)
    {
      from[axes.Across[i]] = static_cast<int>(std::floor(location[axes.Across[i]] + 0.5));
    }
    if (this->IsBefore(from, reach))
    {
      const Beam& nearest = this->Leaving[box.GetIndex(from)];
      const double light = nearest.GetSum();
      for (std::size_t i = 0; i < 2 && light > 0.0; ++i)
      {
        variance[i] = nearest.PositionVariance[i] / light;
      }
    }
    const Kernel rows(location[axes.Across[1]], variance[1], false);
    const Kernel columns(location[axes.Across[0]], variance[0], false);
    double total = 0.0;
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t column = 0; column < 3; ++column)
      {
        from[axes.Across[0]] = columns.First + static_cast<int>(column);
        from[axes.Across[1]] = rows.First + static_cast<int>(row);
        const double weight = columns.Weights[column] * rows.Weights[row];
        const bool isInside = glm::all(glm::greaterThanEqual(from, glm::ivec3(0))) &&
          glm::all(glm::lessThan(from, box.Cells));
        if (!isInside)
        {
          total += weight;
        }
        else if (this->IsBefore(from, reach))
        {
          total += weight;
          sum.Add(weight, this->Leaving[box.GetIndex(from)]);
        }
      }
    }
    // Light diverges: this layer has more cells around the light than the previous layer, so each
    // cell gets a smaller fraction.
    const double closer = (reach - 1.0) * (reach - 1.0) + 1.0 / 12.0;
    Beam mean;
    mean.Add(total > 0.0 ? closer / (reach * reach + 1.0 / 12.0) / total : 0.0, sum);
    for (std::size_t i = 0; i < 2; ++i)
    {
      mean.PositionVariance[i] -= variance[i] * mean.GetSum();
    }
    return mean;
  }

  bool IsBefore(const glm::ivec3& cell, double reach) const
  {
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
      glm::all(glm::lessThan(cell, this->Medium.Box.Cells)) &&
      this->Distances[this->Medium.Box.GetIndex(cell)] < reach;
  }

  const SanitizedMedium& Medium;
  const CellStep& Step;
  /// Position of the light in cells; cell centers have integer coordinates.
  glm::dvec3 LightPosition;
  std::vector<double> Distances;
  std::vector<Beam> Leaving;
};

}

std::vector<glm::vec3> ForwardLight::Solve(
  const SanitizedMedium& medium, std::size_t light, double fraction, double variance, int& layers)
{
  const CellStep step(medium, light, fraction, variance);
  const ScatteringLight& source = medium.Lights[light];
  return source.IsPositional ? PointLightSweep(medium, step, source.Position).Solve(layers)
                             : SolveLayers(medium, step, source.Direction, layers);
}

}
