// SPDX-License-Identifier: BSD-3-Clause
#include "Receivers/ActorShader.h"

#include "ShadowMaps/SceneOccluders.h"
#include "Lights/LightSource.h"
#include "Offscreen/ShaderFeatures.h"
#include "Receivers/LightTransmittance.h"
#include "Receivers/SceneScatteredLight.h"
#include "Receivers/SceneLightImages.h"
#include "Space/UnitVector.h"
#include "Translucent/TranslucentShadowMaps.h"

#include "InterlumeSceneActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cctype>

namespace interlume
{

namespace
{
const std::string DECLARATION_MARK = "//INTERLUME::SceneDec";
const std::string IMPLEMENTATION_MARK = "//INTERLUME::SceneImpl";
const std::string LIGHT_COLOR = "lightColor";

std::string Tuple(const std::string& type, const std::array<int, 2>& values)
{
  return type + "(" + std::to_string(values[0]) + ", " + std::to_string(values[1]) + ")";
}
}

bool ActorShader::Update(vtkRenderer* renderer, const std::vector<LightSource>& lights,
  const SceneOccluders& occluders, const LightTransmittance& transmittance,
  const TranslucentShadowMaps& translucentMaps, const SceneLightImages& screens,
  const SceneScatteredLight& fields)
{
  this->Fields = &fields;
  this->TranslucentMaps = &translucentMaps;
  this->Screens = &screens;
  this->Occluders = &occluders;
  this->WorldFromView = glm::inverse(
    UnitVector::FromRows(renderer->GetActiveCamera()->GetModelViewTransformMatrix()->GetData()));
  std::array<int, 4> viewport{};
  renderer->GetTiledSizeAndOrigin(&viewport[2], &viewport[3], &viewport[0], &viewport[1]);
  std::transform(viewport.begin(), viewport.end(), this->Viewport.begin(),
    [](int value) { return static_cast<float>(value); });

  Parts shadowedParts;
  Parts imageParts;
  this->Lights.clear();
  vtkLightCollection* collection = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  collection->InitTraversal(iterator);
  int number = 0;
  bool hasVolumes = false;
  while (vtkLight* light = collection->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const auto source = std::find_if(lights.begin(), lights.end(),
      [light](const LightSource& other) { return other.Light == light; });
    Light shadowed;
    if (source != lights.end() && source->ShadowStrength > 0.0)
    {
      shadowed.Strength = static_cast<float>(source->ShadowStrength);
      shadowed.OpaqueCall = occluders.GetLightFraction(light, "vertexVC.xyz", "scenePlaneHere");
      shadowed.Tile = transmittance.IsUsed() ? transmittance.GetTile(light) : -1;
    }
    shadowed.Screen = screens.GetFactor(light);
    if (!shadowed.Screen.empty())
    {
      imageParts.Numbers.push_back(number);
      imageParts.Implementation +=
        "  vec3 sceneLight" + std::to_string(number) + " = vec3(1.0)" + shadowed.Screen + ";\n";
    }
    shadowed.TranslucentCall =
      translucentMaps.GetLightFraction(light, "vertexVC.xyz", "scenePlaneHere");
    if (!shadowed.OpaqueCall.empty() || shadowed.Tile >= 0 || !shadowed.Screen.empty() ||
      !shadowed.TranslucentCall.empty())
    {
      shadowedParts.Numbers.push_back(number);
      this->Lights.push_back(shadowed);
      hasVolumes = hasVolumes || shadowed.Tile >= 0;
    }
    ++number;
  }
  if (this->Lights.empty())
  {
    return this->Clear();
  }

  std::string features = "SCENE_LIGHTS=" + std::to_string(this->Lights.size());
  features += occluders.HasViews() ? " OCCLUDER_PLANES " + occluders.GetFeatures() : "";
  if (hasVolumes)
  {
    features += " TRANSMITTANCE SCENE_CHANNELS=";
    features += transmittance.GetChannels() == 1 ? "rrr" : "rgb";
  }
  std::string source = InterlumeSceneActor;
  vtkShaderProgram::Substitute(
    source, "//INTERLUME::OCCLUDERS", occluders.HasViews() ? occluders.GetSource() : "", false);
  imageParts.Declarations = screens.GetDeclarations();
  shadowedParts.Declarations = ShaderFeatures::Insert(source, features) +
    translucentMaps.GetSource(true) + imageParts.Declarations + fields.GetSource();
  std::string& implementation = shadowedParts.Implementation;
  implementation = hasVolumes ? "  ivec2 scenePixelHere = scenePixel();\n" : "";
  implementation += occluders.HasViews() || translucentMaps.GetLayers() > 0
    ? "  vec4 scenePlaneHere = scenePlane(vertexVC.xyz);\n"
    : "";
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    const Light& light = this->Lights[i];
    std::string factor = "vec3(1.0)";
    factor += light.OpaqueCall.empty() ? "" : " * " + light.OpaqueCall;
    factor += light.TranslucentCall.empty() ? "" : " * " + light.TranslucentCall;
    if (light.Tile >= 0)
    {
      factor += " * sceneLightOfVolumes(scenePixelHere + " +
        Tuple("ivec2", transmittance.GetOrigin(light.Tile)) + ")";
    }
    implementation += "  vec3 sceneLight" + std::to_string(shadowedParts.Numbers[i]) +
      " = sceneLightOf(" + std::to_string(i) + ", " + factor + ")" + light.Screen + ";\n";
  }
  // The GLSL code for images is part of the code for shadows, so it need not be compared.
  const bool isNew = shadowedParts.Declarations != this->Shadowed.Declarations ||
    implementation != this->Shadowed.Implementation;
  this->Shadowed = std::move(shadowedParts);
  this->Images = std::move(imageParts);
  return isNew;
}

