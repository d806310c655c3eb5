// SPDX-License-Identifier: BSD-3-Clause
// Checks the reference renderer for shadows by closed forms of homogeneous and linear media, by
// formulas of lights and gradients, and by refining its steps.
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceLightSource.h"
#include "Support/Images/ReferenceMedium.h"
#include "Support/Images/ReferenceShadow.h"
#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace
{

using namespace reference;

constexpr double Bound = 1e-6;
constexpr double Tau = 3.0;
/// Row and column of the center pixel of a 5 x 5 image. The pixel's view ray crosses the full cube.
constexpr int Center = 2;

/// Returns the homogeneous cube seen along -z and lit along \a light.
ShadowScene FacingScene(const Double3& light)
{
  ShadowScene scene = MakeHomogeneousScene(4, Tau);
  scene.Size = { { 5, 5 } };
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  const double intensity = scene.Lights[0]->GetIntensity();
  scene.Lights = { MakeDirectionalLight(light) };
  scene.Lights[0]->SetIntensity(intensity);
  return scene;
}

void ExpectCenter(Check& check, const ShadowScene& scene, const Double3& seen, double alpha,
  const std::string& what)
{
  const RgbaImage rendered = MakeShadowImage(scene);
  const double* pixel = rendered.At(Center, Center);
  for (int k = 0; k < 3; ++k)
  {
    check.Near(pixel[k], seen[k], Bound, what + ", channel " + std::to_string(k), 1.0);
  }
  check.Near(pixel[3], alpha, Bound, what + ", alpha", 1.0);
}

Double3 Gray(double value)
{
  return { { value, value, value } };
}

void TestHomogeneous(Check& check)
{
  const double alpha = -std::expm1(-Tau);
  const double along = -0.5 * std::expm1(-2.0 * Tau);
  const double against = Tau * std::exp(-Tau);
  const double across = std::exp(-0.5 * Tau) * alpha;
  auto scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  ExpectCenter(check, scene, Gray(along), alpha, "light along the view");
  scene.Lights[0]->SetShadowAttenuation(0.25);
  ExpectCenter(
    check, scene, Gray(0.75 * alpha + 0.25 * along), alpha, "a quarter of the shadow strength");
  ExpectCenter(
    check, FacingScene({ { 0.0, 0.0, 1.0 } }), Gray(against), alpha, "light against the view");
  ExpectCenter(
    check, FacingScene({ { 1.0, 0.0, 0.0 } }), Gray(across), alpha, "light across the view");

  scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  scene.Lights.push_back(MakeDirectionalLight({ { 0.0, 0.0, 1.0 } }));
  scene.Lights[1]->SetIntensity(0.5);
  scene.Property->SetAmbient(0.25);
  ExpectCenter(
    check, scene, Gray(0.25 * alpha + along + 0.5 * against), alpha, "two lights and ambient");

  scene = FacingScene({ { 1.0, 0.0, 0.0 } });
  scene.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  scene.TransmissionColor->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  ExpectCenter(check, scene, { { alpha, std::exp(-0.25 * Tau) * alpha, across } }, alpha,
    "colored transmission");

  scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  scene.Shadows = false;
  ExpectCenter(check, scene, Gray(alpha), alpha, "no shadows");

  // An opaque surface halfway through the cube, lit from the front.
  scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  scene.OpaqueDistance.assign(25, scene.Camera->GetDistance());
  ExpectCenter(
    check, scene, Gray(-0.5 * std::expm1(-Tau)), -std::expm1(-0.5 * Tau), "opaque surface");
}

void TestCuts(Check& check)
{
  // Only the part z < 0.1 of the cube remains. The cut lies between two layers of image points.
  const double length = 0.6;
  const double alpha = -std::expm1(-Tau * length);
  const double along = -0.5 * std::expm1(-2.0 * Tau * length);
  auto scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  scene.CroppingPlanes = { { -0.5, 0.5, -0.5, 0.5, -0.6, 0.1 } };
  scene.CroppingFlags = 0x2000;
  ExpectCenter(check, scene, Gray(along), alpha, "cropped to a subvolume");
  scene.CroppingFlags = ~0x2000 & 0x7ffffff;
  ExpectCenter(check, scene, Gray(-0.5 * std::expm1(-2.0 * Tau * 0.4)), -std::expm1(-Tau * 0.4),
    "everything except the subvolume");
  scene.CroppingFlags = 0;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.1);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene.ClippingPlanes = { plane.Get() };
  ExpectCenter(check, scene, Gray(along), alpha, "clipped");
}

