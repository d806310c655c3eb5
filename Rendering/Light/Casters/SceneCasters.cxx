// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/SceneCasters.h"

#include "Space/MatrixUniform.h"

#include "InterlumeSceneCasters.h"
#include "InterlumeSceneDepths.h"
#include "InterlumeSceneEmitters.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowedSceneReport.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <iterator>

namespace interlume
{

namespace
{
/// The most columns and rows of all maps of samples together, 256 MiB.
constexpr int LARGEST_EMITTER_MAPS = 8192;

template <class Vector>
void Append(std::vector<float>& values, const Vector& vector)
{
  const auto* components = glm::value_ptr(vector);
  std::transform(components, components + vector.length(), std::back_inserter(values),
    [](double value) { return static_cast<float>(value); });
}
}

void SceneCasters::Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
  const std::vector<CasterView::Box>& casters, int resolution, int samples)
{
  this->Space = space;
  this->Samples = samples;
  this->Views.Fit(lights, space, casters, resolution);
  this->Emitters.Fit(
    lights, space, casters, EmitterViews::GetResolution(resolution, samples), samples);
}

void SceneCasters::Clear()
{
  this->Fit({}, UnitSpace(), {}, 1, 1);
}

bool SceneCasters::HasViews() const
{
  return !this->Views.GetViews().empty() || !this->Emitters.GetViews().empty();
}

std::string SceneCasters::Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& props,
  int resolution, double bias, vtkShadowedSceneReport& report)
{
  report.Casters = static_cast<int>(props.size());
  report.Lights =
    static_cast<int>(this->Views.GetLights().size() + this->Emitters.GetLights().size());
  report.AreaLights = static_cast<int>(this->Emitters.GetLights().size());
  std::string error;
  const auto draw = [&](
                      CasterMaps& maps, const std::vector<CasterView>& views, int columns, int most)
  {
    if (views.empty())
    {
      maps.ReleaseGraphicsResources(renderer->GetRenderWindow());
      return 0;
    }
    const int largest = CasterMaps::GetLargestResolution(static_cast<int>(views.size()), most);
    const int used = std::min(columns, largest);
    error = error.empty() ? maps.Draw(renderer, views, props, used, bias) : error;
    return used;
  };
  report.DepthMapResolution = draw(this->Maps, this->Views.GetViews(), resolution, VTK_INT_MAX);
  report.DepthMaps = static_cast<int>(this->Views.GetViews().size());
  report.DepthMapsDrawn = this->Maps.GetDrawn();
  report.DepthMapBytes = this->Maps.GetBytes();
  report.SampleMapResolution = draw(this->EmitterMaps, this->Emitters.GetViews(),
    EmitterViews::GetResolution(resolution, this->Samples), LARGEST_EMITTER_MAPS);
  report.SampleMaps = static_cast<int>(this->Emitters.GetViews().size());
  report.SampleMapsDrawn = this->EmitterMaps.GetDrawn();
  report.SampleMapBytes = this->EmitterMaps.GetBytes();
  if (report.DepthMapsDrawn + report.SampleMapsDrawn > 0)
  {
    this->DrawTime.Modified();
  }
  return error;
}

std::string SceneCasters::GetFeatures() const
{
  std::string features;
  if (!this->Views.GetViews().empty())
  {
    features += this->Maps.GetFeatures();
  }
  if (!this->Emitters.GetViews().empty())
  {
    features += features.empty() ? "" : " ";
    features += "EMITTERS=" + std::to_string(this->Emitters.GetLights().size()) +
      " EMITTER_SIDES=" + std::to_string(this->Emitters.GetSides().size()) +
      " EMITTER_SAMPLES=" + std::to_string(this->Emitters.GetSamples().size());
  }
  return features;
}

std::string SceneCasters::GetSource() const
{
  std::string source = InterlumeSceneDepths;
  source += this->Views.GetViews().empty() ? "" : InterlumeSceneCasters;
  source += this->Emitters.GetViews().empty() ? "" : InterlumeSceneEmitters;
  return source;
}

