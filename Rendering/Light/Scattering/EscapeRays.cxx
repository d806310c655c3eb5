// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/EscapeRays.h"

#include "Scattering/CellRay.h"
#include "Scattering/LightSlopes.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <boost/math/quadrature/gauss.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A direction, and the directions' share of the sphere.
struct Ordinate
{
  glm::dvec3 Out{ 0.0 };
  double Weight = 0.0;
};

/**
 * Returns 192 directions: about each of the three axes, eight around it at the cosines of Gauss'
 * quadrature between 0 and 1 to either side, so that light along thin layers is met too.
 */
std::vector<Ordinate> MakeOrdinates()
{
  constexpr int turns = 8;
  const auto& nodes = boost::math::quadrature::gauss<double, 4>::abscissa();
  const auto& weights = boost::math::quadrature::gauss<double, 4>::weights();
  std::vector<Ordinate> ordinates;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < 8; ++i)
    {
      // Both signs of a node, and both sides of the sphere.
      const double node = (i & 1 ? -1.0 : 1.0) * nodes[i / 4];
      const double cosine = 0.5 * (1.0 + node);
      const double across = std::sqrt(1.0 - cosine * cosine);
      for (int turn = 0; turn < turns; ++turn)
      {
        const double angle = 2.0 * Pi * (turn + 0.5) / turns;
        Ordinate ordinate;
        ordinate.Out[axis] = i & 2 ? -cosine : cosine;
        ordinate.Out[(axis + 1) % 3] = across * std::cos(angle);
        ordinate.Out[(axis + 2) % 3] = across * std::sin(angle);
        ordinate.Weight = weights[i / 4] / (3.0 * 4.0 * turns);
        ordinates.push_back(ordinate);
      }
    }
  }
  return ordinates;
}

/// The phase function over that of an isotropic one, its mean over one direction's share.
class MeanPhase
{
public:
  MeanPhase(const PhaseFunction& phase, std::size_t directions)
    : Values(Number + 1)
  {
    constexpr int rings = 4;
    constexpr int turns = 8;
    for (std::size_t i = 0; i <= Number; ++i)
    {
      const double cosine = 2.0 * static_cast<double>(i) / Number - 1.0;
      const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      for (int ring = 0; ring < rings; ++ring)
      {
        const double cap = 1.0 - 2.0 * (ring + 0.5) / rings / static_cast<double>(directions);
        const double across = std::sqrt(1.0 - cap * cap);
        for (int turn = 0; turn < turns; ++turn)
        {
          const double angle = Pi * (turn + 0.5) / turns;
          this->Values[i] += 4.0 * Pi / (rings * turns) *
            phase.Value(cosine * cap + sine * across * std::cos(angle));
        }
      }
    }
  }

  double Get(double cosine) const
  {
    const double place = glm::clamp(0.5 * (cosine + 1.0), 0.0, 1.0) * Number;
    const std::size_t below = std::min(static_cast<std::size_t>(place), Number - 1);
    const double share = place - static_cast<double>(below);
    return (1.0 - share) * this->Values[below] + share * this->Values[below + 1];
  }

private:
  static constexpr std::size_t Number = 512;
  std::vector<double> Values;
};

/// The largest number of rays along a side of the box.
constexpr int MostRays = 16;

class DirectionTrace
{
public:
  DirectionTrace(const MatterCells& matter, const MeanPhase& phase,
    const std::vector<EscapeRays::Source>& sources, const Ordinate& ordinate, bool isBack)
    : Matter(matter)
    , Phase(phase)
    , Sources(sources)
    , Out(ordinate.Out)
    , Weight(ordinate.Weight)
    , IsBack(isBack)
  {
    this->Result.resize(sources.size());
    for (const EscapeRays::Source& source : sources)
    {
      const bool isEven = source.Light && !source.Light->IsPositional;
      this->Factors.push_back(isEven ? this->GetPhase(*source.Light, {}, this->Out) : 0.0);
    }
  }

  std::vector<EscapeRays::Sums> Go()
  {
    const ScatteringMedium& box = this->Matter.Box;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (box.Mirrors[axis])
      {
        continue;
      }
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const double rowStep = (box.Cells[v] + MostRays - 1) / MostRays;
      const double columnStep = (box.Cells[u] + MostRays - 1) / MostRays;
      const double area = box.CellSize[u] * columnStep * box.CellSize[v] * rowStep *
        std::abs(this->Out[axis]) * this->Weight;
      glm::dvec3 start(0.0);
      start[axis] = this->Out[axis] > 0.0 ? box.Cells[axis] : 0.0;
      for (start[v] = 0.5 * rowStep; start[v] < box.Cells[v]; start[v] += rowStep)
      {
        for (start[u] = 0.5 * columnStep; start[u] < box.Cells[u]; start[u] += columnStep)
        {
          this->Follow(CellRay(box, start, -this->Out), area);
        }
      }
    }
    return this->Result;
  }

