// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringSolver.h"

#include "Scattering/DiffuseLight.h"
#include "Scattering/EscapeRays.h"
#include "Scattering/ForwardLight.h"
#include "Scattering/LightSlopes.h"
#include "Scattering/MatterCells.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{

double MeanOf(const glm::dvec3& color)
{
  return (color.x + color.y + color.z) / 3.0;
}

/// One solution, from the forward light to the sums of energy.
class Solution
{
public:
  Solution(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights,
    const ScatteringSettings& settings, ScatteringField& field, ScatteringReport& report)
    : Matter(medium, lights)
    , Phase(medium.Phase)
    , Settings(settings)
    , Field(field)
    , Report(report)
  {
    this->Report.BadCells = this->Matter.BadCells;
    const std::size_t cells = this->Matter.Extinction.size();
    this->Field.Fluence.assign(cells, glm::vec3(0.0f));
    this->Field.Lean.assign(cells, glm::vec3(0.0f));
  }

  void Forward()
  {
    const double variance = this->Settings.AngleVariance >= 0.0 ? this->Settings.AngleVariance
                                                                : this->Phase.ForwardVariance();
    const double share = this->Phase.ForwardShare();
    this->GoForward(share, variance);
    glm::dvec3 scattered(0.0);
    for (std::size_t light = 0; light < this->Matter.Lights.size(); ++light)
    {
      scattered += this->SumScattered(light);
    }
    this->Report.Dropped = (1.0 - share) * MeanOf(scattered);
    this->Report.Absorbed = MeanOf(this->SumAbsorbed());
    this->Report.Transmitted =
      std::max(this->Report.Taken - this->Report.Absorbed - this->Report.Dropped, 0.0);
  }