std::string SceneCasters::GetShare(
  vtkLight* light, const std::string& place, const std::string& plane) const
{
  const std::string at = "," + place + "," + plane + ")";
  if (const CasterViews::Light* seen = this->Views.Find(light))
  {
    return "lightOfCasters(" + std::to_string(seen->FirstView) + "," + std::to_string(seen->Views) +
      at;
  }
  const int emitter = this->Emitters.Find(light);
  return emitter < 0 ? std::string() : "lightOfEmitter(" + std::to_string(emitter) + at;
}

std::string SceneCasters::GetSampleShare(vtkLight* light, int samples, const std::string& sample,
  const std::string& place, const std::string& plane) const
{
  const int emitter = this->Emitters.Find(light);
  if (emitter < 0)
  {
    return {};
  }
  const EmitterViews::Light& seen = this->Emitters.GetLights()[static_cast<std::size_t>(emitter)];
  return seen.Samples != samples ? std::string()
                                 : "lightOfEmitterSample(" + std::to_string(emitter) + "," +
      std::to_string(seen.FirstSample) + "+" + sample + "," + place + "," + plane + ")";
}

void SceneCasters::SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const
{
  if (program->IsUniformUsed("casterDepths"))
  {
    this->Maps.SetUniforms(program, worldFromPlace);
  }
  if (program->IsUniformUsed("emitterDepths"))
  {
    this->SetEmitterUniforms(program, worldFromPlace);
  }
}

void SceneCasters::SetEmitterUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const
{
  MatrixUniform::Set(program, "emitterFromPlace", this->Space.GetUnitFromWorld() * worldFromPlace);
  if (program->IsUniformUsed("placeFromEmitter"))
  {
    MatrixUniform::Set(
      program, "placeFromEmitter", glm::inverse(worldFromPlace) * this->Space.GetWorldFromUnit());
  }
  std::vector<float> lights;
  for (const EmitterViews::Light& light : this->Emitters.GetLights())
  {
    Append(lights, glm::dvec4(light.Place, light.IsPositional ? 1.0 : 0.0));
    Append(lights, glm::dvec4(light.Depth, light.FirstView, 0.0));
    Append(lights, glm::dvec4(light.FirstSample, light.Samples, light.FirstSide, light.Sides));
    for (const glm::dvec3& axis : light.Stratum)
    {
      Append(lights, glm::dvec4(axis, 0.0));
    }
  }
  std::vector<float> sides;
  for (const CasterView::Axes& side : this->Emitters.GetSides())
  {
    Append(sides, side.Right);
    Append(sides, side.Up);
    Append(sides, side.Along);
  }
  std::vector<float> samples;
  for (const EmitterViews::Sample& sample : this->Emitters.GetSamples())
  {
    Append(samples, glm::dvec4(sample.Offset, 0.0));
    Append(samples, glm::dvec4(sample.Scale, sample.Middle));
    Append(samples, glm::dvec4(sample.Weight, 0.0));
  }
  program->SetUniformi("emitterDepths", this->EmitterMaps.GetTexture()->GetTextureUnit());
  program->SetUniform4fv("emitters", static_cast<int>(lights.size() / 4), lights.data());
  program->SetUniform3fv("emitterSides", static_cast<int>(sides.size() / 3), sides.data());
  program->SetUniform4fv("emitterSamples", static_cast<int>(samples.size() / 4), samples.data());
  this->AddBias(program, 0.0);
}

void SceneCasters::ClearUniforms(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("emitters"))
  {
    const std::vector<float> none(20 * this->Emitters.GetLights().size(), 0.0F);
    program->SetUniform4fv("emitters", static_cast<int>(none.size() / 4), none.data());
  }
}

void SceneCasters::AddBias(vtkShaderProgram* program, double texels) const
{
  const ViewTiles& maps = this->EmitterMaps.GetTiles();
  const std::array<float, 3> tiles{ { static_cast<float>(maps.GetColumns()),
    static_cast<float>(maps.GetResolution()), static_cast<float>(maps.GetBias() + texels) } };
  program->SetUniform3f("emitterTiles", tiles.data());
}

std::vector<std::pair<const char*, vtkTextureObject*>> SceneCasters::GetTextures() const
{
  return { { "casterDepths", this->Maps.GetTexture() },
    { "emitterDepths", this->EmitterMaps.GetTexture() } };
}

void SceneCasters::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Maps.ReleaseGraphicsResources(window);
  this->EmitterMaps.ReleaseGraphicsResources(window);
}

}
