// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightSource_h
#define interlume_LightSource_h

#include "Common/Vectors.h"
#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

class vtkAreaLight;
class vtkLight;
class vtkProjectiveLight;

namespace interlume
{

/**
 * @class   LightSource
 * @brief   a light as slices see it, in unit space
 */
struct LightSource
{
  vtkLight* Light = nullptr;
  /// The projective light; null for all other lights.
  vtkProjectiveLight* Projective = nullptr;

  bool IsPositional = false;
  /// Of positional lights.
  glm::dvec3 Position{ 0.0, 0.0, 0.0 };
  /// Where light goes, length 1: of directional lights everywhere, of positional ones along the
  /// axis.
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 };

  /// Colours times intensity.
  glm::dvec3 Ambient{ 0.0, 0.0, 0.0 };
  glm::dvec3 Diffuse{ 1.0, 1.0, 1.0 };
  glm::dvec3 Specular{ 1.0, 1.0, 1.0 };

  /// The cosine of the cone's half angle and the exponent of the fall-off to its edge; -1 without a
  /// cone.
  double ConeCosine = -1.0;
  double Exponent = 0.0;
  /// 1 / (a + b d + c d^2) with d in unit space; 1, 0, 0 for directional lights.
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };

  /// The share of the light that shadows take, 0 to 1; a light with 0 casts none.
  double ShadowStrength = 0.0;

  /// The matrix from unit space to the screen of a projective light, as GetScreenMatrix computes
  /// it.
  glm::dmat4 ScreenFromUnit{ 0.0 };

  /// The area light whose emitter has an extent; null for all other lights, those of size 0 too.
  vtkAreaLight* Area = nullptr;
  /// The width and height of its emitter as vectors: to the right and up. Of positional lights in
  /// unit space, of directional ones where the distance to the emitter is 1.
  std::array<glm::dvec3, 2> EmitterAxes{};

  /// Returns the light's place, or where its light comes from, in homogeneous coordinates.
  glm::dvec4 GetHomogeneous() const
  {
    return this->IsPositional ? glm::dvec4(this->Position, 1.0) : glm::dvec4(-this->Direction, 0.0);
  }
};

}

#endif
