// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/EscapeRays.h"

#include "Scattering/CellRay.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <boost/math/quadrature/gauss.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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
  /// Position of rays within their parts of a side. Neither the directions around an axis nor those
  /// of the same angle around it share a position, so that together they sample a cell evenly.
  glm::dvec2 Place{ 0.5 };
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
        const double ring = static_cast<double>(ordinates.size() / turns);
        ordinate.Place = glm::fract(glm::dvec2(1.0, 3.0) * ((turn + 0.5) / turns) +
          ring * glm::dvec2(0.41421356237, 0.73205080757));
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
constexpr int MostRays = 8;

/**
 * The fields of all sources, cell by cell: a fluence of each source, and a lean behind that of a
 * source that has one. A ray looks all of them up in the same eight cells.
 */
class SourceFields
{
public:
  explicit SourceFields(const std::vector<EscapeRays::Source>& sources)
  {
    for (const EscapeRays::Source& source : sources)
    {
      this->Count += source.Lean ? 2 : 1;
    }
    const std::size_t cells = sources.empty() ? 0 : sources.front().Fluence->size();
    this->Values.resize(cells * this->Count);
    std::size_t place = 0;
    for (const EscapeRays::Source& source : sources)
    {
      this->Set(place++, *source.Fluence);
      if (source.Lean)
      {
        this->Set(place++, *source.Lean);
      }
    }
  }

  std::size_t GetCount() const { return this->Count; }
  /// Returns the first field in a cell.
  const glm::vec4* Get(std::size_t cell) const { return this->Values.data() + cell * this->Count; }

private:
  void Set(std::size_t place, const std::vector<glm::vec3>& values)
  {
    for (std::size_t cell = 0; cell < values.size(); ++cell)
    {
      this->Values[cell * this->Count + place] = glm::vec4(values[cell], 0.0f);
    }
  }

  std::size_t Count = 0;
  std::vector<glm::vec4> Values;
};

class DirectionTrace
{
public:
  DirectionTrace(const MatterCells& matter, const MeanPhase& phase,
    const std::vector<EscapeRays::Source>& sources, const SourceFields& fields,
    const Ordinate& ordinate, bool isBack)
    : Cells(matter)
    , Phase(phase)
    , Sources(sources)
    , Fields(fields)
    , Out(ordinate.Out)
    , Weight(ordinate.Weight)
    , Place(ordinate.Place)
    , IsBack(isBack)
    , Seen(fields.GetCount())
  {
    this->Result.resize(sources.size());
    for (const EscapeRays::Source& source : sources)
    {
      const bool isEven = source.Light && !source.Light->IsPositional;
      this->Factors.push_back(isEven ? this->GetPhase(*source.Light, {}, this->Out) : 0.0);
    }
  }

  /// The optical depth of the matter that rays met times their areas.
  double GetMet() const { return this->Met; }

