// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Shadows/ShadowsScene.h"

#include "Support/Inputs/DataFiles.h"

#include "vtkConstructiveModelSource.h"
#include "vtkConstructiveVolume.h"
#include "vtkSpatialObject.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkExtractVOI.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace shadows
{
namespace
{
using reference::Double3;

struct Node
{
  double Value;
  Double3 Color;
  double Opacity;
};

/// Returns a property whose ScalarOpacityUnitDistance is \a unit.
vtkSmartPointer<vtkVolumeProperty> MakeProperty(const std::vector<Node>& nodes, double unit)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const Node& node : nodes)
  {
    color->AddRGBPoint(node.Value, node.Color[0], node.Color[1], node.Color[2]);
    opacity->AddPoint(node.Value, node.Opacity);
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.15);
  property->SetDiffuse(0.85);
  property->SetSpecular(0.2);
  property->SetSpecularPower(20.0);
  return property;
}

/// Returns a perspective camera that looks at the center of \a image. A cube of edge length \a edge
/// around that center nearly fills the view.
vtkSmartPointer<vtkCamera> MakeCamera(
  vtkImageData* image, const Double3& direction, const Double3& viewUp, double edge)
{
  constexpr double angle = 30.0;
  double center[3];
  image->GetCenter(center);
  const double distance = 0.75 * edge / std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
  const double length = vtkMath::Norm(direction.data());
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] - distance / length * direction[0],
    center[1] - distance / length * direction[1], center[2] - distance / length * direction[2]);
  camera->SetViewUp(viewUp.data());
  camera->SetViewAngle(angle);
  const double radius = 0.5 * image->GetLength();
  camera->SetClippingRange(
    std::max(distance - 1.1 * radius, 0.05 * distance), distance + 1.1 * radius);
  return camera;
}

reference::ShadowScene MakeScene(
  vtkImageData* image, vtkVolumeProperty* property, vtkCamera* camera)
{
  reference::ShadowScene scene;
  scene.Image = image;
  scene.Property = property;
  scene.Camera = camera;
  scene.Size = { { 512, 512 } };
  scene.Lights = MakeLights(scene, 1);
  return scene;
}

/// Samples \a model on points^3 points of the cube [-half, half]^3.
vtkSmartPointer<vtkImageData> Sample(vtkSpatialObject* model, int points, double half)
{
  vtkNew<vtkConstructiveVolume> volume;
  volume->SetRoot(model);
  volume->SetDimensions(points, points, points);
  volume->SetBounds(-half, half, -half, half, -half, half);
  volume->SetNumberOfSubsamples(2);
  volume->Update();
  return volume->GetOutput();
}

/// Returns a directional light. Its direction is given by its forward, right and up components in
/// the camera's coordinate system.
vtkSmartPointer<vtkLight> MakeLight(
  const reference::ShadowScene& scene, double forward, double right, double up, double intensity)
{
  Double3 view;
  Double3 above;
  Double3 rightward;
  scene.Camera->GetDirectionOfProjection(view.data());
  vtkMath::Cross(view.data(), scene.Camera->GetViewUp(), rightward.data());
  vtkMath::Normalize(rightward.data());
  vtkMath::Cross(rightward.data(), view.data(), above.data());
  Double3 position;
  for (int k = 0; k < 3; ++k)
  {
    position[k] = -(forward * view[k] + right * rightward[k] + up * above[k]);
  }
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  return light;
}
}

Case MakeBonsai(int stepXY, int stepZ)
{
  auto full = interlume::ReadData("bonsai.vti");
  vtkNew<vtkExtractVOI> subsample;
  subsample->SetInputData(full);
  subsample->SetVOI(vtkImageData::SafeDownCast(full)->GetExtent());
  subsample->SetSampleRate(stepXY, stepXY, stepZ);
  subsample->Update();
  vtkImageData* image = subsample->GetOutput();
  if (image->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("The file bonsai.vti contains no points");
  }
  const int* size = image->GetDimensions();
  Case made;
  made.Name = "bonsai-" + std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" +
    std::to_string(size[2]);
  auto property = MakeProperty(
    { { 35.0, { { 0.25, 0.5, 0.2 } }, 0.0 }, { 65.0, { { 0.35, 0.6, 0.25 } }, 0.9 },
      { 110.0, { { 0.65, 0.45, 0.3 } }, 0.9 }, { 255.0, { { 0.85, 0.75, 0.6 } }, 0.9 } },
    stepXY);
  made.Scene = MakeScene(
    image, property, MakeCamera(image, { { 0.3, -0.35, -1.0 } }, { { 0.0, 1.0, 0.0 } }, 256.0));
  return made;
}

Case MakeSphere(int points)
{
  Case made;
  made.Name = "sphere-" + std::to_string(points);
  auto image = Sample(
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::FUZZY_SPHERE), points, 0.52);
  const Double3 color{ { 0.9, 0.8, 0.7 } };
  auto property = MakeProperty({ { 0.0, color, 0.0 }, { 1.0, color, -std::expm1(-0.6) } }, 0.1);
  made.Scene = MakeScene(
    image, property, MakeCamera(image, { { -0.3, -0.4, -1.0 } }, { { 0.0, 1.0, 0.0 } }, 1.04));
  return made;
}