private:
  /// Follows a ray from where it leaves the box to where it enters.
  void Follow(CellRay ray, double area)
  {
    const ScatteringMedium& box = this->Matter.Box;
    double through = 1.0;
    double lost = 0.0;
    bool isBlocked = false;
    do
    {
      const std::size_t cell = box.GetIndex(ray.GetCell());
      const double depth = this->Matter.Extinction[cell] * (ray.GetExit() - ray.GetEntry());
      if (box.IsBlocked(cell))
      {
        // What is beyond ends here.
        through = 1.0;
        lost = 0.0;
        isBlocked = true;
      }
      else if (depth > 0.0)
      {
        // depth - own, of which nothing cancels where depths are small.
        const double ended = depth < 1e-2
          ? depth * depth * (0.5 - depth * (1.0 / 6.0 - depth / 24.0))
          : depth - 1.0 + std::exp(-depth);
        const double own = depth - ended;
        for (std::size_t i = 0; i < this->Sources.size(); ++i)
        {
          const double within = this->GetEnded(this->Sources[i], cell, ray, depth, ended);
          const glm::dvec3 color = this->GetColor(i, ray, cell);
          EscapeRays::Sums& sums = this->Result[i];
          sums.Kept += area * (depth * lost + through * within) * color;
          (isBlocked ? sums.Blocked : (this->IsBack ? sums.Back : sums.On)) +=
            area * through * (depth - within) * color;
        }
        lost += through * own;
        through *= 1.0 - own;
      }
    } while (ray.Advance());
  }

  /// Returns what of a source of strength \a depth along the ray does not leave the cell; \a even
  /// for an even source.
  double GetEnded(const EscapeRays::Source& source, std::size_t cell, const CellRay& ray,
    double depth, double even) const
  {
    if (!source.Slopes || depth < 1e-2)
    {
      return even;
    }
    const glm::dvec3 way =
      ray.GetDirection() * (ray.GetExit() - ray.GetEntry()) / this->Matter.Box.CellSize;
    const double slope = glm::dot(glm::dvec3((*source.Slopes)[cell]), way);
    return depth * (1.0 - LightSlopes::GetEscape(depth, glm::clamp(slope, -50.0, 50.0)));
  }

  double GetPhase(const ScatteringLight& light, const glm::ivec3& cell, const glm::dvec3& out) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    const glm::dvec3 middle = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
    return this->Phase.Get(glm::dot(light.GetDirection(middle), out));
  }

  /// Returns what a source sends out against the ray.
  glm::vec3 GetColor(std::size_t number, const CellRay& ray, std::size_t cell) const
  {
    const EscapeRays::Source& source = this->Sources[number];
    double factor = 1.0;
    if (source.Light)
    {
      // Mirrors have turned the ray.
      const bool isSame = !source.Light->IsPositional && ray.GetDirection() == -this->Out;
      factor = isSame ? this->Factors[number]
                      : this->GetPhase(*source.Light, ray.GetCell(), -ray.GetDirection());
    }
    else if (source.Lean)
    {
      factor -= source.LeanFactor * glm::dot(glm::dvec3((*source.Lean)[cell]), ray.GetDirection());
    }
    return static_cast<float>(factor) * (*source.Fluence)[cell] * this->Matter.Albedo[cell];
  }

  const MatterCells& Matter;
  const MeanPhase& Phase;
  const std::vector<EscapeRays::Source>& Sources;
  glm::dvec3 Out;
  double Weight;
  bool IsBack;
  /// The phase function for each light in a direction.
  std::vector<double> Factors;
  std::vector<EscapeRays::Sums> Result;
};

}

void EscapeRays::Sums::Add(const Sums& other)
{
  this->Kept += other.Kept;
  this->Back += other.Back;
  this->On += other.On;
  this->Blocked += other.Blocked;
}

void EscapeRays::Sums::ScaleTo(const glm::dvec3& sent)
{
  const glm::dvec3 found = this->Kept + this->GetOut();
  for (int color = 0; color < 3; ++color)
  {
    if (!(found[color] > 0.0))
    {
      // No ray enters a box of mirrors.
      this->Kept[color] = sent[color];
      continue;
    }
    for (glm::dvec3* part : { &this->Kept, &this->Back, &this->On, &this->Blocked })
    {
      (*part)[color] *= sent[color] / found[color];
    }
  }
}

std::vector<EscapeRays::Sums> EscapeRays::Trace(const MatterCells& matter,
  const PhaseFunction& phase, const std::vector<Source>& sources, const glm::dvec3& direction)
{
  const std::vector<Ordinate> ordinates = MakeOrdinates();
  const MeanPhase meanPhase(phase, ordinates.size());
  std::vector<std::vector<Sums>> parts(ordinates.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(ordinates.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::size_t at = static_cast<std::size_t>(i);
        const bool isBack = glm::dot(ordinates[at].Out, direction) < 0.0;
        parts[at] = DirectionTrace(matter, meanPhase, sources, ordinates[at], isBack).Go();
      }
    });
  std::vector<Sums> sums(sources.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    for (const std::vector<Sums>& part : parts)
    {
      sums[i].Add(part[i]);
    }
    // Rays meet a little more or less matter than there is.
    glm::dvec3 sent(0.0);
    for (std::size_t cell = 0; cell < matter.Extinction.size(); ++cell)
    {
      sent += matter.CellVolume * matter.Extinction[cell] *
        glm::dvec3((*sources[i].Fluence)[cell] * matter.Albedo[cell]);
    }
    sums[i].ScaleTo(sent);
  }
  return sums;
}

}