  std::vector<EscapeRays::Sums> Go()
  {
    const ScatteringMedium& box = this->Cells.Box;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (box.Mirrors[axis])
      {
        continue;
      }
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const int rows = std::min(box.Cells[v], MostRays);
      const int columns = std::min(box.Cells[u], MostRays);
      const double area = box.CellSize[u] * box.Cells[u] / columns * box.CellSize[v] *
        box.Cells[v] / rows * std::abs(this->Out[axis]) * this->Weight;
      glm::dvec3 start(0.0);
      start[axis] = this->Out[axis] > 0.0 ? box.Cells[axis] : 0.0;
      for (int row = 0; row < rows; ++row)
      {
        start[v] = (row + this->Place.y) * box.Cells[v] / rows;
        for (int column = 0; column < columns; ++column)
        {
          start[u] = (column + this->Place.x) * box.Cells[u] / columns;
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
    const ScatteringMedium& box = this->Cells.Box;
    double through = 1.0;
    double lost = 0.0;
    bool isBlocked = false;
    do
    {
      const std::size_t cell = ray.GetIndex();
      const double extinction = this->Cells.Extinction[cell];
      if (box.IsBlocked(cell))
      {
        // What is beyond ends here.
        through = 1.0;
        lost = 0.0;
        isBlocked = true;
      }
      else if (extinction > 0.0)
      {
        const double length = ray.GetExit() - ray.GetEntry();
        const double depth = extinction * length;
        if (!(depth > 0.0))
        {
          continue;
        }
        // depth - own, of which nothing cancels where depths are small.
        const double left = std::exp(-depth);
        const double ended = depth < 1e-2
          ? depth * depth * (0.5 - depth * (1.0 / 6.0 - depth / 24.0))
          : depth - 1.0 + left;
        const double own = depth - ended;
        this->Met += area * depth;
        // Where the eye sees the ray's way in the cell on the average, as slices look it up.
        const double part = depth < 0.05 ? 0.5 - depth / 12.0 : 1.0 / depth - left / own;
        this->FindSeen(ray.GetPlace(ray.GetEntry() + part * length), cell);
        const double kept = area * (depth * lost + through * ended);
        const double out = area * through * own;
        const glm::vec4* seen = this->Seen.data();
        for (std::size_t i = 0; i < this->Sources.size(); ++i)
        {
          const glm::dvec3 color = this->GetColor(i, ray, cell, seen);
          EscapeRays::Sums& sums = this->Result[i];
          sums.Kept += kept * color;
          (isBlocked ? sums.Blocked : (this->IsBack ? sums.Back : sums.On)) += out * color;
        }
        lost += through * own;
        through *= 1.0 - own;
      }
    } while (ray.Advance());
  }

  /// Looks all fields up at a place in or on the sides of \a cell. Blocked cells have none of them;
  /// here they have what \a cell has, which is no less.
  void FindSeen(const glm::dvec3& place, std::size_t cell)
  {
    const ScatteringMedium& box = this->Cells.Box;
    const glm::dvec3 at = glm::clamp(place - 0.5, glm::dvec3(0.0), glm::dvec3(box.Cells - 1));
    const glm::ivec3 lower(at);
    const glm::vec3 share(at - glm::dvec3(lower));
    const std::size_t row = static_cast<std::size_t>(box.Cells.x);
    const std::size_t layer = row * static_cast<std::size_t>(box.Cells.y);
    const std::size_t first = box.GetIndex(lower);
    const std::array<std::size_t, 3> next = { { lower.x + 1 < box.Cells.x ? std::size_t{ 1 } : 0,
      lower.y + 1 < box.Cells.y ? row : 0, lower.z + 1 < box.Cells.z ? layer : 0 } };
    std::fill(this->Seen.begin(), this->Seen.end(), glm::vec4(0.0f));
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const bool isX = (corner & 1u) != 0;
      const bool isY = (corner & 2u) != 0;
      const bool isZ = (corner & 4u) != 0;
      const std::size_t other =
        first + (isX ? next[0] : 0) + (isY ? next[1] : 0) + (isZ ? next[2] : 0);
      const float weight = (isX ? share.x : 1.0f - share.x) * (isY ? share.y : 1.0f - share.y) *
        (isZ ? share.z : 1.0f - share.z);
      const glm::vec4* values = this->Fields.Get(box.IsBlocked(other) ? cell : other);
      for (glm::vec4& sum : this->Seen)
      {
        sum += weight * *values++;
      }
    }
  }

  double GetPhase(const ScatteringLight& light, const glm::ivec3& cell, const glm::dvec3& out) const
  {
    const ScatteringMedium& box = this->Cells.Box;
    const glm::dvec3 middle = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
    return this->Phase.Get(glm::dot(light.GetDirection(middle), out));
  }

  /// Returns what a source sends out against the ray; \a seen becomes the next source's.
  glm::vec3 GetColor(
    std::size_t number, const CellRay& ray, std::size_t cell, const glm::vec4*& seen) const
  {
    const EscapeRays::Source& source = this->Sources[number];
    const glm::vec3 fluence(*seen++);
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
      const glm::dvec3 lean(*seen++);
      factor = std::max(1.0 - source.LeanFactor * glm::dot(lean, ray.GetDirection()), 0.0);
    }
    return static_cast<float>(factor) * fluence * this->Cells.Albedo[cell];
  }

