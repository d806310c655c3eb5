// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/DiffuseLight.h"

#include "Scattering/DiffusionGrid.h"
#include "Scattering/LightSlopes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace interlume
{

namespace
{

/// Ratio of a cell's transport extinction to the medium's extinction-weighted mean, below which
/// light escapes freely from the cell.
constexpr double ThinFraction = 0.2;
/// Ratio of outward flux to fluence at an open boundary.
constexpr double Outflow = 0.5;
/// Optical depth below the surface of a thick medium at which the fluence equals the fluence seen
/// from outside, which is four times the outward flux.
constexpr double SeenDepth = 2.0 / 3.0;

/// Diffusion equations of one color channel.
class ColorEquations
{
public:
  ColorEquations(const SanitizedMedium& medium, const DiffuseLight::Input& input, int color)
    : Medium(medium)
    , Input(input)
    , Color(color)
    , Grid(medium.Box.Cells)
    , Source(medium.Extinction.size(), 0.0)
    , Current(medium.Extinction.size(), glm::dvec3(0.0))
    , Extinction(medium.Extinction.size(), 0.0)
    , RightSide(medium.Extinction.size(), 0.0)
    , Transferred(medium.Extinction.size(), glm::dvec3(0.0))
  {
    this->FindSources();
  }

  bool HasSameEquations(const ColorEquations& other) const
  {
    return this->Extinction == other.Extinction && this->Source == other.Source &&
      this->Current == other.Current &&
      std::all_of(this->Medium.Albedo.begin(), this->Medium.Albedo.end(),
        [&](const glm::vec3& albedo) { return albedo[this->Color] == albedo[other.Color]; });
  }
  double GetTotal() const { return this->Total; }

  double Solve(std::vector<double>& fluence, std::vector<float>& drop, int& cycles)
  {
    this->FindEquations(drop);
    this->Grid.Prepare();
    return this->Grid.Solve(
      this->RightSide, fluence, this->Input.Tolerance, this->Input.MaximumCycles, cycles);
  }

  /// Returns the net flux in a cell, averaged over its two faces along each axis.
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
   * Returns the fluence of a cell as seen from outside. For a thin cell, this is the fluence at its
   * center. A camera sees only about one mean free path deep into a thick cell, so its fluence is
   * computed from the flux through the faces toward thinner cells.
   */
  double GetSeen(const glm::ivec3& cell, const std::vector<double>& fluence) const
  {
    const ScatteringMedium& box = this->Medium.Box;
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
          const double area = this->Medium.CellVolume / box.CellSize[axis];
          const double transferred = side * this->Transferred[at][axis];
          const double flux = this->GetOutflow(cell, axis, side, fluence) +
            std::max(transferred, 0.0) / area - this->GetSingle(at, axis, side);
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
    const double albedo = std::max<double>(this->Medium.Albedo[at][this->Color], 0.01);
    const double fraction = std::min(open, 1.0);
    return (1.0 - fraction) * fluence[at] + fraction * 4.0 * sum / (weights * albedo);
  }

private:
  /// Returns the fraction of the light through a cell face that escapes.
  double GetOpenness(const glm::ivec3& cell, int axis, int side) const
  {
    std::size_t other = this->Medium.Box.GetIndex(cell);
    const SideKind kind = this->GetSide(cell, axis, side, other);
    if (kind == SideKind::Inner)
    {
      return std::exp(-2.0 * this->Extinction[other] * this->Medium.Box.CellSize[axis]);
    }
    return kind == SideKind::Open && !this->Medium.Box.IsBlocked(other) ? 1.0 : 0.0;
  }

  /// Returns the flux of singly scattered light through a face of a thick cell. GetSeen subtracts
  /// it, since single scattering is rendered separately. If the light decreases as exp(-k depth)
  /// from the face, the flux is the fraction (1 - log(1 + k) / k) / 2 of the source.
  double GetSingle(std::size_t at, int axis, int side) const
  {
    const double size = this->Medium.Box.CellSize[axis];
    const double depth = this->Extinction[at] * size;
    const double falls = std::max(-side * this->Input.Slopes[at][axis] / depth, 1.0 / depth);
    return this->Source[at] * size * 0.5 * (1.0 - std::log1p(falls) / falls);
  }

  void FindSources()
  {
    const ScatteringMedium& box = this->Medium.Box;
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
          const double extinction = this->Medium.Extinction[index];
          if (!(extinction > 0.0))
          {
            continue;
          }
          const double albedo = this->Medium.Albedo[index][this->Color];
          const double transport = extinction * (1.0 - albedo * g);
          this->Extinction[index] = transport;
          sum += transport;
          squares += transport * transport;
          const glm::dvec3 center = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
          for (std::size_t light = 0; light < this->Input.Lights.size(); ++light)
          {
            const double scattered =
              extinction * albedo * this->Input.Lights[light][index][this->Color];
            this->Source[index] += scattered * (1.0 - f);
            this->Current[index] +=
              scattered * (g - f) * this->Medium.Lights[light].GetDirection(center);
          }
          this->Total += this->Source[index];
        }
      }
    }
    // In any medium, the bound is low enough that light does not escape freely from a cell whose
    // optical depth along its longest edge is above 0.5.
    const glm::dvec3& size = box.CellSize;
    this->MinimumExtinction = std::min(
      sum > 0.0 ? ThinFraction * squares / sum : 1.0, 0.5 / std::max({ size.x, size.y, size.z }));
  }

  /// Returns the fraction of a cell's source that leaves through a face. \a distance is the
  /// distance of the source from the cell center toward the face, in cells. \a beyond is the
  /// conductance on the face's far side.
  double GetOutwardFraction(std::size_t at, int axis, double distance, double beyond) const
  {
    const double own = 0.5 * this->GetConductance(at, axis);
    const double inwards = own / std::max(distance, 1e-12);
    const double outwards = 1.0 / (1.0 / beyond + (0.5 - distance) / own);
    return outwards / (inwards + outwards);
  }

  /// Distributes a cell's source to the cell and its neighbors so that the position of the source
  /// is preserved. The part that an open face transmits leaves the medium.
  void AddSource(const glm::ivec3& cell, std::size_t at)
  {
    const double own = this->Source[at] * this->Medium.CellVolume;
    if (!(own > 0.0))
    {
      return;
    }
    glm::dvec3 boundaryFractions(0.0);
    glm::dvec3 offset(0.0);
    double retained = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      offset[axis] = LightSlopes::GetOffset(this->Input.Slopes[at][axis]);
      std::size_t other = at;
      const SideKind kind = this->GetSide(cell, axis, offset[axis] < 0.0 ? -1 : 1, other);
      if (kind != SideKind::Mirror)
      {
        boundaryFractions[axis] = this->GetOutwardFraction(at, axis, std::abs(offset[axis]),
          kind == SideKind::Open ? Outflow : this->GetConductance(other, axis));
        retained *= 1.0 - boundaryFractions[axis];
      }
    }
    this->RightSide[at] += retained * own;
    const double sum = boundaryFractions.x + boundaryFractions.y + boundaryFractions.z;
    for (int axis = 0; axis < 3 && sum > 0.0; ++axis)
    {
      const int side = offset[axis] < 0.0 ? -1 : 1;
      const double transferred = own * (1.0 - retained) * boundaryFractions[axis] / sum;
      this->Transferred[at][axis] = side * transferred;
      std::size_t other = at;
      if (this->GetSide(cell, axis, side, other) == SideKind::Inner)
      {
        this->RightSide[other] += transferred;
      }
    }
  }

  double GetExtinction(std::size_t cell) const
  {
    return std::max(this->Extinction[cell], this->MinimumExtinction);
  }

  /// Type of a cell face: a face to a neighbor cell, a mirror, or an open boundary.
  enum class SideKind
  {
    Inner,
    Mirror,
    Open
  };
  SideKind GetSide(const glm::ivec3& cell, int axis, int side, std::size_t& neighbor) const
  {
    const ScatteringMedium& box = this->Medium.Box;
    glm::ivec3 other = cell;
    other[axis] += side;
    if (other[axis] < 0 || other[axis] >= box.Cells[axis])
    {
      return box.Mirrors[axis] ? SideKind::Mirror : SideKind::Open;
    }
    neighbor = box.GetIndex(other);
    return box.IsBlocked(neighbor) ? SideKind::Open : SideKind::Inner;
  }

  /// Returns the conductance between a cell center and a face: the diffusion coefficient, which is
  /// 1 / (3 extinction), divided by the distance.
  double GetConductance(std::size_t cell, int axis) const
  {
    return 2.0 / (3.0 * this->GetExtinction(cell) * this->Medium.Box.CellSize[axis]);
  }

  /// Returns the outward flux through a cell face.
  double GetOutflow(
    const glm::ivec3& cell, int axis, int side, const std::vector<double>& fluence) const
  {
    const std::size_t at = this->Medium.Box.GetIndex(cell);
    std::size_t other = at;
    switch (this->GetSide(cell, axis, side, other))
    {
      case SideKind::Inner:
      {
        const double extinction = this->GetExtinction(at) + this->GetExtinction(other);
        return 2.0 * (fluence[at] - fluence[other]) /
          (3.0 * extinction * this->Medium.Box.CellSize[axis]) +
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
    const ScatteringMedium& box = this->Medium.Box;
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
          const double volume = this->Medium.CellVolume;
          const double extinction = this->GetExtinction(at);
          const double albedo = this->Medium.Albedo[at][this->Color];
          // With this sink, the flux from adjacent thicker cells is Outflow times the fluence,
          // since the product of the sink and the diffusion coefficient is Outflow^2.
          const double escape = 3.0 * Outflow * Outflow * (extinction - this->Extinction[at]);
          double absorbed = this->Medium.Extinction[at] * (1.0 - albedo) + escape;
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
    // Without any sink, the equations are singular. This sink is too weak to be visible.
    for (std::size_t i = 0; i < sink.size(); ++i)
    {
      sink[i] += box.IsBlocked(i)
        ? 0.0
        : 1e-10 * this->Medium.CellVolume * std::min(this->GetExtinction(i), 1.0 / box.CellSize.x);
    }
  }

  void AddSides(const glm::ivec3& cell, std::size_t at, int axis)
  {
    const ScatteringMedium& box = this->Medium.Box;
    const double area = this->Medium.CellVolume / box.CellSize[axis];
    for (const int side : { -1, 1 })
    {
      std::size_t other = at;
      const SideKind kind = this->GetSide(cell, axis, side, other);
      if (kind == SideKind::Open)
      {
        const double conductance = this->GetConductance(at, axis);
        const double current = side * this->Current[at][axis] / this->GetExtinction(at);
        const double fraction = Outflow / (conductance + Outflow);
        this->Grid.GetSink()[at] += area * fraction * conductance;
        this->RightSide[at] -= area * fraction * current;
      }
      else if (kind == SideKind::Inner && side == 1)
      {
        const double extinction = this->GetExtinction(at) + this->GetExtinction(other);
        this->Grid.GetCouplings()[static_cast<std::size_t>(axis)][at] =
          2.0 * area / (3.0 * extinction * box.CellSize[axis]);
        const double current =
          area * (this->Current[at][axis] + this->Current[other][axis]) / extinction;
        this->RightSide[at] -= current;
        this->RightSide[other] += current;
      }
    }
  }

  const SanitizedMedium& Medium;
  const DiffuseLight::Input& Input;
  int Color;
  DiffusionGrid Grid;
  std::vector<double> Source;
  std::vector<glm::dvec3> Current;
  /// Transport extinction e (1 - a g).
  std::vector<double> Extinction;
  std::vector<double> RightSide;
  /// Part of each cell's source that AddSource moves through a face along each axis. It is negative
  /// if the face is the lower one.
  std::vector<glm::dvec3> Transferred;
  double MinimumExtinction = 1.0;
  double Total = 0.0;
};

}

