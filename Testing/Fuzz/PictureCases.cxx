// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "Support/Pictures/RgbaPicture.h"
#include "Support/Pictures/VolumeStage.h"

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
  const int nodes = random.Whole(1, 5);
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

/// A camera that looks at the data, or along an axis, near, far, or from within.
vtkSmartPointer<vtkCamera> MakeCamera(FuzzRandom& random, vtkDataSet* data)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  double center[3];
  data->GetCenter(center);
  double length = data->GetLength();
  length = std::isfinite(length) && length > 0.0 ? length : 1.0;
  double way[3] = { random.Between(-1.0, 1.0), random.Between(-1.0, 1.0),
    random.Between(0.1, 1.0) };
  if (random.Chance(0.3))
  {
    way[0] = way[1] = 0.0;
  }
  const double distance = length * random.Pick<double>({ 0.2, 2.0, 20.0 });
  camera->SetFocalPoint(center);
  camera->SetPosition(
    center[0] + distance * way[0], center[1] + distance * way[1], center[2] + distance * way[2]);
  camera->SetViewUp(0.0, 1.0, 0.01);
  camera->SetParallelProjection(random.Chance(0.4));
  camera->SetParallelScale(0.6 * length);
  camera->SetClippingRange(1e-3 * length, distance + 10.0 * length);
  return camera;
}

/// Makes the camera sheared, off-axis or one with user transforms. Returns the name.
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
  const int kind = random.Whole(0, 8);
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
  const int count = std::max(random.Whole(-2, 3), 0);
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(random.Pick<double>({ 0.0, 1.0, random.Unit() }), random.Between(-1.0, 1.0),
      random.Pick<double>({ 0.0, -1.0, random.Unit() }));
    double point[3];
    if (data->GetNumberOfPoints() > 0 && random.Chance(0.5))
    {
      data->GetPoint(random.Whole(0, static_cast<int>(data->GetNumberOfPoints()) - 1), point);
    }
    else
    {
      data->GetCenter(point);
    }
    plane->SetOrigin(point);
    planes->AddItem(plane);
  }
}

/// Channels are finite; alpha is of [0, 1].
void CheckPicture(
  const reference::RgbaPicture& picture, const std::string& what, reference::Check& check)
{
  bool isFinite = true;
  double most = 0.0;
  double least = 0.0;
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    isFinite = isFinite && std::isfinite(picture.Values[i]);
    if (i % 4 == 3)
    {
      most = std::max(most, picture.Values[i]);
    }
    least = std::min(least, picture.Values[i]);
  }
  check.That(isFinite, what + ": finite");
  check.That(most <= 1.001 && least >= -0.001,
    what + ": channels from " + std::to_string(least) + ", alpha to " + std::to_string(most));
}

/// Puts the axes of an image in another order, with or without a reflection.
std::string PermuteAxes(FuzzRandom& random, vtkImageData* image)
{
  if (!random.Chance(0.2))
  {
    return {};
  }
  const double sign = random.Pick<double>({ -1.0, 1.0 });
  image->SetDirectionMatrix(0.0, 0.0, sign, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0);
  return ", axes in another order";
}

/// Cropping of any flags and clipping planes, within or beside the data.
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
    const int flags = random.Pick<int>({ VTK_CROP_SUBVOLUME, random.Whole(0, (1 << 27) - 1) });
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

/// Draws an image that shares the array in another order of dimensions, as a new mapper does.
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
  const reference::RgbaPicture found = stage.Capture();
  mapper->ReleaseGraphicsResources(nullptr);
  vtkNew<vtkShadowedSliceMapper> fresh;
  fresh->SetInputData(shared);
  fresh->SetSoftShadowMethod(mapper->GetSoftShadowMethod());
  fresh->SetMultipleScattering(mapper->GetMultipleScattering());
  fresh->SetSliceSpacing(mapper->GetSliceSpacing());
  fresh->SetClippingPlanes(mapper->GetClippingPlanes());
  fresh->SetCropping(mapper->GetCropping());
  fresh->SetCroppingRegionPlanes(mapper->GetCroppingRegionPlanes());
  fresh->SetCroppingRegionFlags(mapper->GetCroppingRegionFlags());
  stage.SetVolume(fresh, stage.GetVolume()->GetProperty());
  check.Near(reference::ComparePictures(found, stage.Capture()).Max, 0.0, 0.0,
    "an array that two images share, as by a new mapper", 1.0);
}

