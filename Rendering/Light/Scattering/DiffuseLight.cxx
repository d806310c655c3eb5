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

private:
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
    double own = this->Source[at] * this->Matter.CellVolume;
    if (!(own > 0.0))
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double offset = LightSlopes::GetOffset(this->Input.Slopes[at][axis]);
      std::size_t other = at;
      const SideKind kind = this->GetSide(cell, axis, offset < 0.0 ? -1 : 1, other);
      const double distance = std::abs(offset);
      if (kind == SideKind::Inner)
      {
        const double share = this->GetShare(at, axis, distance, this->GetConductance(other, axis));
        this->Right[other] += share * own;
        own *= 1.0 - share;
      }
      else if (kind == SideKind::Open)
      {
        own *= 1.0 - this->GetShare(at, axis, distance, Outflow);
      }
    }
    this->Right[at] += own;
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
  double Thin = 1.0;
  double Total = 0.0;
};

}

DiffuseLight::Output DiffuseLight::Solve(const MatterCells& matter, const Input& input)
{
  const std::size_t cells = matter.Extinction.size();
  Output output;
  output.Fluence.assign(cells, glm::vec3(0.0f));
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
          output.Fluence[at][color] = static_cast<float>(std::max(fluence[at], 0.0));
          if (!matter.Box.IsBlocked(at))
          {
            flux[at] += equations.back().GetFlux(cell, fluence);
          }
        }
      }
    }
  }
  for (std::size_t at = 0; at < cells; ++at)
  {
    const glm::vec3& color = output.Fluence[at];
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
