// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowCases_h
#define ShadowCases_h

#include "Support/Images/ShadowScene.h"

#include <functional>

/**
 * Scenes for renderings with shadows.
 */
namespace reference
{

/// A function of position in the unit cube.
using Field = std::function<double(const Double3&)>;

/// Returns an image of cells^3 voxels over the unit cube around \a center, with samples at the
/// corners. The one-component double array has the values of \a field, whose argument is from 0 to
/// 1 along each axis.
vtkSmartPointer<vtkImageData> MakeImage(
  int cells, const Field& field, const Double3& center = { { 0.0, 0.0, 0.0 } });
/// Returns an image with the given numbers and sizes of voxels, centered at the origin.
vtkSmartPointer<vtkImageData> MakeImage(
  const std::array<int, 3>& cells, const Double3& spacing, const Field& field);

/// Returns the density of equation 2.7 of C. Zhang's dissertation: 1 within the radius \a inner of
/// the center, 0 outside \a outer.
Field MakeSphere(double inner, double outer);
/// Returns the density of two boxes whose density rises from 0 at their faces to 1 inside. With
/// light along (1, -1, -1), one box shades the other.
double TwoBoxes(const Double3& x);

/// Returns a white directional light along \a direction with intensity 0.8.
vtkSmartPointer<vtkLight> MakeDirectionalLight(const Double3& direction);
/// Returns a light at \a position that points toward the origin, with intensity 0.8, without cone
/// and attenuation.
vtkSmartPointer<vtkLight> MakePositionalLight(const Double3& position);

/// Returns a camera that looks along \a direction at the center of the image, which fills most of a
/// square rendering.
vtkSmartPointer<vtkCamera> LookAt(
  vtkImageData* image, const Double3& direction, bool parallel, vtkMatrix4x4* matrix = nullptr);

/// Returns a property for scalars from 0 to 1, with a color ramp. The opacity per tenth of a unit
/// rises to \a opacity. The ambient, diffuse and specular coefficients are 0.15, 0.8 and 0.3.
vtkSmartPointer<vtkVolumeProperty> MakeSoftProperty(double opacity, bool shade);

/// Returns a scene of an image with light along (1, -1, -1) and a perspective view along (-0.3,
/// -0.4, -1), rendered with 64^2 pixels.
ShadowScene MakeScene(vtkImageData* image, vtkVolumeProperty* property);

/// Returns a homogeneous white cube with the given extinction per unit length, ambient 0 and
/// diffuse 1.
ShadowScene MakeHomogeneousScene(int cells, double extinction);

}

#endif