bool ActorShader::Clear()
{
  const bool had = !this->Shadowed.Declarations.empty();
  this->Lights.clear();
  this->Shadowed = Parts();
  this->Images = Parts();
  return had;
}

void ActorShader::SetSurfaceTextures(
  const LightTransmittance& transmittance, vtkTextureObject* depth, bool isOnScreen)
{
  this->Transmittance = &transmittance;
  this->Depth = depth;
  this->IsOnScreen = isOnScreen;
}

void ActorShader::Mark(std::string& fragmentShader)
{
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Light::Dec", DECLARATION_MARK + "\n//VTK::Light::Dec", false);
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Light::Impl", IMPLEMENTATION_MARK + "\n//VTK::Light::Impl", false);
}

bool ActorShader::Replace(std::string& fragmentShader, bool isReceiver) const
{
  const Parts& parts = isReceiver ? this->Shadowed : this->Images;
  const std::size_t mark = fragmentShader.find(IMPLEMENTATION_MARK);
  const std::size_t body = mark == std::string::npos ? fragmentShader.find("main()") : mark;
  bool isLit = false;
  std::string text = fragmentShader;
  for (std::size_t position = body == std::string::npos ? body : text.find(LIGHT_COLOR, body);
       position != std::string::npos;)
  {
    std::size_t end = position + LIGHT_COLOR.size();
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0)
    {
      ++end;
    }
    const std::string number =
      text.substr(position + LIGHT_COLOR.size(), end - position - LIGHT_COLOR.size());
    const bool isShadowed = !number.empty() &&
      std::find(parts.Numbers.begin(), parts.Numbers.end(), std::stoi(number)) !=
        parts.Numbers.end();
    if (isShadowed)
    {
      const std::string product = "(" + LIGHT_COLOR + number + " * sceneLight" + number + ")";
      text.replace(position, end - position, product);
      end = position + product.size();
      isLit = true;
    }
    position = text.find(LIGHT_COLOR, end);
  }
  if (isLit && mark == std::string::npos)
  {
    return false;
  }
  if (isLit && isReceiver && this->Fields && !this->Fields->IsEmpty())
  {
    vtkShaderProgram::Substitute(text, "ambientColor + diffuse + specular",
      "ambientColor + diffuse + sceneScattered(vertexVC.xyz, normalVCVSOutput) * diffuseColor + "
      "specular",
      false);
    // In physically based shading, scattered light is added to the diffuse reflection of the
    // environment, which recent VTK versions set to 0 if there is no environment image.
    vtkShaderProgram::Substitute(text, "vec3 color = iblDiffuse + iblSpecular;",
      "iblDiffuse += (1.0 - F0) * (1.0 - metallic) * recPI * sceneScattered(vertexVC.xyz, N) * "
      "albedo;\n  vec3 color = iblDiffuse + iblSpecular;",
      false);
  }
  fragmentShader = text;
  vtkShaderProgram::Substitute(
    fragmentShader, DECLARATION_MARK, isLit ? parts.Declarations : "", false);
  vtkShaderProgram::Substitute(
    fragmentShader, IMPLEMENTATION_MARK, isLit ? parts.Implementation : "", false);
  return true;
}

void ActorShader::SetUniforms(
  vtkShaderProgram* program, bool isOpaque, bool isDepthOnly, vtkTextureObject* placeholder) const
{
  if (this->Screens)
  {
    this->Screens->SetUniforms(program, this->WorldFromView, isDepthOnly ? placeholder : nullptr);
  }
  if (this->Fields)
  {
    this->Fields->SetUniforms(program, this->WorldFromView, isOpaque && !isDepthOnly);
  }
  if (!program->IsUniformUsed("sceneStrengths"))
  {
    return;
  }
  std::vector<float> strengths;
  for (const Light& light : this->Lights)
  {
    strengths.push_back(light.Strength);
  }
  program->SetUniform1fv("sceneStrengths", static_cast<int>(strengths.size()), strengths.data());
  const bool hasVolumes = program->IsUniformUsed("sceneTransmittance");
  if (isDepthOnly)
  {
    this->Occluders->DisableSampleShadows(program);
    // A map cannot be read while it is being drawn.
    for (const char* name : { "occluderDepths", "emitterDepths", "translucentLayers",
           "sceneTransmittance", "sceneDepth" })
    {
      if (program->IsUniformUsed(name))
      {
        program->SetUniformi(name, placeholder->GetTextureUnit());
      }
    }
    return;
  }
  this->Occluders->SetUniforms(program, this->WorldFromView);
  this->TranslucentMaps->SetUniforms(program, this->WorldFromView);
  if (hasVolumes)
  {
    program->SetUniformi("sceneTransmittance", this->Transmittance->GetTexture()->GetTextureUnit());
    program->SetUniformi("sceneDepth", this->Depth->GetTextureUnit());
    program->SetUniformi("sceneIsOpaque", isOpaque ? 1 : 0);
    std::array<float, 4> viewport = this->Viewport;
    std::fill_n(viewport.begin(), this->IsOnScreen ? 0 : 2, 0.0F);
    program->SetUniform4f("sceneViewport", viewport.data());
  }
}

}
