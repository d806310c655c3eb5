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

/// The largest variance of the angle to one axis, that of light in all directions.
constexpr double LargestAngle = 1.0 / 3.0;
/// The largest variance of a kernel, in square cells.
constexpr double LargestKernel = 400.0;
/// The largest variance that a kernel of three cells has.
constexpr double LargestThree = 0.75;
/// How far light is followed beside the box, over its width. Light is spread by kernels, so that
/// some of it comes back.
constexpr double MarginShare = 0.25;

/// The light that leaves a cell for the next layer. All but Light is times the light's sum.
struct Beam
{
  glm::dvec3 Light{ 0.0 };
  /// The variance of the angle and the covariance of angle and place.
  double Angle = 0.0;
  double Cross = 0.0;
  /// The variance of place along two axes that is still to be given, in square cells. It is
  /// negative where a kernel was too wide.
  std::array<double, 2> Place{};

  double GetSum() const { return this->Light.x + this->Light.y + this->Light.z; }
  void Add(double weight, const Beam& other)
  {
    this->Light += weight * other.Light;
    this->Angle += weight * other.Angle;
    this->Cross += weight * other.Cross;
    this->Place[0] += weight * other.Place[0];
    this->Place[1] += weight * other.Place[1];
  }
};

/// The weights of cells around a place between them, with that mean and a variance.
struct Kernel
{
  /// Sets weights for three cells or, where \a isWide allows it, as many as are needed. \a variance
  /// becomes what the kernel has.
  Kernel(double mean, double& variance, bool isWide)
  {
    const double nearest = std::floor(mean + 0.5);
    const double rest = mean - nearest;
    const double least = std::abs(rest) * (1.0 - std::abs(rest));
    variance = std::max(variance, least);
    if (!isWide || variance + rest * rest <= LargestThree)
    {
      variance = std::max(std::min(variance, LargestThree - rest * rest), least);
      const double square = variance + rest * rest;
      this->First = static_cast<int>(nearest) - 1;
      this->Count = 3;
      this->Weights[0] = 0.5 * (square - rest);
      this->Weights[1] = 1.0 - square;
      this->Weights[2] = 0.5 * (square + rest);
      return;
    }
    variance = std::min(variance, LargestKernel);
    const int reach = std::min(static_cast<int>(std::ceil(3.5 * std::sqrt(variance))), Reach);
    this->First = static_cast<int>(nearest) - reach;
    this->Count = 2 * reach + 1;
    // From the middle outwards, each weight by the one before.
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

  static constexpr int Reach = 70;
  int First = 0;
  int Count = 0;
  /// Of which Count are set.
  std::array<double, 2 * Reach + 1> Weights; // NOLINT(cppcoreguidelines-pro-type-member-init)
};

/// Returns the index in a row of cells, which is repeated where it \a isEndless, or -1 outside.
int Inside(int index, int cells, bool isEndless)
{
  if (isEndless)
  {
    return ((index % cells) + cells) % cells;
  }
  return index >= 0 && index < cells ? index : -1;
}

/// Scattering within one cell.
class CellStep
{
public:
  CellStep(const MatterCells& matter, std::size_t light, double share, double variance)
    : Matter(matter)
    , Direct(matter.Direct[light])
    , Share(share)
    , Variance(variance)
  {
  }

  /**
   * Turns the light that enters a cell into what leaves it after a path of \a length; returns the
   * mean. \a spread is the variance of place that one square unit adds, along each of two axes.
   */
  glm::dvec3 Go(
    std::size_t cell, double length, const std::array<double, 2>& spread, Beam& beam) const
  {
    if (this->Matter.Box.IsBlocked(cell))
    {
      beam = Beam();
      return glm::dvec3(0.0);
    }
    const double depth = this->Matter.Extinction[cell] * length;
    const glm::dvec3 entering = beam.Light;
    const double before = beam.GetSum();
    double kept = before;
    double events = 0.0;
    glm::dvec3 mean = entering;
    if (depth > 0.0)
    {
      const glm::dvec3 on = depth * this->Share * glm::dvec3(this->Matter.Albedo[cell]);
      const glm::dvec3 lost = depth - on;
      const glm::dvec3 direct = this->Direct[cell];
      // The direct light where the ray enters, from its mean.
      const glm::dvec3 first = direct * (depth / -std::expm1(-depth));
      kept = 0.0;
      for (int color = 0; color < 3; ++color)
      {
        const double through = std::exp(-lost[color]);
        const double added = first[color] * through * -std::expm1(-on[color]);
        const double leaving = entering[color] * through + added;
        kept += entering[color] * through;
        mean[color] = lost[color] > 1e-3
          ? (entering[color] + on[color] * direct[color] - leaving) / lost[color]
          : (entering[color] + first[color]) * (1.0 - 0.5 * lost[color]) - direct[color];
        mean[color] = std::max(mean[color], 0.0);
        beam.Light[color] = leaving;
        events += on[color] * (direct[color] + mean[color]) * std::exp(-0.5 * lost[color]);
      }
    }
    this->Move(before > 0.0 ? kept / before : 0.0, events, length, spread, beam);
    return mean;
  }

