// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/DiffuseLight.h"

#include "Scattering/DiffusionGrid.h"
#include "Scattering/LightSlopes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{

/// The extinction below which a cell counts as space that light leaves by, over the mean of the
/// extinction that light meets.
constexpr double ThinShare = 0.2;
/// The flux out of a medium over its fluence, where no light comes back.
constexpr double Outflow = 0.5;
/// The depth in thick matter at which the fluence is what eyes see on the whole: there the flux is
/// a quarter of it.
constexpr double SeenDepth = 2.0 / 3.0;

/// The equations of one color.
class ColorEquations
{
public:
  ColorEquations(const MatterCells& matter, const DiffuseLight::Input& input, int color)
    : Matter(matter)
    , Input(input)
    , Color(color)
    , Grid(matter.Box.Cells)
    , Source(matter.Extinction.size(), 0.0)
    , Current(matter.Extinction.size(), glm::dvec3(0.0))
    , Extinction(matter.Extinction.size(), 0.0)
    , Right(matter.Extinction.size(), 0.0)
    , Given(matter.Extinction.size(), glm::dvec3(0.0))
  {
    this->FindSources();
  }

  bool HasSameAs(const ColorEquations& other) const
  {
    return this->Extinction == other.Extinction && this->Source == other.Source &&
      this->Current == other.Current;
  }
  double GetTotal() const { return this->Total; }

  double Solve(std::vector<double>& fluence, std::vector<float>& drop, int& cycles)
  {
    this->FindEquations(drop);
    this->Grid.Prepare();
    return this->Grid.Solve(
      this->Right, fluence, this->Input.Tolerance, this->Input.MaximumCycles, cycles);
  }

  /// Returns the net flux in a cell: the mean of that through its two sides along each axis.
  glm::dvec3 GetFlux(const glm::ivec3& cell, const std::vector<double>& fluence) const
  {
    glm::dvec3 flux(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int side : { -1, 1 })
      {
        flux[axis] += 0.5 * side * this->GetOutflow(cell, axis, side, fluence);
      }
    }
    return flux;
  }

  /**
   * Returns the fluence of a thick cell as eyes outside see it, who look no deeper into it than
   * about one free path: that which sends out through the sides to thinner cells what goes through
   * them. A thin cell has the one in its middle.
   */
  double GetSeen(const glm::ivec3& cell, const std::vector<double>& fluence) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    const std::size_t at = box.GetIndex(cell);
    double sum = 0.0;
    double weights = 0.0;
    double open = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double depth = this->Extinction[at] * box.CellSize[axis];
      const double thickness = 1.0 - SeenDepth / std::max(0.5 * depth, SeenDepth);
      for (const int side : { -1, 1 })
      {
        const double openness = thickness * this->GetOpenness(cell, axis, side);
        if (openness > 0.0)
        {
          const double area = this->Matter.CellVolume / box.CellSize[axis];
          const double given = side * this->Given[at][axis];
          const double flux = this->GetOutflow(cell, axis, side, fluence) +
            std::max(given, 0.0) / area - this->GetSingle(at, axis, side);
          sum += openness * area * std::max(flux, 0.0);
          weights += openness * area;
          open += openness;
        }
      }
    }
    if (!(weights > 0.0))
    {
      return fluence[at];
    }
    const double albedo = std::max<double>(this->Matter.Albedo[at][this->Color], 0.01);
    const double share = std::min(open, 1.0);
    return (1.0 - share) * fluence[at] + share * 4.0 * sum / (weights * albedo);
  }