Case MakeRings(int points)
{
  Case made;
  made.Name = "rings-" + std::to_string(points);
  auto image =
    Sample(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::RINGS), points, 1.0);
  const Double3 color{ { 0.8, 0.6, 0.35 } };
  auto property = MakeProperty({ { 0.0, color, 0.0 }, { 1.0, color, 0.8 } }, 2.0 / points);
  made.Scene = MakeScene(
    image, property, MakeCamera(image, { { 0.2, 0.8, -0.8 } }, { { 0.0, 0.0, 1.0 } }, 2.0));
  return made;
}

Case MakeSmoke(int points)
{
  Case made;
  made.Name = "smoke-" + std::to_string(points);
  auto image =
    Sample(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::HYPERTEXTURE_SPHERE),
      points, 0.75);
  const Double3 color{ { 0.8, 0.8, 0.85 } };
  auto property = MakeProperty({ { 0.0, color, 0.0 }, { 1.0, color, 0.5 } }, 0.1);
  made.Scene = MakeScene(
    image, property, MakeCamera(image, { { -0.3, -0.4, -1.0 } }, { { 0.0, 1.0, 0.0 } }, 1.3));
  return made;
}

Case MakeBox(int points)
{
  Case made;
  made.Name = "box-" + std::to_string(points);
  vtkNew<vtkImageData> image;
  image->SetDimensions(points, points, points);
  const double spacing = 2.0 / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  // Returns the occupancy (0 to 1) of a box at a point. It falls linearly from 1 to 0 over two
  // voxels at the surface of the box.
  const auto occupancy = [&](const double x[3], const Double3& center, const Double3& half)
  {
    double value = 1.0;
    for (int k = 0; k < 3; ++k)
    {
      const double depth = (half[k] - std::abs(x[k] - center[k])) / (2.0 * spacing) + 0.5;
      value = std::min(value, std::max(depth, 0.0));
    }
    return value;
  };
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    values[i] = static_cast<float>(
      std::max(2.0 * occupancy(x, { { 0.1, 0.0, 0.5 } }, { { 0.3, 0.25, 0.15 } }),
        occupancy(x, { { 0.0, 0.0, -0.45 } }, { { 0.9, 0.9, 0.4 } })));
  }
  const Double3 glass{ { 0.75, 0.8, 0.85 } };
  const Double3 blue{ { 0.25, 0.35, 0.8 } };
  auto property =
    MakeProperty({ { 0.0, glass, 0.0 }, { 1.0, glass, 0.04 }, { 2.0, blue, 0.9 } }, 2.0 / points);
  made.Scene = MakeScene(
    image, property, MakeCamera(image, { { 0.2, 0.8, -0.8 } }, { { 0.0, 0.0, 1.0 } }, 2.0));
  return made;
}

std::vector<Case> WithPixels(std::vector<Case> cases, int pixels)
{
  for (Case& one : cases)
  {
    one.Scene.Size = { { pixels, pixels } };
  }
  return cases;
}

Case MakeScatteringCase(const Case& from)
{
  Case made = from;
  made.Scene.Property = vtkSmartPointer<vtkVolumeProperty>::New();
  made.Scene.Property->DeepCopy(from.Scene.Property);
  made.Scene.Property->ShadeOff();
  made.Scene.Property->SetAmbient(0.0);
  made.Scene.Property->SetDiffuse(1.0);
  made.Scene.Property->SetSpecular(0.0);
  return made;
}

Lights MakeLights(const reference::ShadowScene& scene, int number)
{
  const double directions[8][3] = { { 0.6, 0.55, -0.6 }, { 0.7, -0.6, -0.4 }, { 0.8, 0.1, -0.6 },
    { 0.9, -0.2, 0.4 }, { 0.7, 0.5, 0.5 }, { 0.8, -0.6, 0.1 }, { 0.8, 0.6, -0.1 },
    { 0.7, -0.4, 0.6 } };
  Lights lights;
  for (int i = 0; i < number; ++i)
  {
    lights.push_back(
      MakeLight(scene, directions[i][0], directions[i][1], directions[i][2], 1.0 / number));
  }
  return lights;
}

Lights MakeAreaLights(const reference::ShadowScene& scene, double size)
{
  const vtkSmartPointer<vtkLight> parallel = MakeLights(scene, 1).front();
  const double length = scene.Image->GetLength();
  double direction[3];
  parallel->GetPosition(direction);
  vtkMath::Normalize(direction);
  double center[3];
  scene.Image->GetCenter(center);
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(90.0);
  light->SetFocalPoint(center);
  light->SetPosition(center[0] + 1.5 * length * direction[0],
    center[1] + 1.5 * length * direction[1], center[2] + 1.5 * length * direction[2]);
  light->SetSize(size * length, size * length);
  return { light };
}
}
