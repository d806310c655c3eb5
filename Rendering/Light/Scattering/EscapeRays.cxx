// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/EscapeRays.h"

#include "Common/ParallelFor.h"
#include "Scattering/CellRay.h"

#include "vtkMath.h"
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

/// A direction in which light leaves the box, and the fraction of the sphere that it represents.
struct Ordinate
{
  glm::dvec3 Out{ 0.0 };
  double Weight = 0.0;
  /// Position of each ray within its cell of the ray grid on a box face. It differs between
  /// directions, so that together they sample the face uniformly.
  glm::dvec2 Offset{ 0.5 };
};

/**
 * Returns 192 directions: eight azimuths around each axis, for each of four Gauss-Legendre cosines
 * between 0 and 1 and their negatives. Some directions are nearly parallel to a coordinate plane,
 * so that light along thin layers is sampled too.
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
      // Boost stores only the positive nodes. Each cosine is used in both hemispheres.
      const double node = (i & 1 ? -1.0 : 1.0) * nodes[i / 4];
      const double cosine = 0.5 * (1.0 + node);
      const double across = std::sqrt(1.0 - cosine * cosine);
      for (int turn = 0; turn < turns; ++turn)
      {
        const double angle = 2.0 * vtkMath::Pi() * (turn + 0.5) / turns;
        Ordinate ordinate;
        ordinate.Out[axis] = i & 2 ? -cosine : cosine;
        ordinate.Out[(axis + 1) % 3] = across * std::cos(angle);
        ordinate.Out[(axis + 2) % 3] = across * std::sin(angle);
        ordinate.Weight = weights[i / 4] / (3.0 * 4.0 * turns);
        const double ring = static_cast<double>(ordinates.size() / turns);
        ordinate.Offset = glm::fract(glm::dvec2(1.0, 3.0) * ((turn + 0.5) / turns) +
          ring * glm::dvec2(0.41421356237, 0.73205080757));
        ordinates.push_back(ordinate);
      }
    }
  }
  return ordinates;
}

/// The phase function relative to an isotropic one, averaged over the solid angle of an ordinate.
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
          const double angle = vtkMath::Pi() * (turn + 0.5) / turns;
          this->Values[i] += 4.0 * vtkMath::Pi() / (rings * turns) *
            phase.Value(cosine * cap + sine * across * std::cos(angle));
        }
      }
    }
  }

  double Get(double cosine) const
  {
    const double position = glm::clamp(0.5 * (cosine + 1.0), 0.0, 1.0) * Number;
    const std::size_t below = std::min(static_cast<std::size_t>(position), Number - 1);
    const double fraction = position - static_cast<double>(below);
    return (1.0 - fraction) * this->Values[below] + fraction * this->Values[below + 1];
  }

private:
  static constexpr std::size_t Number = 512;
  std::vector<double> Values;
};

/// Maximum number of rays along an edge of a box face.
constexpr int MaximumRays = 8;

/**
 * The fields of all sources, interleaved per cell: for each source its Fluence, followed by its
 * NetFlux if it has one. A ray samples all fields at the same positions.
 */
class SourceFields
{
public:
  explicit SourceFields(const std::vector<EscapeRays::Source>& sources)
  {
    for (const EscapeRays::Source& source : sources)
    {
      this->Count += source.NetFlux ? 2 : 1;
    }
    const std::size_t cells = sources.empty() ? 0 : sources.front().Fluence->size();
    this->Values.resize(cells * this->Count);
    std::size_t position = 0;
    for (const EscapeRays::Source& source : sources)
    {
      this->Set(position++, *source.Fluence);
      if (source.NetFlux)
      {
        this->Set(position++, *source.NetFlux);
      }
    }
  }

  std::size_t GetCount() const { return this->Count; }
  /// Returns a pointer to the fields of a cell.
  const glm::vec4* Get(std::size_t cell) const { return this->Values.data() + cell * this->Count; }

private:
  void Set(std::size_t position, const std::vector<glm::vec3>& values)
  {
    for (std::size_t cell = 0; cell < values.size(); ++cell)
    {
      this->Values[cell * this->Count + position] = glm::vec4(values[cell], 0.0f);
    }
  }

  std::size_t Count = 0;
  std::vector<glm::vec4> Values;
};

