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
 * @brief   the lights of a renderer that are switched on, for a shader
 */
class FlowLights
{
public:
  /// Finds at most this many lights.
  static constexpr int Largest = 16;

  /// \a center is the place that positions become relative to.
  void Gather(vtkRenderer* renderer, const glm::dvec3& center);

  int GetNumber() const { return static_cast<int>(this->Positional.size()); }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  /// The way to a directional light, length 1, or the position.
  std::vector<glm::vec3> Places;
  std::vector<glm::vec3> Colors;
  std::vector<float> Positional;
  glm::vec3 Ambient{ 0.0F };
};

}

#endif
