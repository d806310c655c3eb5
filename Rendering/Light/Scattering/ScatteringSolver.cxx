// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringSolver.h"

#include "Common/Vectors.h"
#include "Scattering/DiffuseLight.h"
#include "Scattering/EscapeRays.h"
#include "Scattering/ForwardLight.h"
#include "Scattering/LightSlopes.h"
#include "Scattering/MatterCells.h"
#include "Scattering/OrdinateSweep.h"
#include "Scattering/SingleEscape.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

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
    this->GoForward(this->Phase.ForwardShare(), variance);
    const std::vector<EscapeRays::Sums> sums = this->TraceLights({});
    const glm::dvec3 left = this->LimitForward(sums, 1.0);
    this->Report.Dropped = MeanOf(left);
    this->ReportLights(sums);
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
    this->Slopes = LightSlopes::Find(this->Matter, input.Lights);
    input.Slopes = this->Slopes;
    DiffuseLight::Output diffuse = DiffuseLight::Solve(this->Matter, input);
    this->Report.Cycles = diffuse.Cycles;
    this->Report.Residual = diffuse.Residual;
    OrdinateSweep::Improve(this->Matter, input, diffuse);
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
    this->Slopes = LightSlopes::Find(this->Matter, this->Matter.Direct);
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
        }
      });
    for (const int count : layers)
    {
      this->Report.Layers += count;
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

  /// Returns the direction of all lights together, but along mirrors, of which light leaves no
  /// side.
  glm::dvec3 GetMainDirection() const
  {
    const ScatteringMedium& box = this->Matter.Box;
    const glm::dvec3 middle = box.Origin + 0.5 * glm::dvec3(box.Cells) * box.CellSize;
    glm::dvec3 direction(0.0);
    for (std::size_t light = 0; light < this->Matter.Lights.size(); ++light)
    {
      direction += MeanOf(this->SumTaken(light)) * this->Matter.Lights[light].GetDirection(middle);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = box.Mirrors[axis] ? 0.0 : direction[axis];
    }
    return direction;
  }

  /// Traces what is scattered once of each light, then its forward light, then \a others.
  std::vector<EscapeRays::Sums> TraceLights(const std::vector<EscapeRays::Source>& others) const
  {
    const glm::dvec3 direction = this->GetMainDirection();
    const SingleEscape single(this->Phase);
    std::vector<EscapeRays::Sums> sums;
    for (std::size_t i = 0; i < this->Matter.Lights.size(); ++i)
    {
      sums.push_back(single.Find(this->Matter, i, direction));
    }
    std::vector<EscapeRays::Source> sources;
    for (std::size_t i = 0; i < this->Field.Forward.size(); ++i)
    {
      sources.emplace_back();
      sources.back().Fluence = &this->Field.Forward[i];
      sources.back().Light = &this->Matter.Lights[i];
    }
    sources.insert(sources.end(), others.begin(), others.end());
    const std::vector<EscapeRays::Sums> fields =
      EscapeRays::Trace(this->Matter, this->Phase, sources, direction);
    sums.insert(sums.end(), fields.begin(), fields.end());
    return sums;
  }

  /**
   * Scales the forward light of each light so that no more of it meets matter than \a share of
   * what meets matter again of what is scattered. Returns what else meets matter again. The forward
   * light is taken to go on as the light does, which brings it deeper than the phase function's
   * angles do where a light grazes.
   */
  glm::dvec3 LimitForward(std::vector<EscapeRays::Sums> const& sums, double share)
  {
    const std::size_t lights = this->Matter.Lights.size();
    this->ForwardScale.assign(this->Field.Forward.size(), glm::dvec3(1.0));
    glm::dvec3 left(0.0);
    for (std::size_t light = 0; light < lights; ++light)
    {
      left += sums[light].Kept;
      if (this->Field.Forward.empty())
      {
        continue;
      }
      std::vector<glm::vec3>& forward = this->Field.Forward[light];
      // What is absorbed of it and what leaves.
      const glm::dvec3 needed =
        this->SumCells([&](std::size_t i)
          { return (1.0 - glm::dvec3(this->Matter.Albedo[i])) * glm::dvec3(forward[i]); }) +
        sums[lights + light].GetOut();
      glm::dvec3& scale = this->ForwardScale[light];
      for (int color = 0; color < 3; ++color)
      {
        const double most = share * sums[light].Kept[color];
        scale[color] = needed[color] > most ? most / needed[color] : 1.0;
      }
      left -= scale * needed;
      for (glm::vec3& value : forward)
      {
        value *= glm::vec3(scale);
      }
    }
    return glm::max(left, 0.0);
  }

  /// Adds what is absorbed and seen of the lights and their forward light.
  void ReportLights(const std::vector<EscapeRays::Sums>& sums)
  {
    const std::size_t lights = this->Matter.Lights.size();
    this->Report.Absorbed += MeanOf(this->SumAbsorbed());
    for (std::size_t i = 0; i < lights + this->ForwardScale.size(); ++i)
    {
      this->ReportOut(sums[i], i < lights ? glm::dvec3(1.0) : this->ForwardScale[i - lights]);
    }
  }

  void ReportOut(const EscapeRays::Sums& sums, const glm::dvec3& scale)
  {
    this->Report.Absorbed += MeanOf(scale * sums.Blocked);
    this->Report.Reflected += MeanOf(scale * sums.Back);
    this->Report.Transmitted += MeanOf(scale * sums.On);
  }

  /**
   * Scales the fluence so that what leaves the medium and what it absorbs are what it takes from
   * the lights. What leaves is what eyes around the box see; with K what meets matter again of what
   * the lights and the forward light are scattered to,
   *
   *   K - (what meets matter of the forward light) = factor (out(fluence) + absorbed(fluence)).
   */
  void Balance(const DiffuseLight::Input& input, DiffuseLight::Output& diffuse)
  {
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
    this->LimitFluence(diffuse.Fluence);
    const std::vector<EscapeRays::Sums> sums = this->TraceLights({ this->GetSource(diffuse) });
    const glm::dvec3 kept = this->LimitForward(sums, MostForward);
    this->ReportLights(sums);
    const glm::dvec3 absorbed = this->SumCells([&](std::size_t i)
      { return (1.0 - glm::dvec3(this->Matter.Albedo[i])) * glm::dvec3(diffuse.Mean[i]); });
    glm::dvec3 dropped(0.0);
    for (std::size_t i = 0; i < diffuse.Drop.size(); ++i)
    {
      dropped += this->Matter.CellVolume * diffuse.Drop[i] * glm::dvec3(diffuse.Mean[i]);
    }
    glm::dvec3 factor(0.0);
    const glm::dvec3 gone = sums.back().GetOut() + absorbed + dropped;
    for (int color = 0; color < 3; ++color)
    {
      factor[color] = gone[color] > 0.0 ? kept[color] / gone[color] : 0.0;
    }
    for (glm::vec3& fluence : diffuse.Fluence)
    {
      fluence *= glm::vec3(factor);
    }
    this->Report.Absorbed += MeanOf(factor * absorbed);
    if (!this->LimitFluence(diffuse.Fluence))
    {
      this->Report.Dropped += MeanOf(factor * dropped);
      this->ReportOut(sums.back(), factor);
      return;
    }
    // What is beyond the limit is seen by nobody.
    const EscapeRays::Sums out = EscapeRays::Trace(
      this->Matter, this->Phase, { this->GetSource(diffuse) }, this->GetMainDirection())
                                   .front();
    this->ReportOut(out, glm::dvec3(1.0));
    this->Report.Dropped += MeanOf(kept - factor * absorbed - out.GetOut());
  }

  EscapeRays::Source GetSource(const DiffuseLight::Output& diffuse) const
  {
    EscapeRays::Source source;
    source.Fluence = &diffuse.Fluence;
    source.Lean = &diffuse.Lean;
    source.LeanFactor = 3.0 * this->Phase.Moment(1);
    return source;
  }

  /**
   * Limits the fluence to what a half space that absorbs nothing has at most, so many times the
   * light that comes in: deep in it sqrt(3) H(1), and where eyes see it H(1)^2 / 2 - 1 / 2, of
   * which the last is scattered once. Returns whether there was more. Between mirrors there is no
   * such limit.
   */
  bool LimitFluence(std::vector<glm::vec3>& fluence) const
  {
    if (glm::any(this->Matter.Box.Mirrors))
    {
      return false;
    }
    constexpr float deep = 5.0364f;
    constexpr float seen = 3.7277f;
    const glm::vec3 light = this->FindIncoming();
    const double size = Vectors::InfinityNorm(this->Matter.Box.CellSize);
    bool isLimited = false;
    for (std::size_t i = 0; i < fluence.size(); ++i)
    {
      const float thin = static_cast<float>(std::exp(-this->Matter.Extinction[i] * size));
      const glm::vec3 most = (seen + thin * (deep - seen)) * light;
      isLimited = isLimited || glm::any(glm::greaterThan(fluence[i], most));
      fluence[i] = glm::min(fluence[i], most);
    }
    return isLimited;
  }

  /// Returns the sum over all lights of the brightest light that enters a cell.
  glm::vec3 FindIncoming() const
  {
    const ScatteringMedium& box = this->Matter.Box;
    glm::vec3 sum(0.0f);
    for (std::size_t light = 0; light < this->Matter.Lights.size(); ++light)
    {
      glm::vec3 most(0.0f);
      for (std::size_t i = 0; i < this->Matter.Extinction.size(); ++i)
      {
        const int number = static_cast<int>(i);
        const glm::dvec3 cell(number % box.Cells.x, number / box.Cells.x % box.Cells.y,
          number / (box.Cells.x * box.Cells.y));
        const glm::dvec3 way =
          this->Matter.Lights[light].GetDirection(box.Origin + (cell + 0.5) * box.CellSize);
        // A light that shines on three sides of a cell goes so far through it on the average.
        const glm::dvec3 speed = glm::abs(way) / box.CellSize;
        const double depth =
          this->Matter.Extinction[i] / std::max(speed.x + speed.y + speed.z, 1e-300);
        most = glm::max(most,
          this->Matter.Direct[light][i] *
            static_cast<float>(depth > 1e-6 ? depth / -std::expm1(-depth) : 1.0));
      }
      sum += most;
    }
    return sum;
  }

  /// The most that the forward light of mode FULL takes of what meets matter again of a light.
  static constexpr double MostForward = 0.75;

  MatterCells Matter;
  PhaseFunction Phase;
  /// Those of LightSlopes.
  std::vector<glm::vec3> Slopes;
  /// The factors of forward lights that LimitForward has found.
  std::vector<glm::dvec3> ForwardScale;
  const ScatteringSettings& Settings;
  ScatteringField& Field;
  ScatteringReport& Report;
};

}

Error ScatteringSolver::Solve(const ScatteringMedium& medium,
  const std::vector<ScatteringLight>& lights, ScatteringMode mode,
  const ScatteringSettings& settings, ScatteringField& field, ScatteringReport& report)
{
  field = ScatteringField();
  report = ScatteringReport();
  Error error = medium.Check();
  for (const ScatteringLight& light : lights)
  {
    error = error ? error : light.Check(medium.GetNumberOfCells());
  }
  if (error)
  {
    return error;
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