/// At distance t from the front face, the opacity is s t per unit distance of 0.2. The optical
/// depth is the integral of -ln(1 - s t) / 0.2.
void TestLinear(Check& check)
{
  const double s = 0.9;
  auto scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  scene.Image = MakeImage(8, [](const Double3& x) { return 1.0 - x[2]; });
  scene.Property =
    MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, 0.0 }, { 1.0, { { 1.0, 1.0, 1.0 } }, s } }, 0.2);
  const ReferenceMedium medium(scene);
  for (double z : { 0.5, 0.3, 0.05, -0.2, -0.5 })
  {
    const double u = s * (0.5 - z);
    const double depth = ((1.0 - u) * std::log1p(-u) + u) / s / 0.2;
    const Double3 found =
      GetOpticalDepth(medium, { { 0.1, 0.2, z } }, { { 0.0, 0.0, 1.0 } }, 10.0, 4);
    check.Near(found[1], depth, 1e-5, "depth of a linear medium", 1.0);
  }
  // With the optical depth as the integration variable, alpha and light have the same form as for
  // the homogeneous cube.
  const double total = ((1.0 - s) * std::log1p(-s) + s) / s / 0.2;
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  const RgbaImage rendered = MakeShadowImage(scene, 2);
  check.Near(rendered.At(Center, Center)[3], -std::expm1(-total), 1e-5, "linear, alpha");
  check.Near(
    rendered.At(Center, Center)[0], -0.5 * std::expm1(-2.0 * total), 1e-5, "linear, light");
}

/// The opacity is constant, and the values increase linearly, so that all normals are equal.
void TestShading(Check& check)
{
  const Double3 slope = { { 0.0, 0.6, -0.8 } };
  auto scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  scene.Image =
    MakeImage(8, [&](const Double3& x) { return vtkMath::Dot(slope.data(), x.data()); });
  const Double3 half = { { 0.5, 0.4, 0.3 } };
  scene.Property = MakeProperty({ { 0.0, half, -std::expm1(-Tau) } });
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.2);
  scene.Property->SetDiffuse(0.7);
  scene.Property->SetSpecular(0.4);
  scene.Property->SetSpecularPower(3.0);
  scene.Lights[0]->SetDiffuseColor(1.0, 0.5, 0.25);
  scene.Lights[0]->SetSpecularColor(0.2, 0.4, 0.6);
  scene.Lights[0]->SetAmbientColor(0.5, 1.0, 0.0);
  const double alpha = -std::expm1(-Tau);
  const double along = -0.5 * std::expm1(-2.0 * Tau);
  // Normal (0, -0.6, 0.8), light and camera at +z: N.L = 0.8, R = (0, -0.96, 0.28), E.R = 0.28. The
  // bound is loose, because the view ray crosses the front and back boundaries, where gradients
  // change.
  const double glint = std::pow(0.28, 3.0);
  const RgbaImage rendered = MakeShadowImage(scene);
  for (int k = 0; k < 3; ++k)
  {
    const double diffuse = scene.Lights[0]->GetDiffuseColor()[k];
    const double seen = half[k] * 0.2 * scene.Lights[0]->GetAmbientColor()[k] * alpha +
      (half[k] * 0.7 * diffuse * 0.8 + 0.4 * scene.Lights[0]->GetSpecularColor()[k] * glint) *
        along;
    check.Near(rendered.At(Center, Center)[k], seen, 0.02, "shaded", 1.0);
  }
  // Without gradients, scattering is isotropic and there is no specular term.
  scene.Image = MakeImage(4, [](const Double3&) { return 1.0; });
  Double3 even;
  for (int k = 0; k < 3; ++k)
  {
    even[k] = half[k] *
      (0.2 * scene.Lights[0]->GetAmbientColor()[k] * alpha +
        0.7 * scene.Lights[0]->GetDiffuseColor()[k] * along);
  }
  ExpectCenter(check, scene, even, alpha, "shaded without gradient");
}

void TestGradient(Check& check)
{
  // The image values are g.x in world coordinates. The image has anisotropic spacing and permuted
  // axes, and the volume is scaled.
  const Double3 g = { { 0.3, -0.7, 1.1 } };
  auto image =
    MakeImage({ { 4, 5, 6 } }, { { 0.1, 0.3, 0.2 } }, [](const Double3&) { return 0.0; });
  image->SetDirectionMatrix(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2.0);
  matrix->SetElement(1, 1, 0.5);
  matrix->SetElement(1, 3, 7.0);
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    image->GetPoint(id, x);
    matrix->MultiplyPoint(x, x);
    image->GetPointData()->GetScalars()->SetComponent(id, 0, vtkMath::Dot(g.data(), x));
  }
  const ImageInterpolator found(image, {}, matrix);
  const Double3 inside = { { 1.3, 2.4, 3.5 } };
  const Double3 gradient = found.GetGradient(inside, 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    check.Near(gradient[axis], g[axis], 1e-12, "gradient in world coordinates", 1.0);
  }
  double x[4] = { 0.0, 0.0, 0.0, 1.0 };
  image->TransformContinuousIndexToPhysicalPoint(inside.data(), x);
  matrix->MultiplyPoint(x, x);
  check.Near(
    found.At(inside).Values[0], vtkMath::Dot(g.data(), x), 1e-12, "interpolated value", 1.0);
  const IndexLine line = found.ToIndex({ { x[0], x[1], x[2] } }, { { 1.0, 0.0, 0.0 } });
  for (int axis = 0; axis < 3; ++axis)
  {
    check.Near(line.Begin[axis], inside[axis], 1e-12, "index of a world point", 1.0);
  }
}