private:
  /// Returns how much of the light through a side of a cell gets away from it.
  double GetOpenness(const glm::ivec3& cell, int axis, int side) const
  {
    std::size_t other = this->Matter.Box.GetIndex(cell);
    const SideKind kind = this->GetSide(cell, axis, side, other);
    if (kind == SideKind::Inner)
    {
      return std::exp(-2.0 * this->Extinction[other] * this->Matter.Box.CellSize[axis]);
    }
    return kind == SideKind::Open && !this->Matter.Box.IsBlocked(other) ? 1.0 : 0.0;
  }

  /// Returns the flux through a side of a thick cell that comes from the lights' sources at once,
  /// which eyes see apart: of light that falls by exp(-k depth), (1 - log(1 + k) / k) / 2.
  double GetSingle(std::size_t at, int axis, int side) const
  {
    const double size = this->Matter.Box.CellSize[axis];
    const double depth = this->Extinction[at] * size;
    const double falls = std::max(-side * this->Input.Slopes[at][axis] / depth, 1.0 / depth);
    return this->Source[at] * size * 0.5 * (1.0 - std::log1p(falls) / falls);
  }

  void FindSources()
  {
    const ScatteringMedium& box = this->Matter.Box;
    const double g = this->Input.Cosine;
    const double f = this->Input.Peak;
    double sum = 0.0;
    double squares = 0.0;
    glm::ivec3 cell(0);
    std::size_t index = 0;
    for (cell.z = 0; cell.z < box.Cells.z; ++cell.z)
    {
      for (cell.y = 0; cell.y < box.Cells.y; ++cell.y)
      {
        for (cell.x = 0; cell.x < box.Cells.x; ++cell.x, ++index)
        {
          const double extinction = this->Matter.Extinction[index];
          if (!(extinction > 0.0))
          {
            continue;
          }
          const double albedo = this->Matter.Albedo[index][this->Color];
          const double transport = extinction * (1.0 - albedo * g);
          this->Extinction[index] = transport;
          sum += transport;
          squares += transport * transport;
          const glm::dvec3 middle = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
          for (std::size_t light = 0; light < this->Input.Lights.size(); ++light)
          {
            const double scattered =
              extinction * albedo * this->Input.Lights[light][index][this->Color];
            this->Source[index] += scattered * (1.0 - f);
            this->Current[index] +=
              scattered * (g - f) * this->Matter.Lights[light].GetDirection(middle);
          }
          this->Total += this->Source[index];
        }
      }
    }
    // Light leaves by one cell and the next, however thick the medium is.
    const glm::dvec3& size = box.CellSize;
    this->Thin = std::min(
      sum > 0.0 ? ThinShare * squares / sum : 1.0, 0.5 / std::max({ size.x, size.y, size.z }));
  }

  /// Returns the share of a source that goes out of a cell, so far from its middle, where
  /// \a beyond conducts it there.
  double GetShare(std::size_t at, int axis, double distance, double beyond) const
  {
    const double own = 0.5 * this->GetConductance(at, axis);
    const double inwards = own / std::max(distance, 1e-12);
    const double outwards = 1.0 / (1.0 / beyond + (0.5 - distance) / own);
    return outwards / (inwards + outwards);
  }

  /// Gives the source of a cell to it and its neighbours so that its place is kept; what the nearer
  /// open side takes leaves the box.
  void AddSource(const glm::ivec3& cell, std::size_t at)
  {
    const double own = this->Source[at] * this->Matter.CellVolume;
    if (!(own > 0.0))
    {
      return;
    }
    glm::dvec3 shares(0.0);
    glm::dvec3 offset(0.0);
    double kept = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      offset[axis] = LightSlopes::GetOffset(this->Input.Slopes[at][axis]);
      std::size_t other = at;
      const SideKind kind = this->GetSide(cell, axis, offset[axis] < 0.0 ? -1 : 1, other);
      if (kind != SideKind::Mirror)
      {
        shares[axis] = this->GetShare(at, axis, std::abs(offset[axis]),
          kind == SideKind::Open ? Outflow : this->GetConductance(other, axis));
        kept *= 1.0 - shares[axis];
      }
    }
    this->Right[at] += kept * own;
    const double sum = shares.x + shares.y + shares.z;
    for (int axis = 0; axis < 3 && sum > 0.0; ++axis)
    {
      const int side = offset[axis] < 0.0 ? -1 : 1;
      const double given = own * (1.0 - kept) * shares[axis] / sum;
      this->Given[at][axis] = side * given;
      std::size_t other = at;
      if (this->GetSide(cell, axis, side, other) == SideKind::Inner)
      {
        this->Right[other] += given;
      }
    }
  }

  double GetExtinction(std::size_t cell) const
  {
    return std::max(this->Extinction[cell], this->Thin);
  }

  /// A side of a cell: that of a neighbour, of a mirror, or one that light leaves by.
  enum class SideKind
  {
    Inner,
    Mirror,
    Open
  };
  SideKind GetSide(const glm::ivec3& cell, int axis, int side, std::size_t& neighbour) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    glm::ivec3 other = cell;
    other[axis] += side;
    if (other[axis] < 0 || other[axis] >= box.Cells[axis])
    {
      return box.Mirrors[axis] ? SideKind::Mirror : SideKind::Open;
    }
    neighbour = box.GetIndex(other);
    return box.IsBlocked(neighbour) ? SideKind::Open : SideKind::Inner;
  }

  /// Returns D / size between a cell and the place at half its size from the middle.
  double GetConductance(std::size_t cell, int axis) const
  {
    return 2.0 / (3.0 * this->GetExtinction(cell) * this->Matter.Box.CellSize[axis]);
  }

  /// Returns the flux out of a cell through a side.
  double GetOutflow(
    const glm::ivec3& cell, int axis, int side, const std::vector<double>& fluence) const
  {
    const std::size_t at = this->Matter.Box.GetIndex(cell);
    std::size_t other = at;
    switch (this->GetSide(cell, axis, side, other))
    {
      case SideKind::Inner:
      {
        const double extinction = this->GetExtinction(at) + this->GetExtinction(other);
        return 2.0 * (fluence[at] - fluence[other]) /
          (3.0 * extinction * this->Matter.Box.CellSize[axis]) +
          side * (this->Current[at][axis] + this->Current[other][axis]) / extinction;
      }
      case SideKind::Open:
      {
        const double conductance = this->GetConductance(at, axis);
        const double current = side * this->Current[at][axis] / this->GetExtinction(at);
        return Outflow * (conductance * fluence[at] + current) / (conductance + Outflow);
      }
      default:
        return 0.0;
    }
  }

  void FindEquations(std::vector<float>& drop)
  {
    const ScatteringMedium& box = this->Matter.Box;
    std::vector<double>& sink = this->Grid.GetSink();
    glm::ivec3 cell(0);
    std::size_t at = 0;
    for (cell.z = 0; cell.z < box.Cells.z; ++cell.z)
    {
      for (cell.y = 0; cell.y < box.Cells.y; ++cell.y)
      {
        for (cell.x = 0; cell.x < box.Cells.x; ++cell.x, ++at)
        {
          if (box.IsBlocked(at))
          {
            continue;
          }
          const double volume = this->Matter.CellVolume;
          const double extinction = this->GetExtinction(at);
          const double albedo = this->Matter.Albedo[at][this->Color];
          // F = Outflow phi in thicker matter beside this cell: D times the sink is Outflow^2.
          const double leak = 3.0 * Outflow * Outflow * (extinction - this->Extinction[at]);
          double absorbed = this->Matter.Extinction[at] * (1.0 - albedo) + leak;
          if (this->Input.BackwardLayers > 0)
          {
            const double size = std::min({ box.CellSize.x, box.CellSize.y, box.CellSize.z }) *
              this->Input.BackwardLayers;
            drop[at] = static_cast<float>(1.0 / (3.0 * extinction * size * size));
            absorbed += drop[at];
          }
          sink[at] += absorbed * volume;
          this->AddSource(cell, at);
          for (int axis = 0; axis < 3; ++axis)
          {
            this->AddSides(cell, at, axis);
          }
        }
      }
    }
    // Without any sink the fluence has no end; this one is too weak to be seen.
    for (std::size_t i = 0; i < sink.size(); ++i)
    {
      sink[i] += box.IsBlocked(i)
        ? 0.0
        : 1e-10 * this->Matter.CellVolume * std::min(this->GetExtinction(i), 1.0 / box.CellSize.x);
    }
  }

  void AddSides(const glm::ivec3& cell, std::size_t at, int axis)
  {
    const ScatteringMedium& box = this->Matter.Box;
    const double area = this->Matter.CellVolume / box.CellSize[axis];
    for (const int side : { -1, 1 })
    {
      std::size_t other = at;
      const SideKind kind = this->GetSide(cell, axis, side, other);
      if (kind == SideKind::Open)
      {
        const double conductance = this->GetConductance(at, axis);
        const double current = side * this->Current[at][axis] / this->GetExtinction(at);
        const double share = Outflow / (conductance + Outflow);
        this->Grid.GetSink()[at] += area * share * conductance;
        this->Right[at] -= area * share * current;
      }
      else if (kind == SideKind::Inner && side == 1)
      {
        const double extinction = this->GetExtinction(at) + this->GetExtinction(other);
        this->Grid.GetCouplings()[static_cast<std::size_t>(axis)][at] =
          2.0 * area / (3.0 * extinction * box.CellSize[axis]);
        const double current =
          area * (this->Current[at][axis] + this->Current[other][axis]) / extinction;
        this->Right[at] -= current;
        this->Right[other] += current;
      }
    }
  }

  const MatterCells& Matter;
  const DiffuseLight::Input& Input;
  int Color;
  DiffusionGrid Grid;
  std::vector<double> Source;
  std::vector<glm::dvec3> Current;
  /// The transport extinction e (1 - a g).
  std::vector<double> Extinction;
  std::vector<double> Right;
  /// What sources near a side give out of their cell through it, along each axis.
  std::vector<glm::dvec3> Given;
  double Thin = 1.0;
  double Total = 0.0;
};

}