  /**
   * Moves light on, of which the share \a left entered the cell and which was scattered
   * \a events times.
   */
  void Move(double left, double events, double length, const std::array<double, 2>& spread,
    Beam& beam) const
  {
    const double after = beam.GetSum();
    if (!(after > 0.0))
    {
      beam = Beam();
      return;
    }
    const double angle = left * beam.Angle;
    const double cross = left * beam.Cross;
    const double turned = this->Variance * events;
    beam.Angle = std::min(angle + turned, LargestAngle * after);
    beam.Cross = cross + angle * length + 0.5 * turned * length;
    // Light is placed as it is in the middle of a layer: half of the way through the next is given
    // before, half of the way through this one was.
    const double place = 2.0 * cross * length + (angle + turned / 3.0) * length * length -
      GetDrift(angle, cross, length) + GetDrift(beam.Angle, beam.Cross, length);
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      beam.Place[axis] = left * beam.Place[axis] + spread[axis] * place;
    }
  }

  bool HasSpread() const { return this->Variance > 0.0; }

private:
  /// Returns what half of a way adds to the variance of place.
  static double GetDrift(double angle, double cross, double length)
  {
    return cross * length + 0.25 * angle * length * length;
  }

  const MatterCells& Matter;
  const std::vector<glm::vec3>& Direct;
  double Share;
  double Variance;
};

/// The axes across and along which light goes through layers.
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

/// One layer's beams on their way to the next.
class LayerShift
{
public:
  LayerShift(int columns, int rows, const glm::bvec2& mirrors, const std::array<double, 2>& shift)
    : Sizes{ { columns, rows } }
    , Mirrors(mirrors)
    , Shift(shift)
  {
  }

