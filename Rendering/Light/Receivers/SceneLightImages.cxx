// SPDX-License-Identifier: BSD-3-Clause
#include "Receivers/SceneLightImages.h"

#include "Space/ShaderUniforms.h"
#include "Space/UnitSpace.h"

#include "InterlumeLightScreen.h"
#include "vtkAreaLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProjectiveLight.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>

namespace interlume
{

SceneLightImages::SceneLightImages() = default;

SceneLightImages::~SceneLightImages() = default;

void SceneLightImages::Gather(const std::vector<LightSource>& lights,
  const std::vector<vtkLight*>& skipped, const UnitSpace& space)
{
  this->Images.clear();
  this->Textures.clear();
  for (const LightSource& source : lights)
  {
    Image image;
    image.Source = source;
    if (auto* area = vtkAreaLight::SafeDownCast(source.Light))
    {
      area->GetEmitterColor(glm::value_ptr(image.Color));
    }
    if (source.Projective)
    {
      image.ScreenFromWorld = source.ScreenFromUnit * space.GetUnitFromWorld();
    }
    if (source.Projective || image.Color != glm::dvec3(1.0))
    {
      this->Images.push_back(image);
    }
  }
  for (vtkLight* light : skipped)
  {
    Image image;
    image.Source.Light = light;
    image.Color = glm::dvec3(0.0);
    this->Images.push_back(image);
  }
}

void SceneLightImages::Upload(vtkOpenGLRenderWindow* window)
{
  this->Textures.clear();
  std::vector<vtkProjectiveLight*> retained;
  vtkIdType bytes = 0;
  for (Image& image : this->Images)
  {
    vtkProjectiveLight* light = image.Source.Projective;
    if (light && light->GetImage())
    {
      image.Texture = this->Screens.Get(window, light, bytes);
      this->Textures.push_back(image.Texture);
      retained.push_back(light);
    }
  }
  this->Screens.Keep(retained, window);
}

std::string SceneLightImages::GetDeclarations() const
{
  std::string source;
  bool hasScreens = false;
  for (std::size_t i = 0; i < this->Images.size(); ++i)
  {
    const std::string number = std::to_string(i);
    vtkProjectiveLight* light = this->Images[i].Source.Projective;
    if (!light)
    {
      source += "uniform vec3 sceneEmitter" + number + ";\n";
      continue;
    }
    hasScreens = true;
    const bool hasImage = light->GetImage() != nullptr;
    source += "uniform mat4 sceneScreenFromView" + number + ";\n";
    // Width of the screen's smooth edge, and the screen's opacity.
    source += "uniform vec2 sceneScreen" + number + ";\n";
    source += hasImage ? "uniform sampler2D sceneImage" + number + ";\n" : "";
    source += "vec3 lightOfSceneScreen" + number + "(vec3 place)\n{\n  vec2 uv;\n";
    source += "  float share = lightOfScreen(sceneScreenFromView" + number +
      " * vec4(place, 1.0), sceneScreen" + number + ".x, sceneScreen" + number + ".y, uv);\n";
    source += hasImage ? "  return share > 0.0 ? share * textureLod(sceneImage" + number +
        ", uv, 0.0).rgb : vec3(0.0);\n}\n"
                       : "  return vec3(share);\n}\n";
  }
  return (hasScreens ? InterlumeLightScreen : "") + source;
}

std::string SceneLightImages::GetFactor(vtkLight* light) const
{
  const auto found = std::find_if(this->Images.begin(), this->Images.end(),
    [light](const Image& image) { return image.Source.Light == light; });
  if (found == this->Images.end())
  {
    return {};
  }
  const std::string number = std::to_string(found - this->Images.begin());
  return found->Source.Projective ? " * lightOfSceneScreen" + number + "(vertexVC.xyz)"
                                  : " * sceneEmitter" + number;
}

void SceneLightImages::SetUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromView, vtkTextureObject* placeholder) const
{
  for (std::size_t i = 0; i < this->Images.size(); ++i)
  {
    const Image& image = this->Images[i];
    const ShaderUniforms uniforms(program, std::to_string(i));
    uniforms.Set("sceneEmitter", image.Color);
    uniforms.Set("sceneScreenFromView", image.ScreenFromWorld * worldFromView);
    if (vtkProjectiveLight* light = image.Source.Projective)
    {
      uniforms.Set("sceneScreen", glm::dvec2(light->GetEdgeWidth(), light->GetScreenOpacity()));
    }
    if (image.Texture)
    {
      uniforms.Set("sceneImage", (placeholder ? placeholder : image.Texture)->GetTextureUnit());
    }
  }
}

void SceneLightImages::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Screens.Keep({}, window);
  this->Textures.clear();
}

}
