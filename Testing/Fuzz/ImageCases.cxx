// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "Support/Images/RgbaImage.h"
#include "Support/Images/VolumeStage.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fuzz
{

namespace
{

constexpr int Size = 48;

vtkSmartPointer<vtkVolumeProperty> MakeProperty(FuzzRandom& random)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  const int nodes = random.Integer(1, 5);
  const double end = random.Pick<double>({ 1.0, 4.0, 100.0 });
  for (int i = 0; i < nodes; ++i)
  {
    const double at = random.Chance(0.2) ? 0.5 * end : random.Between(-0.1, 1.1) * end;
    colors->AddRGBPoint(at, random.Unit(), random.Unit(), random.Unit());
    opacities->AddPoint(at, random.Pick<double>({ 0.0, 1.0, random.Unit() }));
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(random.Pick<double>({ 1.0, 0.01, 100.0 }));
  property->SetShade(random.Chance(0.3));
  return property;
}

/// Returns a camera close to the data, far away or inside, oblique or along an axis.
vtkSmartPointer<vtkCamera> MakeCamera(FuzzRandom& random, vtkDataSet* data)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  double center[3];
  data->GetCenter(center);
  double length = data->GetLength();
  length = std::isfinite(length) && length > 0.0 ? length : 1.0;
  double direction[3] = { random.Between(-1.0, 1.0), random.Between(-1.0, 1.0),
    random.Between(0.1, 1.0) };
  if (random.Chance(0.3))
  {
    direction[0] = direction[1] = 0.0;
  }
  const double distance = length * random.Pick<double>({ 0.2, 2.0, 20.0 });
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + distance * direction[0], center[1] + distance * direction[1],
    center[2] + distance * direction[2]);
  camera->SetViewUp(0.0, 1.0, 0.01);
  camera->SetParallelProjection(random.Chance(0.4));
  camera->SetParallelScale(0.6 * length);
  camera->SetClippingRange(1e-3 * length, distance + 10.0 * length);
  return camera;
}

/// Makes the camera sheared or off-axis, or gives it user transforms. Returns a description.
std::string DistortCamera(FuzzRandom& random, vtkCamera* camera)
{
  const double a = random.Between(-0.5, 0.5);
  const double b = random.Between(-0.5, 0.5);
  const double distance = camera->GetDistance();
  double left[3] = { (a - 0.5) * distance, (b - 0.5) * distance, -distance };
  double right[3] = { (a + 0.5) * distance, (b - 0.5) * distance, (a - 1.0) * distance };
  double top[3] = { (a + 0.5) * distance, (b + 0.5) * distance, (a - 1.0) * distance };
  vtkNew<vtkTransform> transform;
  transform->RotateZ(90.0 * a);
  transform->Scale(1.0, 1.0 + b, 1.0);
  const int kind = random.Integer(0, 8);
  switch (kind)
  {
    case 0:
      camera->SetViewShear(a, b, random.Between(0.0, 2.0));
      return "sheared";
    case 1:
      camera->UseOffAxisProjectionOn();
      camera->SetScreenBottomLeft(left);
      camera->SetScreenBottomRight(right);
      camera->SetScreenTopRight(top);
      return "off-axis";
    case 2:
      camera->SetUserTransform(transform);
      return "user transform";
    case 3:
      camera->SetUserViewTransform(transform);
      return "user view transform";
    default:
      return "plain";
  }
}

/// Adds up to three clipping planes.
void AddClippingPlanes(FuzzRandom& random, vtkDataSet* data, vtkPlaneCollection* planes)
{
  const int count = std::max(random.Integer(-2, 3), 0);
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(random.Pick<double>({ 0.0, 1.0, random.Unit() }), random.Between(-1.0, 1.0),
      random.Pick<double>({ 0.0, -1.0, random.Unit() }));
    double point[3];
    if (data->GetNumberOfPoints() > 0 && random.Chance(0.5))
    {
      data->GetPoint(random.Integer(0, static_cast<int>(data->GetNumberOfPoints()) - 1), point);
    }
    else
    {
      data->GetCenter(point);
    }
    plane->SetOrigin(point);
    planes->AddItem(plane);
  }
}

/// Checks that all channels are finite and not negative, and alpha is at most 1.
void CheckImage(
  const reference::RgbaImage& rendered, const std::string& what, reference::Check& check)
{
  bool isFinite = true;
  double maximumAlpha = 0.0;
  double minimum = 0.0;
  for (std::size_t i = 0; i < rendered.Values.size(); ++i)
  {
    isFinite = isFinite && std::isfinite(rendered.Values[i]);
    if (i % 4 == 3)
    {
      maximumAlpha = std::max(maximumAlpha, rendered.Values[i]);
    }
    minimum = std::min(minimum, rendered.Values[i]);
  }
  check.That(isFinite, what + ": all channels are finite");
  check.That(maximumAlpha <= 1.001 && minimum >= -0.001,
    what + ": minimum channel " + std::to_string(minimum) + ", maximum alpha " +
      std::to_string(maximumAlpha));
}