DiffuseLight::Output DiffuseLight::Solve(const SanitizedMedium& medium, const Input& input)
{
  const std::size_t cells = medium.Extinction.size();
  Output output;
  output.Fluence.assign(cells, glm::vec3(0.0f));
  output.Mean.assign(cells, glm::vec3(0.0f));
  output.NetFlux.assign(cells, glm::vec3(0.0f));
  output.Drop.assign(input.BackwardLayers > 0 ? cells : 0, 0.0f);
  std::vector<glm::dvec3> flux(cells, glm::dvec3(0.0));
  std::vector<double> fluence(cells, 0.0);
  // The equations that \a fluence solves. A channel with the same equations uses this object
  // instead of its own, since GetSeen needs members that Solve computes.
  std::unique_ptr<ColorEquations> equations;
  for (int color = 0; color < 3; ++color)
  {
    auto own = std::make_unique<ColorEquations>(medium, input, color);
    if (!equations || !own->HasSameEquations(*equations))
    {
      // If the channels differ only by a factor, the scaled solution of the previous channel is a
      // good initial guess.
      const double factor =
        equations && equations->GetTotal() > 0.0 ? own->GetTotal() / equations->GetTotal() : 0.0;
      for (double& value : fluence)
      {
        value *= factor;
      }
      equations = std::move(own);
      int cycles = 0;
      output.Residual = std::max(output.Residual, equations->Solve(fluence, output.Drop, cycles));
      output.Cycles += cycles;
    }
    glm::ivec3 cell(0);
    std::size_t at = 0;
    for (cell.z = 0; cell.z < medium.Box.Cells.z; ++cell.z)
    {
      for (cell.y = 0; cell.y < medium.Box.Cells.y; ++cell.y)
      {
        for (cell.x = 0; cell.x < medium.Box.Cells.x; ++cell.x, ++at)
        {
          output.Mean[at][color] = static_cast<float>(std::max(fluence[at], 0.0));
          if (!medium.Box.IsBlocked(at))
          {
            output.Fluence[at][color] =
              static_cast<float>(std::max(equations->GetSeen(cell, fluence), 0.0));
            flux[at] += equations->GetFlux(cell, fluence);
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
      const glm::dvec3 netFlux = flux[at] / sum;
      output.NetFlux[at] = glm::vec3(netFlux / std::max(1.0, 3.0 * glm::length(netFlux)));
    }
  }
  return output;
}

}