DiffuseLight::Output DiffuseLight::Solve(const MatterCells& matter, const Input& input)
{
  const std::size_t cells = matter.Extinction.size();
  Output output;
  output.Fluence.assign(cells, glm::vec3(0.0f));
  output.Mean.assign(cells, glm::vec3(0.0f));
  output.Lean.assign(cells, glm::vec3(0.0f));
  output.Drop.assign(input.BackwardLayers > 0 ? cells : 0, 0.0f);
  std::vector<glm::dvec3> flux(cells, glm::dvec3(0.0));
  std::vector<double> fluence(cells, 0.0);
  std::vector<ColorEquations> equations;
  equations.reserve(3);
  for (int color = 0; color < 3; ++color)
  {
    equations.emplace_back(matter, input, color);
    const ColorEquations* before =
      color > 0 ? &equations[static_cast<std::size_t>(color - 1)] : nullptr;
    if (!before || !equations.back().HasSameAs(*before))
    {
      // The color before is a good start where it differs by a factor.
      const double factor =
        before && before->GetTotal() > 0.0 ? equations.back().GetTotal() / before->GetTotal() : 0.0;
      for (double& value : fluence)
      {
        value *= factor;
      }
      int cycles = 0;
      output.Residual =
        std::max(output.Residual, equations.back().Solve(fluence, output.Drop, cycles));
      output.Cycles += cycles;
    }
    glm::ivec3 cell(0);
    std::size_t at = 0;
    for (cell.z = 0; cell.z < matter.Box.Cells.z; ++cell.z)
    {
      for (cell.y = 0; cell.y < matter.Box.Cells.y; ++cell.y)
      {
        for (cell.x = 0; cell.x < matter.Box.Cells.x; ++cell.x, ++at)
        {
          output.Mean[at][color] = static_cast<float>(std::max(fluence[at], 0.0));
          if (!matter.Box.IsBlocked(at))
          {
            output.Fluence[at][color] =
              static_cast<float>(std::max(equations.back().GetSeen(cell, fluence), 0.0));
            flux[at] += equations.back().GetFlux(cell, fluence);
          }
        }
      }
    }
  }
  for (std::size_t at = 0; at < cells; ++at)
  {
    const glm::vec3& color = output.Mean[at];
    const double sum = static_cast<double>(color.x) + color.y + color.z;
    if (sum > 0.0)
    {
      const glm::dvec3 lean = flux[at] / sum;
      output.Lean[at] = glm::vec3(lean / std::max(1.0, 3.0 * glm::length(lean)));
    }
  }
  return output;
}

}
