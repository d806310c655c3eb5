// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ShadowCases.h"

#include "Support/Images/CameraSettings.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

namespace reference
{

vtkSmartPointer<vtkImageData> MakeImage(
  const std::array<int, 3>& cells, const Double3& spacing, const Field& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  image->SetSpacing(spacing.data());
  image->SetOrigin(
    -0.5 * cells[0] * spacing[0], -0.5 * cells[1] * spacing[1], -0.5 * cells[2] * spacing[2]);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i)
      {
        values->InsertNextValue(field({ { static_cast<double>(i) / cells[0],
          static_cast<double>(j) / cells[1], static_cast<double>(k) / cells[2] } }));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkImageData> MakeImage(int cells, const Field& field, const Double3& center)
{
  const double h = 1.0 / cells;
  auto image = MakeImage({ { cells, cells, cells } }, { { h, h, h } }, field);
  image->SetOrigin(center[0] - 0.5, center[1] - 0.5, center[2] - 0.5);
  return image;
}

Field MakeSphere(double inner, double outer)
{
  return [=](const Double3& x)
  {
    const double r2 =
      (x[0] - 0.5) * (x[0] - 0.5) + (x[1] - 0.5) * (x[1] - 0.5) + (x[2] - 0.5) * (x[2] - 0.5);
    const double density = (outer * outer - r2) / (outer * outer - inner * inner);
    return vtkMath::ClampValue(density, 0.0, 1.0);
  };
}

double TwoBoxes(const Double3& x)
{
  constexpr double edge = 0.08;
  const auto box = [&](const Double3& midpoint, const Double3& half)
  {
    double inside = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside = std::min(inside, (half[axis] - std::abs(x[axis] - midpoint[axis])) / edge);
    }
    return std::max(inside, 0.0);
  };
  return std::max(box({ { 0.3, 0.7, 0.7 } }, { { 0.17, 0.17, 0.17 } }),
    box({ { 0.6, 0.35, 0.4 } }, { { 0.3, 0.15, 0.3 } }));
}

vtkSmartPointer<vtkLight> MakeDirectionalLight(const Double3& direction)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(-direction[0], -direction[1], -direction[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(0.8);
  return light;
}

vtkSmartPointer<vtkLight> MakePositionalLight(const Double3& position)
{
  auto light = MakeDirectionalLight({ { -position[0], -position[1], -position[2] } });
  light->PositionalOn();
  light->SetConeAngle(180.0);
  return light;
}

vtkSmartPointer<vtkCamera> LookAt(
  vtkImageData* image, const Double3& direction, bool parallel, vtkMatrix4x4* matrix)
{
  double ends[2][4] = { { 0.0, 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0, 1.0 } };
  const double* bounds = image->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    ends[0][axis] = bounds[2 * axis];
    ends[1][axis] = bounds[2 * axis + 1];
  }
  for (auto& end : ends)
  {
    if (matrix)
    {
      matrix->MultiplyPoint(end, end);
    }
  }
  Double3 midpoint;
  for (int axis = 0; axis < 3; ++axis)
  {
    midpoint[axis] = 0.5 * (ends[0][axis] + ends[1][axis]);
  }
  const double radius = 0.5 * std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1]));
  return LookAt(midpoint, radius, direction, parallel);
}

vtkSmartPointer<vtkVolumeProperty> MakeTranslucentProperty(double opacity, bool shade)
{
  auto property = MakeProperty(
    { { 0.0, { { 0.2, 0.3, 0.9 } }, 0.0 }, { 1.0, { { 0.9, 0.7, 0.4 } }, opacity } }, 0.1);
  property->SetShade(shade ? 1 : 0);
  property->SetAmbient(0.15);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.3);
  property->SetSpecularPower(12.0);
  return property;
}

ShadowScene MakeScene(vtkImageData* image, vtkVolumeProperty* property)
{
  ShadowScene scene;
  scene.Image = image;
  scene.Property = property;
  scene.Lights = { MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }) };
  scene.Camera = LookAt(image, { { -0.3, -0.4, -1.0 } }, false);
  return scene;
}

ShadowScene MakeHomogeneousScene(int cells, double extinction)
{
  auto property = MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, 0.0 },
    { 1.0, { { 1.0, 1.0, 1.0 } }, -std::expm1(-extinction) } });
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  auto scene = MakeScene(MakeImage(cells, [](const Double3&) { return 1.0; }), property);
  scene.Lights[0]->SetIntensity(1.0);
  return scene;
}

}