std::vector<vtkSmartPointer<vtkLight>> MakeLights(FuzzRandom& random)
{
  std::vector<vtkSmartPointer<vtkLight>> lights;
  const int count = random.Whole(0, 3);
  for (int i = 0; i < count; ++i)
  {
    vtkSmartPointer<vtkLight> light;
    if (random.Chance(0.3))
    {
      auto lamp = vtkSmartPointer<vtkAreaLight>::New();
      lamp->SetSize(random.Pick<double>({ 0.0, 0.5, 20.0 }), random.Between(0.0, 2.0));
      light = lamp;
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
  // Without an order the two paths may take each its own.
  const int sort = random.Whole(0, 2);
  const int integration = random.Whole(0, 1);
  const std::string view = DistortCamera(random, camera);
  const int stereo = random.Pick<int>({ 0, 0, VTK_STEREO_LEFT, VTK_STEREO_RIGHT });
  vtkNew<vtkPlaneCollection> planes;
  AddClippingPlanes(random, data.Data, planes);
  text = data.Text + ", sort " + std::to_string(sort) + ", integration " +
    std::to_string(integration) + ", " + view + " camera, stereo " + std::to_string(stereo) + ", " +
    std::to_string(planes->GetNumberOfItems()) + " clipping planes";
  reference::RgbaPicture pictures[2];
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
    }
    // The camera is told of stereo when the window itself is drawn.
    stage.Render();
    const bool isSoftware = path == vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH;
    pictures[isSoftware ? 0 : 1] = stage.Capture();
    CheckPicture(pictures[isSoftware ? 0 : 1], isSoftware ? "software" : "OpenGL", check);
  }
  if (data.IsTame && sort != vtkTimeWeightedTetrahedraMapper::NO_SORT)
  {
    const reference::PictureError error = reference::ComparePictures(pictures[1], pictures[0]);
    check.Near(error.Mean, 0.0, 0.005, "mean difference of the two paths", 1.0);
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
  const int scattering = random.Chance(0.3) ? random.Whole(1, 3) : 0;
  const int method = random.Whole(0, 2);
  vtkNew<vtkShadowedSliceMapper> mapper;
  text = data.Text + ", " + std::to_string(lights.size()) + " lights, method " +
    std::to_string(method) + ", scattering " + std::to_string(scattering) +
    Cut(random, mapper, data.Data);
  Messages messages;
  reference::VolumeStage stage(std::array<int, 2>{ { Size, Size } });
  mapper->SetInputData(image);
  mapper->SetSoftShadowMethod(method);
  mapper->SetMultipleScattering(scattering);
  // Voxels a million times as long as wide have 65,536 slices, which take minutes.
  mapper->SetSliceSpacing(data.IsTame ? 0.0 : std::max(data.Data->GetLength() / 64.0, 0.0));
  stage.SetVolume(mapper, property);
  const auto camera = MakeCamera(random, data.Data);
  text += ", " + DistortCamera(random, camera) + " camera";
  stage.SetCamera(camera);
  stage.SetLights(lights);
  const reference::RgbaPicture first = stage.Capture();
  CheckPicture(first, "shadows", check);
  stage.SetCamera(MakeCamera(random, data.Data));
  if (random.Chance(0.3))
  {
    // The far plane of the camera cuts the volume, or the near plane.
    vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
    const double distance = camera->GetDistance();
    camera->SetClippingRange(distance * random.Pick<double>({ 0.01, 0.9 }), 1.05 * distance);
  }
  CheckPicture(stage.Capture(), "another view", check);
  if (data.IsTame && random.Chance(0.5) && image->GetNumberOfPoints() > 0)
  {
    CheckShared(mapper, stage, image, check);
  }
}

}
