// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowCases_h
#define ShadowCases_h

#include "Support/Pictures/ShadowScene.h"

#include <functional>

/**
 * What pictures with shadows are tested on.
 */
namespace reference
{

/// A function of position in the unit cube.
using Field = std::function<double(const Double3&)>;

/// cells^3 voxels over the unit cube around \a center, samples at their corners, of one component
/// in double, with the values of \a field at 0 to 1 along each axis.
vtkSmartPointer<vtkImageData> MakeImage(
  int cells, const Field& field, const Double3& center = { { 0.0, 0.0, 0.0 } });
/// The same with so many voxels of a size along each axis, around the origin.
vtkSmartPointer<vtkImageData> MakeImage(
  const std::array<int, 3>& cells, const Double3& spacing, const Field& field);

/// The density of the source's equation 2.7: 1 within \a inner of the middle, 0 beyond \a outer.
Field MakeSphere(double inner, double outer);
/// Two boxes, one in the other's shadow for light along (1, -1, -1), with soft sides.
double TwoBoxes(const Double3& x);

/// Directional, white, going along \a direction; of intensity 0.8.
vtkSmartPointer<vtkLight> MakeDirectionalLight(const Double3& direction);
/// Positional, without cone and fall-off, shining towards the origin; of intensity 0.8.
vtkSmartPointer<vtkLight> MakePositionalLight(const Double3& position);

/// A camera that looks along \a direction at the middle of the image, which fills most of a square
/// picture.
vtkSmartPointer<vtkCamera> LookAt(
  vtkImageData* image, const Double3& direction, bool parallel, vtkMatrix4x4* matrix = nullptr);

/// One component from 0 to 1 in two colours, of an extinction that grows as -ln(1 - x opacity) to
/// the given opacity in a tenth of a unit; ambient 0.15, diffuse 0.8, specular 0.3.
vtkSmartPointer<vtkVolumeProperty> MakeSoftProperty(double opacity, bool shade);

/// The picture of 64^2 of an image that is lit by a light along (1, -1, -1) and looked at along
/// (-0.3, -0.4, -1) in perspective.
ShadowScene MakeScene(vtkImageData* image, vtkVolumeProperty* property);

/// A homogeneous cube of an extinction per unit, grey of 1, ambient 0 and diffuse 1.
ShadowScene MakeHomogeneousScene(int cells, double extinction);

}

#endif
