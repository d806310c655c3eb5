// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceLightSource_h
#define ReferenceLightSource_h

#include "Support/Pictures/ReferenceImage.h" // for points

#include <array>
#include <vector>

class vtkLight;
class vtkMatrix4x4;
class vtkProjectiveLight;

namespace reference
{

/**
 * A point of a light that has an extent.
 */
struct LightPoint
{
  /// In the world; of a directional light the vector, of any length, towards where this point is.
  Double3 Place{};
  /// Times the light's own.
  Double3 Color{ { 1.0, 1.0, 1.0 } };
};

/**
 * @class   ReferenceLightSource
 * @brief   what a vtkLight sends to a place, before anything is in its way
 *
 * Directional, positional with cone and fall-off as VTK's shaders of surfaces have them, and
 * vtkProjectiveLight by its screen's matrix and colour. Position and direction are the transformed
 * ones: headlights and camera lights have to have been placed by their renderer.
 *
 * A light with points lights as the one at its centre does; its shadows are the mean of those that
 * its points cast, by equation 2.13 of the source.
 */
class ReferenceLightSource
{
public:
  explicit ReferenceLightSource(vtkLight* light, const std::vector<LightPoint>& points = {});

  struct Arrival
  {
    /// Length 1.
    Double3 ToLight{};
    /// To where shadows are cast from; infinite for directional lights.
    double Distance = 0.0;
    Double3 Diffuse{};
    Double3 Specular{};
  };

  Arrival At(const Double3& world) const;

  /// A ray that light comes along, and the share of the light's colour that does so.
  struct ShadowRay
  {
    /// Length 1.
    Double3 ToLight{};
    double Distance = 0.0;
    Double3 Share{ { 1.0, 1.0, 1.0 } };
  };
  /// The rays of the points, or the one of the arrival where the light has none.
  std::vector<ShadowRay> GetShadowRays(const Double3& world, const Arrival& arrival) const;
  /// Colour times intensity, everywhere the same.
  const Double3& GetAmbient() const { return this->Ambient; }
  /// How much of the light shadows take; 0 casts none.
  double GetShadowStrength() const { return this->ShadowStrength; }

private:
  Double3 GetShare(const Double3& world, const Arrival& arrival) const;

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