  void Full()
  {
    const double cosine = this->Phase.Moment(1);
    const double peak = cosine > 0.0 ? std::min(std::max(this->Phase.Moment(2), 0.0), cosine) : 0.0;
    this->GoForward(peak, 0.0);
    DiffuseLight::Input input;
    input.Cosine = cosine;
    input.Peak = peak;
    input.BackwardLayers = this->Settings.BackwardLayers;
    input.Tolerance = this->Settings.Tolerance;
    input.MaximumCycles = this->Settings.MaximumCycles;
    for (std::size_t light = 0; light < this->Matter.Lights.size(); ++light)
    {
      input.Lights.push_back(this->Matter.Direct[light]);
      for (std::size_t i = 0; i < input.Lights.back().size(); ++i)
      {
        input.Lights.back()[i] +=
          this->Field.Forward.empty() ? glm::vec3(0.0f) : this->Field.Forward[light][i];
      }
    }
    input.Slopes = LightSlopes::Find(this->Matter, input.Lights);
    DiffuseLight::Output diffuse = DiffuseLight::Solve(this->Matter, input);
    this->Report.Cycles = diffuse.Cycles;
    this->Report.Residual = diffuse.Residual;
    this->Balance(input, diffuse);
    this->Field.Fluence.swap(diffuse.Fluence);
    this->Field.Lean.swap(diffuse.Lean);
  }

private:
  void GoForward(double share, double variance)
  {
    const std::size_t lights = this->Matter.Lights.size();
    for (std::size_t light = 0; light < lights; ++light)
    {
      this->Report.Taken += MeanOf(this->SumTaken(light));
    }
    if (!(share > 0.0))
    {
      return;
    }
    std::vector<int> layers(lights, 0);
    this->Field.Forward.resize(lights);
    vtkSMPTools::For(0, static_cast<vtkIdType>(lights), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const std::size_t light = static_cast<std::size_t>(i);
          this->Field.Forward[light] =
            ForwardLight::Solve(this->Matter, light, share, variance, layers[light]);
          this->LimitForward(light, share);
        }
      });
    for (const int count : layers)
    {
      this->Report.Layers += count;
    }
  }

  /// Scales the forward light where cells take more of it than is scattered into it: by rounding,
  /// and for lights at a place, whose rays come to cells unevenly.
  void LimitForward(std::size_t light, double share)
  {
    std::vector<glm::vec3>& forward = this->Field.Forward[light];
    const glm::dvec3 given = this->SumCells([&](std::size_t i)
      { return share * glm::dvec3(this->Matter.Albedo[i] * this->Matter.Direct[light][i]); });
    const glm::dvec3 taken = this->SumCells([&](std::size_t i)
      { return (1.0 - share * glm::dvec3(this->Matter.Albedo[i])) * glm::dvec3(forward[i]); });
    const glm::vec3 scale(glm::min(given / glm::max(taken, glm::dvec3(1e-300)), 1.0));
    if (scale != glm::vec3(1.0f))
    {
      for (glm::vec3& value : forward)
      {
        value *= scale;
      }
    }
  }

  template <typename Function>
  glm::dvec3 SumCells(Function&& function) const
  {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < this->Matter.Extinction.size(); ++i)
    {
      if (this->Matter.Extinction[i] > 0.0f)
      {
        sum += this->Matter.CellVolume * this->Matter.Extinction[i] * function(i);
      }
    }
    return sum;
  }

  glm::dvec3 GetLight(std::size_t light, std::size_t cell) const
  {
    return glm::dvec3(this->Matter.Direct[light][cell]) +
      (this->Field.Forward.empty() ? glm::dvec3(0.0)
                                   : glm::dvec3(this->Field.Forward[light][cell]));
  }

  glm::dvec3 SumTaken(std::size_t light) const
  {
    return this->SumCells([&](std::size_t i) { return glm::dvec3(this->Matter.Direct[light][i]); });
  }

  glm::dvec3 SumScattered(std::size_t light) const
  {
    return this->SumCells(
      [&](std::size_t i) { return glm::dvec3(this->Matter.Albedo[i]) * this->GetLight(light, i); });
  }

  /// Returns what matter absorbs of the lights and what goes on as they do.
  glm::dvec3 SumAbsorbed() const
  {
    return this->SumCells(
      [&](std::size_t i)
      {
        glm::dvec3 light(0.0);
        for (std::size_t l = 0; l < this->Matter.Lights.size(); ++l)
        {
          light += this->GetLight(l, i);
        }
        return (1.0 - glm::dvec3(this->Matter.Albedo[i])) * light;
      });
  }

  /// What the cells send out of the lights D_i, and the direction in which these go on the whole.
  EscapeRays::Source MakeLightSource(const DiffuseLight::Input& input, glm::dvec3& direction) const
  {
    const ScatteringMedium& box = this->Matter.Box;
    EscapeRays::Source source;
    source.Color.assign(this->Matter.Extinction.size(), glm::vec3(0.0f));
    source.Lean = source.Color;
    source.Slopes = input.Slopes;
    direction = glm::dvec3(0.0);
    const double slope = 3.0 * (input.Cosine - input.Peak) / (1.0 - input.Peak);
    glm::ivec3 cell(0);
    std::size_t at = 0;
    for (cell.z = 0; cell.z < box.Cells.z; ++cell.z)
    {
      for (cell.y = 0; cell.y < box.Cells.y; ++cell.y)
      {
        for (cell.x = 0; cell.x < box.Cells.x; ++cell.x, ++at)
        {
          const glm::dvec3 middle = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
          glm::dvec3 color(0.0);
          glm::dvec3 lean(0.0);
          for (std::size_t light = 0; light < input.Lights.size(); ++light)
          {
            const glm::dvec3 here = input.Lights[light][at];
            const double mean = MeanOf(here);
            if (mean > 0.0)
            {
              color += here;
              lean += mean * this->Matter.Lights[light].GetDirection(middle);
            }
          }
          direction += static_cast<double>(this->Matter.Extinction[at]) * lean;
          const double mean = MeanOf(color);
          if (mean > 0.0)
          {
            lean *= slope / mean;
            source.Color[at] =
              glm::vec3((1.0 - input.Peak) * glm::dvec3(this->Matter.Albedo[at]) * color);
            // No direction is negative.
            source.Lean[at] = glm::vec3(lean / std::max(1.0, glm::length(lean)));
          }
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = box.Mirrors[axis] ? 0.0 : direction[axis];
    }
    return source;
  }

  /**
   * Scales the fluence so that what leaves the medium and what it absorbs are what it takes from
   * the lights. What leaves is what eyes around the box see; with E what the cells send out of
   * light i without the peak, and K the part of it that meets matter again,
   *
   *   K(lights) = factor (out(fluence) + absorbed(fluence)).
   */
  void Balance(const DiffuseLight::Input& input, DiffuseLight::Output& diffuse)
  {
    glm::dvec3 direction(0.0);
    // Diffusion finds none where all the light goes on and out, by a thick cell or along a thin
    // one.
    for (std::size_t i = 0; i < diffuse.Fluence.size(); ++i)
    {
      for (const std::vector<glm::vec3>& light : input.Lights)
      {
        diffuse.Fluence[i] =
          glm::max(diffuse.Fluence[i], 1e-3f * this->Matter.Albedo[i] * light[i]);
      }
    }
    std::vector<EscapeRays::Source> sources = { this->MakeLightSource(input, direction),
      EscapeRays::Source() };
    sources[1].Color = diffuse.Fluence;
    sources[1].Lean = diffuse.Lean;
    for (std::size_t i = 0; i < diffuse.Fluence.size(); ++i)
    {
      sources[1].Color[i] *= this->Matter.Albedo[i];
      sources[1].Lean[i] *= static_cast<float>(3.0 * input.Cosine);
    }
    const std::vector<EscapeRays::Sums> sums = EscapeRays::Trace(this->Matter, sources, direction);
    const glm::dvec3 absorbed = this->SumCells([&](std::size_t i)
      { return (1.0 - glm::dvec3(this->Matter.Albedo[i])) * glm::dvec3(diffuse.Fluence[i]); });
    glm::dvec3 dropped(0.0);
    for (std::size_t i = 0; i < diffuse.Drop.size(); ++i)
    {
      dropped += this->Matter.CellVolume * diffuse.Drop[i] * glm::dvec3(diffuse.Fluence[i]);
    }
    glm::dvec3 factor(0.0);
    const glm::dvec3 gone = sums[1].GetOut() + absorbed + dropped;
    for (int color = 0; color < 3; ++color)
    {
      factor[color] = gone[color] > 0.0 ? std::max(sums[0].Kept[color] / gone[color], 0.0) : 0.0;
    }
    for (glm::vec3& fluence : diffuse.Fluence)
    {
      fluence *= glm::vec3(factor);
    }
    this->Report.Dropped = MeanOf(factor * dropped);
    this->Report.Absorbed =
      MeanOf(this->SumAbsorbed() + factor * absorbed + sums[0].Blocked + factor * sums[1].Blocked);
    this->Report.Reflected = MeanOf(sums[0].Back + factor * sums[1].Back);
    this->Report.Transmitted =
      MeanOf(sums[0].On + factor * sums[1].On) + this->GetPeakOutflow(input.Peak);
  }

  /// Returns what of the forward peak leaves the box.
  double GetPeakOutflow(double peak) const
  {
    glm::dvec3 sum(0.0);
    for (std::size_t light = 0; light < this->Field.Forward.size(); ++light)
    {
      sum += peak * this->SumScattered(light) -
        this->SumCells([&](std::size_t i) { return glm::dvec3(this->Field.Forward[light][i]); });
    }
    return std::max(MeanOf(sum), 0.0);
  }

  MatterCells Matter;
  PhaseFunction Phase;
  const ScatteringSettings& Settings;
  ScatteringField& Field;
  ScatteringReport& Report;
};

}

std::string ScatteringSolver::Solve(const ScatteringMedium& medium,
  const std::vector<ScatteringLight>& lights, ScatteringMode mode,
  const ScatteringSettings& settings, ScatteringField& field, ScatteringReport& report)
{
  field = ScatteringField();
  report = ScatteringReport();
  std::string wrong = medium.Check();
  const std::size_t cells = wrong.empty() ? medium.GetNumberOfCells() : 0;
  for (const ScatteringLight& light : lights)
  {
    wrong = wrong.empty() ? light.Check(cells) : wrong;
  }
  if (!wrong.empty())
  {
    return wrong;
  }
  Solution solution(medium, lights, settings, field, report);
  if (mode == ScatteringMode::Forward)
  {
    solution.Forward();
  }
  else
  {
    solution.Full();
  }
  return {};
}

}
