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
 * @brief   a light in unit space, as used by the slice shaders
 */
struct LightSource
{
  vtkLight* Light = nullptr;
  /// The light if it is projective, otherwise null.
  vtkProjectiveLight* Projective = nullptr;

  bool IsPositional = false;
  /// Position of a positional light.
  glm::dvec3 Position{ 0.0, 0.0, 0.0 };
  /// Unit vector: the direction of a directional light, or the axis of a positional light.
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 };

  /// Colors multiplied by the intensity.
  glm::dvec3 Ambient{ 0.0, 0.0, 0.0 };
  glm::dvec3 Diffuse{ 1.0, 1.0, 1.0 };
  glm::dvec3 Specular{ 1.0, 1.0, 1.0 };

  /// Cosine of the cone's half angle, or -1 without a cone, and exponent of the falloff toward the
  /// cone's edge.
  double ConeCosine = -1.0;
  double Exponent = 0.0;
  /// Coefficients a, b, c of the attenuation 1 / (a + b d + c d^2) with the distance d in unit
  /// space; 1, 0, 0 for directional lights.
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };

  /// Fraction of the light that shadows remove, 0 to 1. With 0, the light casts no shadows.
  double ShadowStrength = 0.0;

  /// Matrix from unit space to the screen of a projective light, as in
  /// vtkProjectiveLight::GetScreenMatrix.
  glm::dmat4 ScreenFromUnit{ 0.0 };

  /// The light if it is an area light whose emitter has an extent, otherwise null.
  vtkAreaLight* Area = nullptr;
  /// Width and height of the emitter, as vectors to the right and up: for positional lights in unit
  /// space, for directional lights scaled to an emitter at distance 1.
  std::array<glm::dvec3, 2> EmitterAxes{};

  /// Returns the homogeneous position of the light, or the direction to a directional light and 0.
  glm::dvec4 GetHomogeneousPosition() const
  {
    return this->IsPositional ? glm::dvec4(this->Position, 1.0) : glm::dvec4(-this->Direction, 0.0);
  }
};

}

#endif