  const MatterCells& Cells;
  const MeanPhase& Phase;
  const std::vector<EscapeRays::Source>& Sources;
  const SourceFields& Fields;
  glm::dvec3 Out;
  double Weight;
  glm::dvec2 Place;
  bool IsBack;
  /// The phase function for each light in a direction.
  std::vector<double> Factors;
  /// The fields where the ray is.
  std::vector<glm::vec4> Seen;
  std::vector<EscapeRays::Sums> Result;
  double Met = 0.0;
};

}

void EscapeRays::Sums::Add(const Sums& other)
{
  this->Kept += other.Kept;
  this->Back += other.Back;
  this->On += other.On;
  this->Blocked += other.Blocked;
}

void EscapeRays::Sums::Scale(const glm::dvec3& factor)
{
  for (glm::dvec3* part : { &this->Kept, &this->Back, &this->On, &this->Blocked })
  {
    *part *= factor;
  }
}

void EscapeRays::Sums::ScaleTo(const glm::dvec3& sent)
{
  const glm::dvec3 found = this->Kept + this->GetOut();
  glm::dvec3 factor(1.0);
  for (int color = 0; color < 3; ++color)
  {
    factor[color] = found[color] > 0.0 ? sent[color] / found[color] : 1.0;
    // No ray enters a box of mirrors.
    this->Kept[color] = found[color] > 0.0 ? this->Kept[color] : sent[color];
  }
  this->Scale(factor);
}

void EscapeRays::Sums::ScaleOut(double matter)
{
  const glm::dvec3 out = this->GetOut();
  glm::dvec3 factor(1.0);
  for (int color = 0; color < 3; ++color)
  {
    const double found = this->Kept[color] + out[color];
    factor[color] += found > 0.0 ? out[color] / found * (matter - 1.0) : 0.0;
  }
  this->Scale(factor);
}

std::vector<EscapeRays::Sums> EscapeRays::Trace(const MatterCells& matter,
  const PhaseFunction& phase, const std::vector<Source>& sources, const glm::dvec3& direction)
{
  const std::vector<Ordinate> ordinates = MakeOrdinates();
  const MeanPhase meanPhase(phase, ordinates.size());
  const SourceFields cellFields(sources);
  std::vector<std::vector<Sums>> parts(ordinates.size());
  std::vector<double> met(ordinates.size(), 0.0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(ordinates.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::size_t at = static_cast<std::size_t>(i);
        const bool isBack = glm::dot(ordinates[at].Out, direction) < 0.0;
        DirectionTrace trace(matter, meanPhase, sources, cellFields, ordinates[at], isBack);
        parts[at] = trace.Go();
        met[at] = trace.GetMet();
      }
    });
  double present = 0.0;
  for (const float extinction : matter.Extinction)
  {
    present += matter.CellVolume * extinction;
  }
  const double found = std::accumulate(met.begin(), met.end(), 0.0);
  std::vector<Sums> sums(sources.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    for (const std::vector<Sums>& part : parts)
    {
      sums[i].Add(part[i]);
    }
    // Rays meet a little more or less matter than there is, and few directions meet a narrow phase
    // function as it is.
    glm::dvec3 sent(0.0);
    for (std::size_t cell = 0; cell < matter.Extinction.size(); ++cell)
    {
      sent += matter.CellVolume * matter.Extinction[cell] *
        glm::dvec3((*sources[i].Fluence)[cell] * matter.Albedo[cell]);
    }
    if (sources[i].Light)
    {
      sums[i].ScaleTo(sent);
    }
    else
    {
      sums[i].ScaleOut(found > 0.0 ? present / found : 1.0);
    }
  }
  return sums;
}

}
