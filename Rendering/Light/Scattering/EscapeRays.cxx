// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/EscapeRays.h"

#include "Scattering/CellRay.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{

/// A direction, and the directions' share of the sphere.
struct Ordinate
{
  glm::dvec3 Out{ 0.0 };
  double Weight = 0.0;
};

/// Returns the 80 directions of the level-symmetric quadrature S8.
std::vector<Ordinate> MakeOrdinates()
{
  constexpr std::array<double, 4> levels = { { 0.2182179, 0.5773503, 0.7867958, 0.9511897 } };
  std::vector<Ordinate> ordinates;
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; i + j < 4; ++j)
    {
      const std::size_t k = 3 - i - j;
      const std::size_t largest = std::max({ i, j, k });
      const double weight = largest == 3 ? 0.1209877 : (largest == 2 ? 0.0907407 : 0.0925926);
      for (int signs = 0; signs < 8; ++signs)
      {
        Ordinate ordinate;
        ordinate.Out = glm::dvec3(levels[i], levels[j], levels[k]);
        for (int axis = 0; axis < 3; ++axis)
        {
          ordinate.Out[axis] *= signs >> axis & 1 ? -1.0 : 1.0;
        }
        ordinate.Out = glm::normalize(ordinate.Out);
        ordinate.Weight = weight;
        sum += weight;
        ordinates.push_back(ordinate);
      }
    }
  }
  for (Ordinate& ordinate : ordinates)
  {
    ordinate.Weight /= sum;
  }
  return ordinates;
}

/// The largest number of rays along a side of the box.
constexpr int MostRays = 32;

class DirectionTrace
{
public:
  DirectionTrace(const MatterCells& matter, const std::vector<EscapeRays::Source>& sources,
    const Ordinate& ordinate, bool isBack)
    : Matter(matter)
    , Sources(sources)
    , Out(ordinate.Out)
    , Weight(ordinate.Weight)
    , IsBack(isBack)
  {
    this->Result.resize(sources.size());
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
        const double own = -std::expm1(-depth);
        // depth - through own, of which nothing cancels where depths are small.
        const double kept = depth * lost +
          through * (depth < 1e-3 ? depth * depth * (0.5 - depth / 6.0) : depth - own);
        this->Add(cell, -ray.GetDirection(), isBlocked, area * through * own, area * kept);
        lost += through * own;
        through *= 1.0 - own;
      }
    } while (ray.Advance());
  }

  void Add(std::size_t cell, const glm::dvec3& out, bool isBlocked, double leaving, double kept)
  {
    for (std::size_t i = 0; i < this->Sources.size(); ++i)
    {
      const EscapeRays::Source& source = this->Sources[i];
      const glm::dvec3 color =
        glm::dvec3(source.Color[cell]) * (1.0 + glm::dot(glm::dvec3(source.Lean[cell]), out));
      EscapeRays::Sums& sums = this->Result[i];
      sums.Kept += kept * color;
      (isBlocked ? sums.Blocked : (this->IsBack ? sums.Back : sums.On)) += leaving * color;
    }
  }

  const MatterCells& Matter;
  const std::vector<EscapeRays::Source>& Sources;
  glm::dvec3 Out;
  double Weight;
  bool IsBack;
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

std::vector<EscapeRays::Sums> EscapeRays::Trace(
  const MatterCells& matter, const std::vector<Source>& sources, const glm::dvec3& direction)
{
  const std::vector<Ordinate> ordinates = MakeOrdinates();
  std::vector<std::vector<Sums>> parts(ordinates.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(ordinates.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::size_t at = static_cast<std::size_t>(i);
        const bool isBack = glm::dot(ordinates[at].Out, direction) < 0.0;
        parts[at] = DirectionTrace(matter, sources, ordinates[at], isBack).Go();
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
      sent += matter.CellVolume * matter.Extinction[cell] * glm::dvec3(sources[i].Color[cell]);
    }
    sums[i].ScaleTo(sent);
  }
  return sums;
}

}
