// SPDX-License-Identifier: BSD-3-Clause
#include "Receivers/SceneScatteredLight.h"

#include "Common/Vectors.h"
#include "Space/ShaderUniforms.h"
#include "Space/UnitVector.h"

#include "InterlumeSceneField.h"
#include "vtkLight.h"
#include "vtkTextureObject.h"

#include <array>

namespace interlume
{

namespace
{
// Returns the GLSL code for one volume, with FIELD as a placeholder for the volume's index.
std::string GetFieldSource(const ScatteredLightTexture& field)
{
  std::string source = InterlumeSceneField;
  std::string declarations = field.Lights.empty()
    ? ""
    : "uniform vec4 sceneFieldLightsFIELD[" + std::to_string(field.Lights.size()) + "];\n";
  std::string forward;
  for (std::size_t i = 0; i < field.Lights.size(); ++i)
  {
    const std::string light = "sceneFieldLightsFIELD[" + std::to_string(i) + "]";
    forward += "  sum += max(sceneFieldAtFIELD(node, " + std::to_string(i + 2) +
      ".0), vec3(0.0)) * max(dot(normal, normalize(" + light + ".xyz - " + light +
      ".w * place)), 0.0);\n";
  }
  vtkShaderProgram::Substitute(source, "//INTERLUME::LIGHTS", declarations);
  vtkShaderProgram::Substitute(source, "//INTERLUME::FORWARD", forward);
  vtkShaderProgram::Substitute(source, "HAS_FLUENCE", field.HasFluence ? "1" : "0");
  return source;
}
}

std::string SceneScatteredLight::GetSource() const
{
  if (this->Fields.empty())
  {
    return {};
  }
  std::string source;
  std::string sum;
  for (std::size_t i = 0; i < this->Fields.size(); ++i)
  {
    std::string part = GetFieldSource(this->Fields[i]);
    vtkShaderProgram::Substitute(part, "FIELD", std::to_string(i));
    source += part;
    sum += (i > 0 ? " + " : "") + ("sceneScattered" + std::to_string(i)) + "(place, normal)";
  }
  return source + "vec3 sceneScattered(vec3 place, vec3 normal)\n{\n  return " + sum + ";\n}\n";
}

void SceneScatteredLight::ClearTextures()
{
  for (ScatteredLightTexture& field : this->Fields)
  {
    field.Texture = nullptr;
  }
}

void SceneScatteredLight::SetUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromView, bool isLit) const
{
  // A texture unit that is not used by samplers of other types.
  constexpr int noUnit = 15;
  const glm::dmat4 viewFromWorld = glm::inverse(worldFromView);
  for (std::size_t i = 0; i < this->Fields.size(); ++i)
  {
    const ScatteredLightTexture& field = this->Fields[i];
    if (!program->IsUniformUsed(("sceneField" + std::to_string(i)).c_str()))
    {
      continue;
    }
    const ShaderUniforms uniforms(program, std::to_string(i));
    const bool isHere = isLit && field.Texture;
    const std::size_t maps = 2 + field.Lights.size();
    const glm::dvec3 nodes(field.Nodes);
    uniforms.Set("sceneField", isHere ? field.Texture->GetTextureUnit() : noUnit);
    uniforms.Set("sceneNodes", glm::dvec4(nodes, isHere ? nodes.z * maps : 0.0));
    uniforms.Set("sceneAhead", field.BlockedCells > 0 ? 1.5 : 0.0);
    uniforms.Set("sceneNodeFromView", field.NodeFromWorld * worldFromView);
    uniforms.Set("sceneWorldFromView", worldFromView);
    std::vector<glm::vec4> lights;
    for (vtkLight* light : isHere ? field.Lights : std::vector<vtkLight*>())
    {
      const glm::dvec3 position = glm::make_vec3(light->GetTransformedPosition());
      const glm::dvec3 focus = glm::make_vec3(light->GetTransformedFocalPoint());
      const bool isPositional = light->GetPositional() != 0;
      lights.emplace_back(viewFromWorld *
        (isPositional ? glm::dvec4(position, 1.0) : glm::dvec4(position - focus, 0.0)));
    }
    if (!lights.empty())
    {
      uniforms.Set("sceneFieldLights", lights);
    }
  }
}

}