/// Permutes the axes of an image, with or without a reflection.
std::string PermuteAxes(FuzzRandom& random, vtkImageData* image)
{
  if (!random.Chance(0.2))
  {
    return {};
  }
  const double sign = random.Pick<double>({ -1.0, 1.0 });
  image->SetDirectionMatrix(0.0, 0.0, sign, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0);
  return ", permuted axes";
}

/// Sets random cropping regions and clipping planes, which may miss the data.
std::string Cut(FuzzRandom& random, vtkVolumeMapper* mapper, vtkDataSet* data)
{
  const double* bounds = data->GetBounds();
  const auto pick = [&](int axis)
  {
    return bounds[2 * axis] + random.Between(-0.2, 1.2) * (bounds[2 * axis + 1] - bounds[2 * axis]);
  };
  std::string text;
  if (random.Chance(0.3))
  {
    mapper->CroppingOn();
    mapper->SetCroppingRegionPlanes(pick(0), pick(0), pick(1), pick(1), pick(2), pick(2));
    const int flags = random.Pick<int>({ VTK_CROP_SUBVOLUME, random.Integer(0, (1 << 27) - 1) });
    mapper->SetCroppingRegionFlags(flags);
    text += ", cropping " + std::to_string(flags);
  }
  if (random.Chance(0.2))
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(pick(0), pick(1), pick(2));
    plane->SetNormal(random.Between(-1.0, 1.0), random.Between(-1.0, 1.0), 0.5);
    mapper->AddClippingPlane(plane);
    text += ", a clipping plane";
  }
  return text;
}

/// Checks a vtkImageData that shares its array with the previous input, but has permuted
/// dimensions. The frame must equal the frame of a new mapper.
void CheckShared(vtkShadowedSliceMapper* mapper, reference::VolumeStage& stage, vtkImageData* image,
  reference::Check& check)
{
  vtkNew<vtkImageData> shared;
  shared->ShallowCopy(image);
  const int* size = image->GetDimensions();
  shared->SetDimensions(size[2], size[0], size[1]);
  mapper->SetInputData(image);
  stage.Capture();
  mapper->SetInputData(shared);
  const reference::RgbaImage found = stage.Capture();
  mapper->ReleaseGraphicsResources(nullptr);
  vtkNew<vtkShadowedSliceMapper> fresh;
  fresh->SetInputData(shared);
  fresh->SetSoftShadowMethod(mapper->GetSoftShadowMethod());
  fresh->SetScatteringMode(mapper->GetScatteringMode());
  fresh->SetSliceSpacing(mapper->GetSliceSpacing());
  fresh->SetClippingPlanes(mapper->GetClippingPlanes());
  fresh->SetCropping(mapper->GetCropping());
  fresh->SetCroppingRegionPlanes(mapper->GetCroppingRegionPlanes());
  fresh->SetCroppingRegionFlags(mapper->GetCroppingRegionFlags());
  stage.SetVolume(fresh, stage.GetVolume()->GetProperty());
  check.Near(reference::CompareImages(found, stage.Capture()).Max, 0.0, 0.0,
    "difference from a new mapper for a shared array", 1.0);
}

std::vector<vtkSmartPointer<vtkLight>> MakeLights(FuzzRandom& random)
{
  std::vector<vtkSmartPointer<vtkLight>> lights;
  const int count = random.Integer(0, 3);
  for (int i = 0; i < count; ++i)
  {
    vtkSmartPointer<vtkLight> light;
    if (random.Chance(0.3))
    {
      auto areaLight = vtkSmartPointer<vtkAreaLight>::New();
      areaLight->SetSize(random.Pick<double>({ 0.0, 0.5, 20.0 }), random.Between(0.0, 2.0));
      light = areaLight;
    }
    else
    {
      light = vtkSmartPointer<vtkLight>::New();
    }
    light->SetPositional(random.Chance(0.4));
    light->SetConeAngle(random.Pick<double>({ 20.0, 60.0, 180.0 }));
    light->SetPosition(
      random.Between(-9.0, 9.0), random.Between(-9.0, 9.0), random.Between(-9.0, 9.0));
    light->SetFocalPoint(random.Unit(), random.Unit(), random.Unit());
    light->SetColor(random.Unit(), random.Unit(), random.Unit());
    light->SetIntensity(random.Pick<double>({ 0.0, 1.0, 0.5 }));
    lights.push_back(light);
  }
  return lights;
}

}

