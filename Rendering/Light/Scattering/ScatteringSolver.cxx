// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringSolver.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"
#include "Scattering/DiffuseLight.h"
#include "Scattering/EscapeRays.h"
#include "Scattering/ForwardLight.h"
#include "Scattering/LightSlopes.h"
#include "Scattering/SanitizedMedium.h"
#include "Scattering/OrdinateSweep.h"
#include "Scattering/SingleScatteringEscape.h"

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

/// Computes one solution, from the forward light to the energy sums.
class Solution
{
public:
  Solution(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights,
    const ScatteringSettings& settings, ScatteredLight& field, ScatteringReport& report)
    : Medium(medium, lights)
    , Phase(medium.Phase)
    , Settings(settings)
    , Field(field)
    , Report(report)
  {
    this->Report.BadCells = this->Medium.BadCells;
    const std::size_t cells = this->Medium.Extinction.size();
    this->Field.Fluence.assign(cells, glm::vec3(0.0f));
    this->Field.NetFlux.assign(cells, glm::vec3(0.0f));
  }

  void Forward()
  {
    const double variance = this->Settings.AngleVariance >= 0.0 ? this->Settings.AngleVariance
                                                                : this->Phase.ForwardVariance();
    this->SolveForward(this->Phase.ForwardFraction(), variance);
    const std::vector<EscapeRays::Sums> sums = this->TraceLights({});
    const glm::dvec3 remaining = this->LimitForward(sums, 1.0);
    this->Report.Dropped = Vectors::Mean(remaining);
    this->ReportLights(sums);
  }

