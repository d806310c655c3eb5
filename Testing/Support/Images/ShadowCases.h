// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowCases_h
#define ShadowCases_h

#include "Support/Images/ShadowScene.h"

#include <functional>

/**
 * Test scenes with shadows.
 */
namespace reference
{

/// A function of position in the unit cube.
using Field = std::function<double(const Double3&)>;

/// Returns an image of the unit cube around \a center, with cells^3 voxels and samples at their
/// corners. The double array has the values of \a field, whose argument is in [0, 1]^3 regardless
/// of \a center.
vtkSmartPointer<vtkImageData> MakeImage(
  int cells, const Field& field, const Double3& center = { { 0.0, 0.0, 0.0 } });
/// Returns an image centered at the origin, with the given number and size of voxels along each
/// axis.
vtkSmartPointer<vtkImageData> MakeImage(
  const std::array<int, 3>& cells, const Double3& spacing, const Field& field);

/// Returns the density of equation 2.7 of C. Zhang's dissertation: 1 within radius \a inner of the
/// center of the unit cube, 0 outside radius \a outer.
Field MakeSphere(double inner, double outer);
/// Returns the density of two boxes, which rises from 0 at their faces to 1 inside. In light along
/// (1, -1, -1), one box casts a shadow on the other.
double TwoBoxes(const Double3& x);

/// Returns a white directional light along \a direction with intensity 0.8.
vtkSmartPointer<vtkLight> MakeDirectionalLight(const Double3& direction);
/// Returns a light at \a position that points toward the origin, with intensity 0.8, without a cone
/// or attenuation.
vtkSmartPointer<vtkLight> MakePositionalLight(const Double3& position);

/// Returns a camera that looks along \a direction at the center of the image. The image fills most
/// of a square viewport.
vtkSmartPointer<vtkCamera> LookAt(
  vtkImageData* image, const Double3& direction, bool parallel, vtkMatrix4x4* matrix = nullptr);

/// Returns a property for scalars in [0, 1], with a color ramp. The opacity over a distance of 0.1
/// rises linearly from 0 to \a opacity. The ambient, diffuse and specular coefficients are 0.15,
/// 0.8 and 0.3.
vtkSmartPointer<vtkVolumeProperty> MakeTranslucentProperty(double opacity, bool shade);

/// Returns a scene with the image, light along (1, -1, -1) and a perspective view along (-0.3,
/// -0.4, -1), rendered at 64 x 64 pixels.
ShadowScene MakeScene(vtkImageData* image, vtkVolumeProperty* property);

/// Returns a homogeneous white cube with the given extinction per unit length and with ambient and
/// diffuse coefficients of 0 and 1.
ShadowScene MakeHomogeneousScene(int cells, double extinction);

}

#endif