class DirectionTrace
{
public:
  DirectionTrace(const SanitizedMedium& medium, const MeanPhase& phase,
    const std::vector<EscapeRays::Source>& sources, const SourceFields& fields,
    const Ordinate& ordinate, bool isBack)
    : Cells(medium)
    , Phase(phase)
    , Sources(sources)
    , Fields(fields)
    , Out(ordinate.Out)
    , Weight(ordinate.Weight)
    , Offset(ordinate.Offset)
    , IsBack(isBack)
    , Seen(fields.GetCount())
  {
    this->Result.resize(sources.size());
    for (const EscapeRays::Source& source : sources)
    {
      const bool isDirectional = source.Light && !source.Light->IsPositional;
      this->Factors.push_back(isDirectional ? this->GetPhase(*source.Light, {}, this->Out) : 0.0);
    }
  }

  /// Returns the sum of the optical depths that the rays sample, weighted by area.
  double GetSampledDepth() const { return this->SampledDepth; }

  std::vector<EscapeRays::Sums> Trace()
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
      const int rows = std::min(box.Cells[v], MaximumRays);
      const int columns = std::min(box.Cells[u], MaximumRays);
      const double area = box.CellSize[u] * box.Cells[u] / columns * box.CellSize[v] *
        box.Cells[v] / rows * std::abs(this->Out[axis]) * this->Weight;
      glm::dvec3 start(0.0);
      start[axis] = this->Out[axis] > 0.0 ? box.Cells[axis] : 0.0;
      for (int row = 0; row < rows; ++row)
      {
        start[v] = (row + this->Offset.y) * box.Cells[v] / rows;
        for (int column = 0; column < columns; ++column)
        {
          start[u] = (column + this->Offset.x) * box.Cells[u] / columns;
          this->Follow(CellRay(box, start, -this->Out), area);
        }
      }
    }
    return this->Result;
  }

private:
  /// Follows a ray against the direction of light, from where light leaves the box to where it
  /// enters.
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
        // A blocked cell absorbs all light that comes from behind it.
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
        // Compute depth - (1 - left) without cancellation for small depths.
        const double left = std::exp(-depth);
        const double ended = depth < 1e-2
          ? depth * depth * (0.5 - depth * (1.0 / 6.0 - depth / 24.0))
          : depth - 1.0 + left;
        const double own = depth - ended;
        this->SampledDepth += area * depth;
        // Sample at the mean visible position of the segment, as slices do.
        const double part = depth < 0.05 ? 0.5 - depth / 12.0 : 1.0 / depth - left / own;
        this->FindSeen(ray.GetPosition(ray.GetEntry() + part * length), cell);
        const double recaptured = area * (depth * lost + through * ended);
        const double out = area * through * own;
        const glm::vec4* seen = this->Seen.data();
        for (std::size_t i = 0; i < this->Sources.size(); ++i)
        {
          const glm::dvec3 color = this->GetColor(i, ray, cell, seen);
          EscapeRays::Sums& sums = this->Result[i];
          sums.Recaptured += recaptured * color;
          (isBlocked ? sums.Blocked : (this->IsBack ? sums.Backward : sums.Forward)) += out * color;
        }
        lost += through * own;
        through *= 1.0 - own;
      }
    } while (ray.Advance());
  }

  /// Samples all fields at a position inside \a cell or on its boundary. Blocked cells have no
  /// values, so the values of \a cell are used instead.
  void FindSeen(const glm::dvec3& position, std::size_t cell)
  {
    const ScatteringMedium& box = this->Cells.Box;
    const glm::dvec3 at = glm::clamp(position - 0.5, glm::dvec3(0.0), glm::dvec3(box.Cells - 1));
    const glm::ivec3 lower(at);
    const glm::vec3 fraction(at - glm::dvec3(lower));
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
      const float weight = (isX ? fraction.x : 1.0f - fraction.x) *
        (isY ? fraction.y : 1.0f - fraction.y) * (isZ ? fraction.z : 1.0f - fraction.z);
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
    const glm::dvec3 center = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
    return this->Phase.Get(glm::dot(light.GetDirection(center), out));
  }

  /// Returns the light that a source emits toward the start of the ray. Advances \a seen to the
  /// fields of the next source.
  glm::vec3 GetColor(
    std::size_t number, const CellRay& ray, std::size_t cell, const glm::vec4*& seen) const
  {
    const EscapeRays::Source& source = this->Sources[number];
    const glm::vec3 fluence(*seen++);
    double factor = 1.0;
    if (source.Light)
    {
      // The cached factor does not apply if mirrors have reflected the ray.
      const bool isSame = !source.Light->IsPositional && ray.GetDirection() == -this->Out;
      factor = isSame ? this->Factors[number]
                      : this->GetPhase(*source.Light, ray.GetCell(), -ray.GetDirection());
    }
    else if (source.NetFlux)
    {
      const glm::dvec3 netFlux(*seen++);
      factor = std::max(1.0 - source.NetFluxFactor * glm::dot(netFlux, ray.GetDirection()), 0.0);
    }
    return static_cast<float>(factor) * fluence * this->Cells.Albedo[cell];
  }

  const SanitizedMedium& Cells;
  const MeanPhase& Phase;
  const std::vector<EscapeRays::Source>& Sources;
  const SourceFields& Fields;
  glm::dvec3 Out;
  double Weight;
  glm::dvec2 Offset;
  bool IsBack;
  /// For each source with a directional light, the relative phase function toward Out.
  std::vector<double> Factors;
  /// The fields sampled at the current position.
  std::vector<glm::vec4> Seen;
  std::vector<EscapeRays::Sums> Result;
  double SampledDepth = 0.0;
};

}