  void Full()
  {
    const double cosine = this->Phase.Moment(1);
    const double peak = cosine > 0.0 ? std::min(std::max(this->Phase.Moment(2), 0.0), cosine) : 0.0;
    this->SolveForward(peak, 0.0);
    DiffuseLight::Input input;
    input.Cosine = cosine;
    input.Peak = peak;
    input.BackwardLayers = this->Settings.BackwardLayers;
    input.Tolerance = this->Settings.Tolerance;
    input.MaximumCycles = this->Settings.MaximumCycles;
    for (std::size_t light = 0; light < this->Medium.Lights.size(); ++light)
    {
      input.Lights.push_back(this->Medium.Direct[light]);
      for (std::size_t i = 0; i < input.Lights.back().size(); ++i)
      {
        input.Lights.back()[i] +=
          this->Field.Forward.empty() ? glm::vec3(0.0f) : this->Field.Forward[light][i];
      }
    }
    this->Slopes = LightSlopes::Find(this->Medium, input.Lights);
    input.Slopes = this->Slopes;
    DiffuseLight::Output diffuse = DiffuseLight::Solve(this->Medium, input);
    this->Report.Cycles = diffuse.Cycles;
    this->Report.Residual = diffuse.Residual;
    OrdinateSweep::Improve(this->Medium, input, diffuse);
    this->Balance(input, diffuse);
    this->Field.Fluence.swap(diffuse.Fluence);
    this->Field.NetFlux.swap(diffuse.NetFlux);
  }

private:
  void SolveForward(double fraction, double variance)
  {
    const std::size_t lights = this->Medium.Lights.size();
    for (std::size_t light = 0; light < lights; ++light)
    {
      this->Report.Taken += Vectors::Mean(this->SumExtinguished(light));
    }
    this->Slopes = LightSlopes::Find(this->Medium, this->Medium.Direct);
    if (!(fraction > 0.0))
    {
      return;
    }
    std::vector<int> layers(lights, 0);
    this->Field.Forward.resize(lights);
    ParallelFor(0, static_cast<vtkIdType>(lights), 1,
      [&](vtkIdType i)
      {
        const std::size_t light = static_cast<std::size_t>(i);
        this->Field.Forward[light] =
          ForwardLight::Solve(this->Medium, light, fraction, variance, layers[light]);
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
    for (std::size_t i = 0; i < this->Medium.Extinction.size(); ++i)
    {
      if (this->Medium.Extinction[i] > 0.0f)
      {
        sum += this->Medium.CellVolume * this->Medium.Extinction[i] * function(i);
      }
    }
    return sum;
  }

  glm::dvec3 GetLight(std::size_t light, std::size_t cell) const
  {
    return glm::dvec3(this->Medium.Direct[light][cell]) +
      (this->Field.Forward.empty() ? glm::dvec3(0.0)
                                   : glm::dvec3(this->Field.Forward[light][cell]));
  }

  glm::dvec3 SumExtinguished(std::size_t light) const
  {
    return this->SumCells([&](std::size_t i) { return glm::dvec3(this->Medium.Direct[light][i]); });
  }

  /// Returns the absorbed energy of direct and forward-scattered light.
  glm::dvec3 SumAbsorbed() const
  {
    return this->SumCells(
      [&](std::size_t i)
      {
        glm::dvec3 light(0.0);
        for (std::size_t l = 0; l < this->Medium.Lights.size(); ++l)
        {
          light += this->GetLight(l, i);
        }
        return (1.0 - glm::dvec3(this->Medium.Albedo[i])) * light;
      });
  }

  /// Returns the energy-weighted mean direction of all lights. It has no component along axes with
  /// mirrors, since no light leaves there.
  glm::dvec3 GetMainDirection() const
  {
    const ScatteringMedium& box = this->Medium.Box;
    const glm::dvec3 center = box.Origin + 0.5 * glm::dvec3(box.Cells) * box.CellSize;
    glm::dvec3 direction(0.0);
    for (std::size_t light = 0; light < this->Medium.Lights.size(); ++light)
    {
      direction += Vectors::Mean(this->SumExtinguished(light)) *
        this->Medium.Lights[light].GetDirection(center);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = box.Mirrors[axis] ? 0.0 : direction[axis];
    }
    return direction;
  }

  /// Returns the sums for the singly scattered light of each light, then for the forward light of
  /// each light, then for \a others.
  std::vector<EscapeRays::Sums> TraceLights(const std::vector<EscapeRays::Source>& others) const
  {
    const glm::dvec3 direction = this->GetMainDirection();
    const SingleScatteringEscape single(this->Phase);
    std::vector<EscapeRays::Sums> sums;
    for (std::size_t i = 0; i < this->Medium.Lights.size(); ++i)
    {
      sums.push_back(single.Find(this->Medium, i, direction));
    }
    std::vector<EscapeRays::Source> sources;
    for (std::size_t i = 0; i < this->Field.Forward.size(); ++i)
    {
      sources.emplace_back();
      sources.back().Fluence = &this->Field.Forward[i];
      sources.back().Light = &this->Medium.Lights[i];
    }
    sources.insert(sources.end(), others.begin(), others.end());
    const std::vector<EscapeRays::Sums> fields =
      EscapeRays::Trace(this->Medium, this->Phase, sources, direction);
    sums.insert(sums.end(), fields.begin(), fields.end());
    return sums;
  }

  /**
   * Scales down the forward light of each light if it needs more than \a fraction of the recaptured
   * singly scattered light. Returns the remaining recaptured light. Forward light is assumed to
   * travel in the direction of the unscattered light. At grazing incidence, it therefore reaches
   * deeper than light with the true scattering angles.
   */
  glm::dvec3 LimitForward(std::vector<EscapeRays::Sums> const& sums, double fraction)
  {
    const std::size_t lights = this->Medium.Lights.size();
    this->ForwardScale.assign(this->Field.Forward.size(), glm::dvec3(1.0));
    glm::dvec3 remaining(0.0);
    for (std::size_t light = 0; light < lights; ++light)
    {
      remaining += sums[light].Recaptured;
      if (this->Field.Forward.empty())
      {
        continue;
      }
      std::vector<glm::vec3>& forward = this->Field.Forward[light];
      // The forward light that is absorbed or leaves the box.
      const glm::dvec3 needed =
        this->SumCells([&](std::size_t i)
          { return (1.0 - glm::dvec3(this->Medium.Albedo[i])) * glm::dvec3(forward[i]); }) +
        sums[lights + light].GetEscaped();
      glm::dvec3& scale = this->ForwardScale[light];
      for (int color = 0; color < 3; ++color)
      {
        const double maximum = fraction * sums[light].Recaptured[color];
        scale[color] = needed[color] > maximum ? maximum / needed[color] : 1.0;
      }
      remaining -= scale * needed;
      for (glm::vec3& value : forward)
      {
        value *= glm::vec3(scale);
      }
    }
    return glm::max(remaining, 0.0);
  }

  /// Adds the absorbed and escaping energy of direct and forward light to the report.
  void ReportLights(const std::vector<EscapeRays::Sums>& sums)
  {
    const std::size_t lights = this->Medium.Lights.size();
    this->Report.Absorbed += Vectors::Mean(this->SumAbsorbed());
    for (std::size_t i = 0; i < lights + this->ForwardScale.size(); ++i)
    {
      this->ReportOut(sums[i], i < lights ? glm::dvec3(1.0) : this->ForwardScale[i - lights]);
    }
  }

  void ReportOut(const EscapeRays::Sums& sums, const glm::dvec3& scale)
  {
    this->Report.Absorbed += Vectors::Mean(scale * sums.Blocked);
    this->Report.Reflected += Vectors::Mean(scale * sums.Backward);
    this->Report.Transmitted += Vectors::Mean(scale * sums.Forward);
  }

  /**
   * Scales the fluence to conserve energy: the light that cameras around the box see and the light
   * that the medium absorbs add up to the light that the medium extinguishes. The factor satisfies
   *
   *   K - (part of K that becomes forward light) = factor (out(fluence) + absorbed(fluence)),
   *
   * where K is the recaptured part of the singly scattered light.
   */
  void Balance(const DiffuseLight::Input& input, DiffuseLight::Output& diffuse)
  {
    // The diffusion solution can be 0 if all light leaves the medium at once. Add a small fluence
    // that can be scaled.
    for (std::size_t i = 0; i < diffuse.Fluence.size(); ++i)
    {
      for (const std::vector<glm::vec3>& light : input.Lights)
      {
        diffuse.Fluence[i] =
          glm::max(diffuse.Fluence[i], 1e-3f * this->Medium.Albedo[i] * light[i]);
      }
    }
    this->LimitFluence(diffuse.Fluence);
    const std::vector<EscapeRays::Sums> sums = this->TraceLights({ this->GetSource(diffuse) });
    const glm::dvec3 recaptured = this->LimitForward(sums, MaximumForwardFraction);
    this->ReportLights(sums);
    const glm::dvec3 absorbed = this->SumCells([&](std::size_t i)
      { return (1.0 - glm::dvec3(this->Medium.Albedo[i])) * glm::dvec3(diffuse.Mean[i]); });
    glm::dvec3 dropped(0.0);
    for (std::size_t i = 0; i < diffuse.Drop.size(); ++i)
    {
      dropped += this->Medium.CellVolume * diffuse.Drop[i] * glm::dvec3(diffuse.Mean[i]);
    }
    glm::dvec3 factor(0.0);
    const glm::dvec3 lost = sums.back().GetEscaped() + absorbed + dropped;
    for (int color = 0; color < 3; ++color)
    {
      factor[color] = lost[color] > 0.0 ? recaptured[color] / lost[color] : 0.0;
    }
    for (glm::vec3& fluence : diffuse.Fluence)
    {
      fluence *= glm::vec3(factor);
    }
    this->Report.Absorbed += Vectors::Mean(factor * absorbed);
    if (!this->LimitFluence(diffuse.Fluence))
    {
      this->Report.Dropped += Vectors::Mean(factor * dropped);
      this->ReportOut(sums.back(), factor);
      return;
    }
    // Light removed by LimitFluence is not visible and is reported as dropped.
    const EscapeRays::Sums out = EscapeRays::Trace(
      this->Medium, this->Phase, { this->GetSource(diffuse) }, this->GetMainDirection())
                                   .front();
    this->ReportOut(out, glm::dvec3(1.0));
    this->Report.Dropped += Vectors::Mean(recaptured - factor * absorbed - out.GetEscaped());
  }

  EscapeRays::Source GetSource(const DiffuseLight::Output& diffuse) const
  {
    EscapeRays::Source source;
    source.Fluence = &diffuse.Fluence;
    source.NetFlux = &diffuse.NetFlux;
    source.NetFluxFactor = 3.0 * this->Phase.Moment(1);
    return source;
  }

  /**
   * Limits the fluence to the maximum in a half space without absorption, relative to the incident
   * light: sqrt(3) H(1) deep inside, and H(1)^2 / 2 - 1 / 2 near the surface, where H is
   * Chandrasekhar's function and the last term is single scattering. Returns true if a value was
   * reduced. Does nothing if the box has mirrors, since there is no such limit between mirrors.
   */
  bool LimitFluence(std::vector<glm::vec3>& fluence) const
  {
    if (glm::any(this->Medium.Box.Mirrors))
    {
      return false;
    }
    constexpr float interiorMaximum = 5.0364f;
    constexpr float visibleMaximum = 3.7277f;
    const glm::vec3 light = this->FindIncoming();
    const double size = Vectors::InfinityNorm(this->Medium.Box.CellSize);
    bool isLimited = false;
    for (std::size_t i = 0; i < fluence.size(); ++i)
    {
      const float transmittance = static_cast<float>(std::exp(-this->Medium.Extinction[i] * size));
      const glm::vec3 maximum =
        (visibleMaximum + transmittance * (interiorMaximum - visibleMaximum)) * light;
      isLimited = isLimited || glm::any(glm::greaterThan(fluence[i], maximum));
      fluence[i] = glm::min(fluence[i], maximum);
    }
    return isLimited;
  }

  /// Returns the maximum incident light over all cells, summed over all lights.
  glm::vec3 FindIncoming() const
  {
    const ScatteringMedium& box = this->Medium.Box;
    glm::vec3 sum(0.0f);
    for (std::size_t light = 0; light < this->Medium.Lights.size(); ++light)
    {
      glm::vec3 maximum(0.0f);
      for (std::size_t i = 0; i < this->Medium.Extinction.size(); ++i)
      {
        const int number = static_cast<int>(i);
        const glm::dvec3 cell(number % box.Cells.x, number / box.Cells.x % box.Cells.y,
          number / (box.Cells.x * box.Cells.y));
        const glm::dvec3 way =
          this->Medium.Lights[light].GetDirection(box.Origin + (cell + 0.5) * box.CellSize);
        // Light enters a cell through up to three faces. Its mean path length in the cell is the
        // reciprocal of the sum of the speeds.
        const glm::dvec3 speed = glm::abs(way) / box.CellSize;
        const double depth =
          this->Medium.Extinction[i] / std::max(speed.x + speed.y + speed.z, 1e-300);
        maximum = glm::max(maximum,
          this->Medium.Direct[light][i] *
            static_cast<float>(depth > 1e-6 ? depth / -std::expm1(-depth) : 1.0));
      }
      sum += maximum;
    }
    return sum;
  }

  /// Maximum fraction of the recaptured light that can become forward light in mode Full.
  static constexpr double MaximumForwardFraction = 0.75;

  SanitizedMedium Medium;
  PhaseFunction Phase;
  /// Result of LightSlopes::Find.
  std::vector<glm::vec3> Slopes;
  /// Scale factor of the forward light of each light, set by LimitForward.
  std::vector<glm::dvec3> ForwardScale;
  const ScatteringSettings& Settings;
  ScatteredLight& Field;
  ScatteringReport& Report;
};

}

Error ScatteringSolver::Solve(const ScatteringMedium& medium,
  const std::vector<ScatteringLight>& lights, ScatteringMode mode,
  const ScatteringSettings& settings, ScatteredLight& field, ScatteringReport& report)
{
  field = ScatteredLight();
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
