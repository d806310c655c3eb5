#ifndef interlume_LightSource_h
#define interlume_LightSource_h

#include "Common/Vectors.h"
#include <array>

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
  /// Null for all but projective lights.
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

  /// Cosine of the cone's half angle and exponent of the fall-off to its edge; -1 without a cone.
  double ConeCosine = -1.0;
  double Exponent = 0.0;
  /// 1 / (a + b d + c d^2) with d in unit space; 1, 0, 0 for directional lights.
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };

  /// How much of the light shadows take, 0 to 1; 0 casts none.
  double ShadowStrength = 0.0;

  /// For projective lights: rows of the matrix from unit space to the screen, as GetScreenMatrix.
  std::array<double, 16> ScreenFromUnit{};
};

}

#endif
