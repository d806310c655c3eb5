// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowLights.h"

#include "Common/Vectors.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

namespace interlume
{

void FlowLights::Gather(vtkRenderer* renderer, const glm::dvec3& center)
{
  *this = FlowLights();
  glm::dvec3 ambient{ 0.0 };
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (!light->GetSwitch() || this->GetNumber() == MaximumNumber)
    {
      continue;
    }
    const glm::dvec3 position = glm::make_vec3(light->GetTransformedPosition());
    const glm::dvec3 focus = glm::make_vec3(light->GetTransformedFocalPoint());
    const bool isPositional = light->GetPositional() != 0;
    const glm::dvec3 direction = position - focus;
    this->Positions.emplace_back(
      isPositional ? position - center : direction / std::max(glm::length(direction), 1e-300));
    this->Colors.emplace_back(glm::make_vec3(light->GetDiffuseColor()) * light->GetIntensity());
    this->Positional.push_back(isPositional ? 1.0F : 0.0F);
    ambient += glm::make_vec3(light->GetAmbientColor()) * light->GetIntensity();
  }
  this->Ambient = glm::vec3(ambient == glm::dvec3(0.0) ? glm::dvec3(1.0) : ambient);
}

void FlowLights::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniform3f("ambientLight", glm::value_ptr(this->Ambient));
  const int number = this->GetNumber();
  const auto set = [&](const char* name, const std::vector<glm::vec3>& values)
  { program->SetUniform3fv(name, number, reinterpret_cast<const float(*)[3]>(values.data())); };
  if (number > 0)
  {
    set("lightDirections", this->Positions);
    set("lightColors", this->Colors);
    program->SetUniform1fv("lightIsPositional", number, this->Positional.data());
  }
}

}
