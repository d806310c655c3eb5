// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceLightSource_h
#define ReferenceLightSource_h

#include "Pictures/ReferenceImage.h" // for points

#include <array>

class vtkLight;
class vtkMatrix4x4;
class vtkProjectiveLight;

namespace reference
{

/**
 * @class   ReferenceLightSource
 * @brief   what a vtkLight sends to a place, before anything is in its way
 *
 * Directional, positional with cone and fall-off as VTK's shaders of surfaces have them, and
 * vtkProjectiveLight by its screen's matrix and colour. Position and direction are the transformed
 * ones: headlights and camera lights have to have been placed by their renderer.
 */
class ReferenceLightSource
{
public:
  explicit ReferenceLightSource(vtkLight* light);

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
  vtkProjectiveLight* Projective = nullptr;
  std::array<double, 16> ScreenFromWorld{};
};

}

#endif
