// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceLightSource_h
#define ReferenceLightSource_h

#include "Support/Images/ImageInterpolator.h" // for points

#include <array>
#include <vector>

class vtkLight;
class vtkMatrix4x4;
class vtkProjectiveLight;

namespace reference
{

/**
 * A sample point of an area light.
 */
struct LightPoint
{
  /// World position. For a directional light, a vector of any length toward this point.
  Double3 Position{};
  /// Factor applied to the light's color.
  Double3 Color{ { 1.0, 1.0, 1.0 } };
};

/**
 * @class   ReferenceLightSource
 * @brief   unoccluded light of a vtkLight at a point
 *
 * Supports directional lights, positional lights with cone and attenuation as in VTK's surface
 * shaders, and vtkProjectiveLight with its screen matrix and color. The transformed position and
 * direction are used, so the renderer must have updated headlights and camera lights.
 *
 * Sample points affect only the shadow, which is the mean of the shadows cast by light from the
 * points (equation 2.13 of C. Zhang's dissertation). The unoccluded light is that of a point light
 * at the position of the vtkLight.
 */
class ReferenceLightSource
{
public:
  explicit ReferenceLightSource(vtkLight* light, const std::vector<LightPoint>& points = {});

  struct Arrival
  {
    /// Unit vector toward the light.
    Double3 ToLight{};
    /// Distance to the light, infinite for directional lights.
    double Distance = 0.0;
    Double3 Diffuse{};
    Double3 Specular{};
  };

  Arrival At(const Double3& world) const;

  /// A ray toward the light, and its fraction of the light's color.
  struct ShadowRay
  {
    /// Unit vector toward the light.
    Double3 ToLight{};
    double Distance = 0.0;
    Double3 Fraction{ { 1.0, 1.0, 1.0 } };
  };
  /// Returns the rays to all sample points. Without sample points, returns one ray in the direction
  /// of \a arrival.
  std::vector<ShadowRay> GetShadowRays(const Double3& world, const Arrival& arrival) const;
  /// Returns the ambient color times the intensity, which is the same everywhere.
  const Double3& GetAmbient() const { return this->Ambient; }
  /// Returns the fraction of light removed in shadow. The light casts no shadow if this is 0.
  double GetShadowStrength() const { return this->ShadowStrength; }

private:
  Double3 GetReceivedFraction(const Double3& world, const Arrival& arrival) const;

  bool IsPositional = false;
  Double3 Position{};
  Double3 Direction{};
  Double3 Ambient{};
  Double3 Diffuse{};
  Double3 Specular{};
  double ConeCosine = -1.0;
  double Exponent = 0.0;
  Double3 FallOff{ { 1.0, 0.0, 0.0 } };
  double ShadowStrength = 0.0;
  std::vector<LightPoint> Points;
  vtkProjectiveLight* Projective = nullptr;
  std::array<double, 16> ScreenFromWorld{};
};

}

#endif