void EscapeRays::Sums::Add(const Sums& other)
{
  this->Recaptured += other.Recaptured;
  this->Backward += other.Backward;
  this->Forward += other.Forward;
  this->Blocked += other.Blocked;
}

void EscapeRays::Sums::Scale(const glm::dvec3& factor)
{
  for (glm::dvec3* part : { &this->Recaptured, &this->Backward, &this->Forward, &this->Blocked })
  {
    *part *= factor;
  }
}

void EscapeRays::Sums::ScaleTo(const glm::dvec3& sent)
{
  const glm::dvec3 found = this->Recaptured + this->GetEscaped();
  glm::dvec3 factor(1.0);
  for (int color = 0; color < 3; ++color)
  {
    factor[color] = found[color] > 0.0 ? sent[color] / found[color] : 1.0;
    // No ray enters a box with mirrors on all faces, so all light is recaptured.
    this->Recaptured[color] = found[color] > 0.0 ? this->Recaptured[color] : sent[color];
  }
  this->Scale(factor);
}

void EscapeRays::Sums::CorrectOpticalDepth(double medium)
{
  const glm::dvec3 out = this->GetEscaped();
  glm::dvec3 factor(1.0);
  for (int color = 0; color < 3; ++color)
  {
    const double found = this->Recaptured[color] + out[color];
    factor[color] += found > 0.0 ? out[color] / found * (medium - 1.0) : 0.0;
  }
  this->Scale(factor);
}

std::vector<EscapeRays::Sums> EscapeRays::Trace(const SanitizedMedium& medium,
  const PhaseFunction& phase, const std::vector<Source>& sources, const glm::dvec3& direction)
{
  const std::vector<Ordinate> ordinates = MakeOrdinates();
  const MeanPhase meanPhase(phase, ordinates.size());
  const SourceFields cellFields(sources);
  std::vector<std::vector<Sums>> parts(ordinates.size());
  std::vector<double> sampledDepths(ordinates.size(), 0.0);
  ParallelFor(0, static_cast<vtkIdType>(ordinates.size()), 1,
    [&](vtkIdType i)
    {
      const std::size_t at = static_cast<std::size_t>(i);
      const bool isBack = glm::dot(ordinates[at].Out, direction) < 0.0;
      DirectionTrace trace(medium, meanPhase, sources, cellFields, ordinates[at], isBack);
      parts[at] = trace.Trace();
      sampledDepths[at] = trace.GetSampledDepth();
    });
  double present = 0.0;
  for (const float extinction : medium.Extinction)
  {
    present += medium.CellVolume * extinction;
  }
  const double found = std::accumulate(sampledDepths.begin(), sampledDepths.end(), 0.0);
  std::vector<Sums> sums(sources.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    for (const std::vector<Sums>& part : parts)
    {
      sums[i].Add(part[i]);
    }
    // Correct two errors: the rays sample slightly more or less optical depth than the medium has,
    // and there are too few directions to sample a narrow phase function accurately.
    glm::dvec3 sent(0.0);
    for (std::size_t cell = 0; cell < medium.Extinction.size(); ++cell)
    {
      sent += medium.CellVolume * medium.Extinction[cell] *
        glm::dvec3((*sources[i].Fluence)[cell] * medium.Albedo[cell]);
    }
    if (sources[i].Light)
    {
      sums[i].ScaleTo(sent);
    }
    else
    {
      sums[i].CorrectOpticalDepth(found > 0.0 ? present / found : 1.0);
    }
  }
  return sums;
}

}
