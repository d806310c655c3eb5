// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowLights_h
#define interlume_FlowLights_h

#include <vector>

#include <glm/vec3.hpp>

class vtkRenderer;
class vtkShaderProgram;

namespace interlume
{

/**
 * @class   FlowLights
 * @brief   shader data of those lights of a renderer that are switched on
 */
class FlowLights
{
public:
  /// Maximum number of lights; further lights are ignored.
  static constexpr int MaximumNumber = 16;

  /// Collects the lights. Positions are stored relative to \a center.
  void Gather(vtkRenderer* renderer, const glm::dvec3& center);

  int GetNumber() const { return static_cast<int>(this->Positional.size()); }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  /// Unit vectors toward directional lights, and positions of positional lights.
  std::vector<glm::vec3> Positions;
  std::vector<glm::vec3> Colors;
  std::vector<float> Positional;
  glm::vec3 Ambient{ 0.0F };
};

}

#endif