void RunTetrahedra(FuzzRandom& random, std::string& text, reference::Check& check)
{
  const FuzzData data = MakeTetrahedra(random);
  const auto property = MakeProperty(random);
  const auto camera = MakeCamera(random, data.Data);
  // Without sorting, the two render paths may draw in different orders.
  const int sort = random.Integer(0, 2);
  const int integration = random.Integer(0, 1);
  const std::string view = DistortCamera(random, camera);
  const int stereo = random.Pick<int>({ 0, 0, VTK_STEREO_LEFT, VTK_STEREO_RIGHT });
  vtkNew<vtkPlaneCollection> planes;
  AddClippingPlanes(random, data.Data, planes);
  text = data.Text + ", sort " + std::to_string(sort) + ", integration " +
    std::to_string(integration) + ", " + view + " camera, stereo " + std::to_string(stereo) + ", " +
    std::to_string(planes->GetNumberOfItems()) + " clipping planes";
  reference::RgbaImage images[2];
  for (const int path : { vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH,
         vtkTimeWeightedTetrahedraMapper::OPENGL_PATH })
  {
    Messages messages;
    reference::VolumeStage stage(std::array<int, 2>{ { Size, Size } });
    vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
    mapper->SetInputDataObject(data.Data);
    mapper->SetRenderPath(path);
    mapper->SetSortMode(sort);
    mapper->SetIntegrationMode(integration);
    mapper->SetClippingPlanes(planes);
    stage.SetVolume(mapper, property);
    stage.SetCamera(camera);
    if (stereo != 0)
    {
      stage.GetWindow()->SetStereoType(stereo);
      stage.GetWindow()->StereoRenderOn();
      // Rendering the window passes the stereo settings to the camera.
      stage.Render();
    }
    const bool isSoftware = path == vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH;
    images[isSoftware ? 0 : 1] = stage.Capture();
    CheckImage(images[isSoftware ? 0 : 1], isSoftware ? "software" : "OpenGL", check);
  }
  if (data.IsTame && sort != vtkTimeWeightedTetrahedraMapper::NO_SORT)
  {
    const reference::ImageError error = reference::CompareImages(images[1], images[0]);
    check.Near(error.Mean, 0.0, 0.005, "mean difference between the two paths", 1.0);
  }
}

void RunShadows(FuzzRandom& random, std::string& text, reference::Check& check)
{
  FuzzData data = MakeImage(random);
  auto* image = vtkImageData::SafeDownCast(data.Data);
  data.Text += PermuteAxes(random, image);
  const auto property = MakeProperty(random);
  if (random.Chance(0.2))
  {
    vtkNew<vtkPiecewiseFunction> gradients;
    gradients->AddPoint(0.0, random.Unit());
    gradients->AddPoint(random.Between(0.01, 1.0), 1.0);
    property->SetGradientOpacity(gradients);
    data.Text += ", gradient opacity";
  }
  const auto lights = MakeLights(random);
  const int scattering = random.Chance(0.3) ? random.Integer(1, 3) : 0;
  const int method = random.Integer(0, 2);
  vtkNew<vtkShadowedSliceMapper> mapper;
  text = data.Text + ", " + std::to_string(lights.size()) + " lights, method " +
    std::to_string(method) + ", scattering " + std::to_string(scattering) +
    Cut(random, mapper, data.Data);
  Messages messages;
  reference::VolumeStage stage(std::array<int, 2>{ { Size, Size } });
  mapper->SetInputData(image);
  mapper->SetSoftShadowMethod(method);
  mapper->SetScatteringMode(scattering);
  // By default, extreme voxel aspect ratios would require 65,536 slices, which take minutes.
  mapper->SetSliceSpacing(data.IsTame ? 0.0 : std::max(data.Data->GetLength() / 64.0, 0.0));
  // By default, wide penumbras would be convolved in the largest light buffers, which takes
  // minutes.
  const bool hasAreaLight = std::any_of(lights.begin(), lights.end(),
    [](vtkLight* light) { return vtkAreaLight::SafeDownCast(light) != nullptr; });
  mapper->SetLightBufferSize(hasAreaLight && !data.IsTame ? 256 : 0);
  stage.SetVolume(mapper, property);
  const auto camera = MakeCamera(random, data.Data);
  text += ", " + DistortCamera(random, camera) + " camera";
  stage.SetCamera(camera);
  stage.SetLights(lights);
  const reference::RgbaImage first = stage.Capture();
  CheckImage(first, "shadows", check);
  stage.SetCamera(MakeCamera(random, data.Data));
  if (random.Chance(0.3))
  {
    // The near or far plane of the camera cuts the volume.
    vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
    const double distance = camera->GetDistance();
    camera->SetClippingRange(distance * random.Pick<double>({ 0.01, 0.9 }), 1.05 * distance);
  }
  CheckImage(stage.Capture(), "another view", check);
  if (data.IsTame && random.Chance(0.5) && image->GetNumberOfPoints() > 0)
  {
    CheckShared(mapper, stage, image, check);
  }
}

}
