// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/SceneOccluders.h"

#include "ShadowMaps/SceneReport.h"
#include "Space/ShaderUniforms.h"

#include "InterlumeSceneShadowMaps.h"
#include "InterlumeSceneDepths.h"
#include "InterlumeSceneEmitters.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <iterator>

namespace interlume
{

namespace
{
/// Maximum number of columns and rows of the texture with the shadow maps of all samples of area
/// lights. A texture of this size takes 256 MiB.
constexpr int LARGEST_EMITTER_MAPS = 8192;
}

void SceneOccluders::Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
  const std::vector<ShadowMapView::Box>& occluders, int resolution, int samples)
{
  this->Space = space;
  this->Samples = samples;
  this->Views.Fit(lights, space, occluders, resolution);
  this->Emitters.Fit(
    lights, space, occluders, AreaLightViews::GetResolution(resolution, samples), samples);
}

void SceneOccluders::Clear()
{
  this->Fit({}, UnitSpace(), {}, 1, 1);
}

bool SceneOccluders::HasViews() const
{
  return !this->Views.GetViews().empty() || !this->Emitters.GetViews().empty();
}

Error SceneOccluders::Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& props,
  int resolution, double bias, SceneReport& report)
{
  report.ShadowCasters = static_cast<int>(props.size());
  report.Lights =
    static_cast<int>(this->Views.GetLights().size() + this->Emitters.GetLights().size());
  report.AreaLights = static_cast<int>(this->Emitters.GetLights().size());
  Error error;
  const auto draw =
    [&](SurfaceShadowMaps& maps, const std::vector<ShadowMapView>& views, int columns, int maximum)
  {
    if (views.empty())
    {
      maps.ReleaseGraphicsResources(renderer->GetRenderWindow());
      return 0;
    }
    const int largest =
      SurfaceShadowMaps::GetLargestResolution(static_cast<int>(views.size()), maximum);
    const int used = std::min(columns, largest);
    error = error ? error : maps.Draw(renderer, views, props, used, bias);
    return used;
  };
  report.DepthMapResolution = draw(this->Maps, this->Views.GetViews(), resolution, VTK_INT_MAX);
  report.DepthMaps = static_cast<int>(this->Views.GetViews().size());
  report.DepthMapsDrawn = this->Maps.GetDrawn();
  report.DepthMapBytes = this->Maps.GetBytes();
  report.SampleMapResolution = draw(this->EmitterMaps, this->Emitters.GetViews(),
    AreaLightViews::GetResolution(resolution, this->Samples), LARGEST_EMITTER_MAPS);
  report.SampleMaps = static_cast<int>(this->Emitters.GetViews().size());
  report.SampleMapsDrawn = this->EmitterMaps.GetDrawn();
  report.SampleMapBytes = this->EmitterMaps.GetBytes();
  if (report.DepthMapsDrawn + report.SampleMapsDrawn > 0)
  {
    this->DrawTime.Modified();
  }
  return error;
}

std::string SceneOccluders::GetFeatures() const
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

std::string SceneOccluders::GetSource() const
{
  std::string source = InterlumeSceneDepths;
  source += this->Views.GetViews().empty() ? "" : InterlumeSceneShadowMaps;
  source += this->Emitters.GetViews().empty() ? "" : InterlumeSceneEmitters;
  return source;
}

std::string SceneOccluders::GetLightFraction(
  vtkLight* light, const std::string& position, const std::string& plane) const
{
  const std::string at = "," + position + "," + plane + ")";
  if (const ShadowMapViews::Light* seen = this->Views.Find(light))
  {
    return "lightOfOccluders(" + std::to_string(seen->FirstView) + "," +
      std::to_string(seen->Views) + at;
  }
  const int emitter = this->Emitters.Find(light);
  return emitter < 0 ? std::string() : "lightOfEmitter(" + std::to_string(emitter) + at;
}

std::string SceneOccluders::GetSampleLightFraction(vtkLight* light, int samples,
  const std::string& sample, const std::string& position, const std::string& plane) const
{
  const int emitter = this->Emitters.Find(light);
  if (emitter < 0)
  {
    return {};
  }
  const AreaLightViews::Light& seen = this->Emitters.GetLights()[static_cast<std::size_t>(emitter)];
  return seen.Samples != samples ? std::string()
                                 : "lightOfEmitterSample(" + std::to_string(emitter) + "," +
      std::to_string(seen.FirstSample) + "+" + sample + "," + position + "," + plane + ")";
}

void SceneOccluders::SetUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const
{
  if (program->IsUniformUsed("occluderDepths"))
  {
    this->Maps.SetUniforms(program, worldFromPosition);
  }
  if (program->IsUniformUsed("emitterDepths"))
  {
    this->SetEmitterUniforms(program, worldFromPosition);
  }
}

void SceneOccluders::SetEmitterUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const
{
  const ShaderUniforms uniforms(program);
  uniforms.Set("emitterFromPosition", this->Space.GetUnitFromWorld() * worldFromPosition);
  uniforms.Set(
    "positionFromEmitter", glm::inverse(worldFromPosition) * this->Space.GetWorldFromUnit());
  std::vector<glm::vec4> lights;
  for (const AreaLightViews::Light& light : this->Emitters.GetLights())
  {
    lights.emplace_back(glm::dvec4(light.Position, light.IsPositional ? 1.0 : 0.0));
    lights.emplace_back(glm::dvec4(light.Depth, light.FirstView, 0.0));
    lights.emplace_back(light.FirstSample, light.Samples, light.FirstSide, light.Sides);
    for (const glm::dvec3& axis : light.Stratum)
    {
      lights.emplace_back(glm::dvec4(axis, 0.0));
    }
  }
  std::vector<glm::vec3> sides;
  for (const ShadowMapView::Axes& side : this->Emitters.GetSides())
  {
    sides.insert(sides.end(), { glm::vec3(side.Right), glm::vec3(side.Up), glm::vec3(side.Along) });
  }
  std::vector<glm::vec4> samples;
  for (const AreaLightViews::Sample& sample : this->Emitters.GetSamples())
  {
    samples.emplace_back(glm::dvec4(sample.Offset, 0.0));
    samples.emplace_back(glm::dvec4(sample.Scale, sample.Center));
    samples.emplace_back(glm::dvec4(sample.Weight, 0.0));
  }
  uniforms.Set("emitterDepths", this->EmitterMaps.GetTexture()->GetTextureUnit());
  uniforms.Set("emitters", lights);
  uniforms.Set("emitterSides", sides);
  uniforms.Set("emitterSamples", samples);
  this->AddBias(program, 0.0);
}

void SceneOccluders::DisableSampleShadows(vtkShaderProgram* program) const
{
  ShaderUniforms(program).Set(
    "emitters", std::vector<glm::vec4>(5 * this->Emitters.GetLights().size(), glm::vec4(0.0F)));
}

void SceneOccluders::AddBias(vtkShaderProgram* program, double texels) const
{
  const ShadowMapAtlas& maps = this->EmitterMaps.GetAtlas();
  ShaderUniforms(program).Set(
    "emitterTiles", glm::dvec3(maps.GetColumns(), maps.GetResolution(), maps.GetBias() + texels));
}

std::vector<std::pair<const char*, vtkTextureObject*>> SceneOccluders::GetTextures() const
{
  return { { "occluderDepths", this->Maps.GetTexture() },
    { "emitterDepths", this->EmitterMaps.GetTexture() } };
}

void SceneOccluders::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Maps.ReleaseGraphicsResources(window);
  this->EmitterMaps.ReleaseGraphicsResources(window);
}

}