void TestLights(Check& check)
{
  auto light = MakePositionalLight({ { 0.0, 0.0, 2.0 } });
  light->SetIntensity(0.5);
  light->SetDiffuseColor(1.0, 0.5, 0.0);
  light->SetAttenuationValues(1.0, 0.5, 0.25);
  auto arrival = ReferenceLightSource(light).At({ { 0.0, 0.0, 0.0 } });
  check.Near(arrival.Diffuse[0], 0.5 / 3.0, 1e-12, "fall-off");
  check.Near(arrival.Diffuse[1], 0.25 / 3.0, 1e-12, "fall-off of the green channel");
  check.Near(arrival.Distance, 2.0, 1e-12, "distance");
  check.Near(arrival.ToLight[2], 1.0, 1e-12, "direction");
  light->SetAttenuationValues(1.0, 0.0, 0.0);
  light->SetConeAngle(30.0);
  light->SetExponent(4.0);
  const double angle = vtkMath::RadiansFromDegrees(29.0);
  const Double3 inside = { { 2.0 * std::tan(angle), 0.0, 0.0 } };
  check.Near(ReferenceLightSource(light).At(inside).Diffuse[0],
    0.5 * std::pow(std::cos(angle), 4.0), 1e-12, "inside the cone");
  const Double3 outside = { { 2.0 * std::tan(vtkMath::RadiansFromDegrees(31.0)), 0.0, 0.0 } };
  check.Near(ReferenceLightSource(light).At(outside).Diffuse[0], 0.0, 0.0, "outside the cone");
}

/// Two components with separate transfer functions. Extinctions add up, and colors are weighted by
/// extinction.
void TestComponents(Check& check)
{
  auto scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(2);
  values->SetNumberOfTuples(scene.Image->GetNumberOfPoints());
  values->FillComponent(0, 0.0);
  values->FillComponent(1, 1.0);
  scene.Image->GetPointData()->SetScalars(values);
  vtkVolumeProperty* property = scene.Property;
  property->GetScalarOpacity(0)->RemoveAllPoints();
  property->GetScalarOpacity(0)->AddPoint(0.0, -std::expm1(-1.0));
  property->GetScalarOpacity(1)->RemoveAllPoints();
  property->GetScalarOpacity(1)->AddPoint(1.0, -std::expm1(-4.0));
  property->SetComponentWeight(1, 0.5);
  property->GetRGBTransferFunction(0)->RemoveAllPoints();
  property->GetRGBTransferFunction(0)->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  property->GetRGBTransferFunction(1)->RemoveAllPoints();
  property->GetRGBTransferFunction(1)->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  property->SetDiffuse(1, 1.0);
  property->SetAmbient(1, 0.0);
  const double along = -0.5 * std::expm1(-2.0 * Tau);
  ExpectCenter(check, scene, { { along / 3.0, along * 2.0 / 3.0, 0.0 } }, -std::expm1(-Tau),
    "two independent components");
  property->IndependentComponentsOff();
  // The first component determines the color, and the second component determines the opacity, with
  // the first opacity function.
  property->GetScalarOpacity(0)->AddPoint(1.0, -std::expm1(-Tau));
  ExpectCenter(
    check, scene, { { along, 0.0, 0.0 } }, -std::expm1(-Tau), "two dependent components");
}

/// Sets one layer of image points to NaN. The extinction decreases linearly to zero over the
/// adjacent layer of cells.
void TestNan(Check& check)
{
  auto scene = FacingScene({ { 0.0, 0.0, -1.0 } });
  vtkDataArray* values = scene.Image->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < 25; ++id)
  {
    values->SetComponent(id, 0, std::numeric_limits<double>::quiet_NaN());
  }
  // Half of the optical depth of one of four layers of cells remains.
  const double depth = Tau * (1.0 - 0.125);
  ExpectCenter(check, scene, Gray(-0.5 * std::expm1(-2.0 * depth)), -std::expm1(-depth), "NaN");
}

void TestRefinement(Check& check)
{
  for (double opacity : { 0.3, 0.999 })
  {
    for (bool shade : { false, true })
    {
      auto scene =
        MakeScene(MakeImage(16, MakeSphere(0.2, 0.45)), MakeTranslucentProperty(opacity, shade));
      scene.Size = { { 24, 24 } };
      scene.Lights.push_back(MakePositionalLight({ { 0.7, 0.8, 0.9 } }));
      const ImageError error = CompareImages(MakeShadowImage(scene), MakeShadowImage(scene, 3));
      std::cout << "opacity " << opacity << ", shade " << shade << ": " << error << '\n';
      check.Near(error.Max, 0.0, 1e-3, "a third of the step size", 1.0);
      check.Near(error.Mean, 0.0, 1e-4, "a third of the step size, mean", 1.0);
    }
  }
}

}

int TestReferenceShadows(int, char*[])
{
  return RunChecks({ TestHomogeneous, TestCuts, TestLinear, TestShading, TestGradient, TestLights,
    TestComponents, TestNan, TestRefinement });
}