  /// Moves and spreads the beams along one axis after the other.
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
    const std::size_t place = static_cast<std::size_t>(axis);
    const double sum = beam.GetSum();
    if (!(sum > 0.0))
    {
      return;
    }
    double variance = beam.Place[place] / sum;
    const Kernel kernel(this->Shift[place], variance, true);
    beam.Place[place] -= variance * sum;
    for (int i = 0; i < kernel.Count; ++i)
    {
      const int offset = kernel.First + i;
      const int at =
        Inside((axis == 0 ? column : row) + offset, this->Sizes[place], this->Mirrors[axis]);
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

/// Solves for light in one direction, in layers; the light that leaves a layer is given to others.
std::vector<glm::vec3> SolveLayers(
  const MatterCells& matter, const CellStep& step, const glm::dvec3& direction, int& layers)
{
  const ScatteringMedium& box = matter.Box;
  const glm::dvec3 inCells = direction / box.CellSize;
  // Light comes from outside, where there is no mirror.
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
    ? glm::ivec2(MarginShare * glm::dvec2(sizes)) * glm::ivec2(!mirrors.x, !mirrors.y)
    : glm::ivec2(0);
  LayerShift move(sizes.x + 2 * margin.x, sizes.y + 2 * margin.y, mirrors, shift);
  std::vector<Beam> beams(
    static_cast<std::size_t>((sizes.x + 2 * margin.x) * (sizes.y + 2 * margin.y)));
  std::vector<glm::vec3> result(matter.Extinction.size(), glm::vec3(0.0f));
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

/// Solves for light from a place: each cell takes what comes to it from cells nearer to the light.
class PlaceSweep
{
public:
  PlaceSweep(const MatterCells& matter, const CellStep& step, const glm::dvec3& position)
    : Matter(matter)
    , Step(step)
    , Place((position - matter.Box.Origin) / matter.Box.CellSize - 0.5)
    , Reach(matter.Extinction.size())
    , Leaving(matter.Extinction.size())
  {
  }

  std::vector<glm::vec3> Solve(int& layers)
  {
    const glm::ivec3& cells = this->Matter.Box.Cells;
    std::vector<std::size_t> order(this->Reach.size());
    std::iota(order.begin(), order.end(), 0);
    for (const std::size_t index : order)
    {
      this->Reach[index] = Vectors::InfinityNorm(glm::dvec3(this->GetCell(index)) - this->Place);
    }
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) { return this->Reach[a] < this->Reach[b]; });
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
    const glm::ivec3& cells = this->Matter.Box.Cells;
    const int number = static_cast<int>(index);
    return { number % cells.x, number / cells.x % cells.y, number / (cells.x * cells.y) };
  }

  /// Returns the mean of the cell, and keeps what leaves it.
  glm::dvec3 Visit(std::size_t index)
  {
    const glm::ivec3 cell = this->GetCell(index);
    const glm::dvec3 away = glm::dvec3(cell) - this->Place;
    const Axes axes(away);
    const double reach = this->Reach[index];
    const glm::dvec3 inWorld = away * this->Matter.Box.CellSize;
    Beam& beam = this->Leaving[index];
    double length = 0.5 * this->Matter.Box.CellSize[axes.Along];
    std::array<double, 2> spread{};
    if (reach > 0.0)
    {
      // From the layer before, or from the light where it is nearer.
      length = Vectors::SafeLength(inWorld) / reach * std::min(1.0, reach + 0.5);
      for (std::size_t i = 0; i < 2; ++i)
      {
        const double size = this->Matter.Box.CellSize[axes.Across[i]];
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
    const ScatteringMedium& box = this->Matter.Box;
    glm::ivec3 from = cell;
    from[axes.Along] -= away[axes.Along] > 0.0 ? 1 : -1;
    Beam sum;
    if (from[axes.Along] < 0 || from[axes.Along] >= box.Cells[axes.Along])
    {
      return sum;
    }
    const glm::dvec3 place = glm::dvec3(cell) - away / reach;
    // The variance that the light at the place has to be given decides about the kernel.
    std::array<double, 2> variance = { { 0.0, 0.0 } };
    for (std::size_t i = 0; i < 2; ++i)
    {
      from[axes.Across[i]] = static_cast<int>(std::floor(place[axes.Across[i]] + 0.5));
    }
    if (this->IsBefore(from, reach))
    {
      const Beam& nearest = this->Leaving[box.GetIndex(from)];
      const double light = nearest.GetSum();
      for (std::size_t i = 0; i < 2 && light > 0.0; ++i)
      {
        variance[i] = nearest.Place[i] / light;
      }
    }
    const Kernel rows(place[axes.Across[1]], variance[1], false);
    const Kernel columns(place[axes.Across[0]], variance[0], false);
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
    // Light goes apart: what comes from the layer before is spread over more cells, as many as lie
    // around the light.
    const double closer = (reach - 1.0) * (reach - 1.0) + 1.0 / 12.0;
    Beam mean;
    mean.Add(total > 0.0 ? closer / (reach * reach + 1.0 / 12.0) / total : 0.0, sum);
    for (std::size_t i = 0; i < 2; ++i)
    {
      mean.Place[i] -= variance[i] * mean.GetSum();
    }
    return mean;
  }

  bool IsBefore(const glm::ivec3& cell, double reach) const
  {
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
      glm::all(glm::lessThan(cell, this->Matter.Box.Cells)) &&
      this->Reach[this->Matter.Box.GetIndex(cell)] < reach;
  }

  const MatterCells& Matter;
  const CellStep& Step;
  /// The light's place, where cell 0 has its middle at 0.
  glm::dvec3 Place;
  std::vector<double> Reach;
  std::vector<Beam> Leaving;
};

}

std::vector<glm::vec3> ForwardLight::Solve(
  const MatterCells& matter, std::size_t light, double share, double variance, int& layers)
{
  const CellStep step(matter, light, share, variance);
  const ScatteringLight& source = matter.Lights[light];
  return source.IsPositional ? PlaceSweep(matter, step, source.Position).Solve(layers)
                             : SolveLayers(matter, step, source.Direction, layers);
}

}
