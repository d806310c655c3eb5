// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/ShadowScene.h"

#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkColorTransferFunction.h"
#include "vtkConstructiveVolume.h"
#include "vtkFloatArray.h"
#include "vtkImageContinuousDilate3D.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkTransform.h"
#include "vtkTurbulenceSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gallery
{
namespace
{
/// Intensity of the fill light divided by the intensity of the key light.
constexpr double FILL_FRACTION = 0.25;

/// Mix() stretches the densities of solids (0 to 255) so that this value becomes 0, and 255 minus
/// this value becomes 255.
constexpr double LOWEST_EDGE = 30.0;

/// Opacity of a voxel inside a solid.
constexpr double SURFACE_OPACITY = 0.998;

double SmallestSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return std::min({ spacing[0], spacing[1], spacing[2] });
}

vtkSmartPointer<vtkSpatialPrimitive> MakePrimitive(
  int shape, const vtkVector3d& center, const vtkColor3d& color)
{
  auto primitive = vtkSmartPointer<vtkSpatialPrimitive>::New();
  primitive->SetShape(shape);
  primitive->SetCenter(center[0], center[1], center[2]);
  primitive->SetColor(color[0], color[1], color[2]);
  primitive->SetEdgeWidth(EDGE_WIDTH);
  return primitive;
}

/// Replaces each color channel of a `Color` array of floats by weigh(channel, density).
template <typename Operation>
void WeightColors(vtkImageData* image, const Operation& weigh)
{
  auto* texels = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  vtkSMPTools::For(0, image->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        float* texel = texels->GetPointer(4 * point);
        std::transform(
          texel, texel + 3, texel, [&](float channel) { return weigh(channel, texel[3]); });
      }
    });
}

/// Blurs the density, and the colors weighted by density, so that colors of empty space have no
/// effect.
vtkSmartPointer<vtkImageData> Blur(vtkImageData* image, double deviation)
{
  WeightColors(image, [](float channel, float density) { return channel * density; });
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  smooth->SetStandardDeviation(deviation);
  smooth->SetRadiusFactor(2.5);
  smooth->Update();
  vtkSmartPointer<vtkImageData> blurred = smooth->GetOutput();
  WeightColors(blurred,
    [](float channel, float density) { return density > 0.0F ? channel / density : 0.0F; });
  return blurred;
}

vtkSmartPointer<vtkImageData> ToBytes(vtkImageData* image)
{
  vtkNew<vtkImageShiftScale> bytes;
  bytes->SetInputData(image);
  bytes->SetShift(0.5 / 255.0);
  bytes->SetScale(255.0);
  bytes->SetOutputScalarTypeToUnsignedChar();
  bytes->ClampOverflowOn();
  bytes->Update();
  return bytes->GetOutput();
}

/// Returns an image in which each sample is the maximum of the 5 x 5 x 5 samples around it.
vtkSmartPointer<vtkImageData> LargestAround(vtkImageData* image)
{
  vtkSmartPointer<vtkImageData> largest = image;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<int, 3> kernel = { 1, 1, 1 };
    kernel[static_cast<std::size_t>(axis)] = 5;
    vtkNew<vtkImageContinuousDilate3D> dilate;
    dilate->SetInputData(largest);
    dilate->SetKernelSize(kernel[0], kernel[1], kernel[2]);
    dilate->Update();
    largest = dilate->GetOutput();
  }
  return largest;
}

/// Adds smoke where it is denser than \a image. Remaps densities so that the soft edges of solids
/// remain outside the range of smoke.
void Mix(vtkImageData* image, const vtkBoundingBox& box, vtkImageData* smoke, double fraction,
  const vtkColor3d& color)
{
  auto* densities = vtkFloatArray::SafeDownCast(smoke->GetPointData()->GetScalars());
  auto* texels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  vtkSMPTools::For(0, image->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::array<double, 3> position;
      for (vtkIdType point = begin; point < end; ++point)
      {
        unsigned char* texel = texels->GetPointer(4 * point);
        const double solid = (texel[3] - LOWEST_EDGE) * 255.0 / (255.0 - 2.0 * LOWEST_EDGE);
        image->GetPoint(point, position.data());
        const double density =
          box.ContainsPoint(position.data()) ? 255.0 * fraction * densities->GetValue(point) : 0.0;
        if (density > solid)
        {
          std::transform(color.GetData(), color.GetData() + 3, texel,
            [](double channel)
            { return static_cast<unsigned char>(std::lround(255.0 * channel)); });
        }
        texel[3] = static_cast<unsigned char>(
          std::lround(std::min(std::max({ density, solid, 0.0 }), 255.0)));
      }
    });
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty(vtkPiecewiseFunction* opacity, double unit)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.12);
  property->SetSpecularPower(24.0);
  return property;
}
}

vtkSmartPointer<vtkSpatialPrimitive> MakeBox(
  const vtkVector3d& lower, const vtkVector3d& upper, const vtkColor3d& color)
{
  vtkSmartPointer<vtkSpatialPrimitive> box =
    MakePrimitive(vtkSpatialPrimitive::BOX, 0.5 * (lower + upper), color);
  const vtkVector3d lengths = upper - lower;
  box->SetLengths(lengths[0], lengths[1], lengths[2]);
  return box;
}

vtkSmartPointer<vtkSpatialPrimitive> MakeDisk(
  const vtkVector3d& top, double radius, double thickness, const vtkColor3d& color)
{
  vtkSmartPointer<vtkSpatialPrimitive> disk = MakePrimitive(
    vtkSpatialPrimitive::CYLINDER, top - vtkVector3d(0.0, 0.0, 0.5 * thickness), color);
  disk->SetRadius(radius);
  disk->SetHeight(thickness);
  return disk;
}

vtkColor3d PlasterColor()
{
  return { 0.90, 0.88, 0.84 };
}

vtkSmartPointer<vtkSpatialPrimitive> MakeFloor(const vtkColor3d& color, double height)
{
  constexpr double size = 10.0;
  return MakeBox({ -size, -size, height - size }, { size, size, height }, color);
}

vtkSmartPointer<vtkSpatialObject> Place(
  vtkSpatialObject* object, const vtkVector3d& offset, double degrees)
{
  auto placed = vtkSmartPointer<vtkSpatialOperation>::New();
  placed->AddOperand(object);
  vtkNew<vtkTransform> transform;
  transform->Translate(offset.GetData());
  transform->RotateZ(degrees);
  placed->SetTransform(transform);
  return placed;
}

vtkSmartPointer<vtkSpatialObject> Unite(
  const std::vector<vtkSmartPointer<vtkSpatialObject>>& objects)
{
  auto all = vtkSmartPointer<vtkSpatialOperation>::New();
  for (const vtkSmartPointer<vtkSpatialObject>& object : objects)
  {
    all->AddOperand(object);
  }
  return all;
}

vtkSmartPointer<vtkSpatialObject> SoftenEdges(vtkSpatialObject* object, double width)
{
  if (auto* solid = vtkSpatialPrimitive::SafeDownCast(object))
  {
    solid->SetEdgeWidth(width);
  }
  if (auto* operation = vtkSpatialOperation::SafeDownCast(object))
  {
    for (int i = 0; i < operation->GetNumberOfOperands(); ++i)
    {
      SoftenEdges(operation->GetOperand(i), width);
    }
  }
  return object;
}

vtkSmartPointer<vtkImageData> Sample(
  vtkSpatialObject* object, const vtkBoundingBox& box, int resolution, double blur)
{
  std::array<double, 3> lengths;
  box.GetLengths(lengths.data());
  const double spacing = box.GetMaxLength() / (resolution - 1);
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  std::array<int, 3> dimensions;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int steps = static_cast<int>(std::ceil(lengths[axis] / spacing - 1e-6));
    dimensions[axis] = steps + 1;
    bounds[2 * axis + 1] = bounds[2 * axis] + steps * spacing;
  }
  vtkNew<vtkConstructiveVolume> volume;
  volume->SetRoot(object);
  volume->SetBounds(bounds.data());
  volume->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
  volume->SetOutputModeToColorFloats();
  volume->Update();
  return ToBytes(Blur(volume->GetOutput(), blur));
}

vtkSmartPointer<vtkSpatialImage> MakeImageObject(
  vtkImageData* image, double lower, double upper, vtkColorTransferFunction* colors)
{
  const char* const name = "MediumColor";
  vtkSmartPointer<vtkImageData> around = LargestAround(image);
  vtkDataArray* scalars = around->GetPointData()->GetScalars();
  const auto color = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    vtkUnsignedCharArray::SafeDownCast(colors->MapScalars(scalars, VTK_COLOR_MODE_MAP_SCALARS, 0)));
  color->SetName(name);
  vtkNew<vtkImageData> colored;
  colored->ShallowCopy(image);
  colored->GetPointData()->AddArray(color);
  auto object = vtkSmartPointer<vtkSpatialImage>::New();
  object->SetImage(colored);
  object->SetScalarRange(lower, upper);
  object->SetColorArrayName(name);
  return object;
}

void AddSmoke(vtkImageData* image, vtkTurbulenceSource* smoke, double fraction,
  const vtkColor3d& color, const vtkBoundingBox& box)
{
  smoke->SetWholeExtent(image->GetExtent());
  smoke->SetBounds(image->GetBounds());
  smoke->Update();
  Mix(image, box.IsValid() ? box : vtkBoundingBox(image->GetBounds()), smoke->GetOutput(), fraction,
    color);
}

void AddSmoke(
  vtkImageData* image, vtkSpatialObject* smoke, double fraction, const vtkColor3d& color)
{
  vtkNew<vtkConstructiveVolume> volume;
  volume->SetRoot(smoke);
  volume->SetWholeExtent(image->GetExtent());
  volume->SetBounds(image->GetBounds());
  volume->Update();
  Mix(image, vtkBoundingBox(image->GetBounds()), volume->GetOutput(), fraction, color);
}

vtkSmartPointer<vtkVolumeProperty> MakeColoredMedium(vtkPiecewiseFunction* opacity, double unit)
{
  vtkSmartPointer<vtkVolumeProperty> property = MakeProperty(opacity, unit);
  property->IndependentComponentsOff();
  return property;
}

vtkSmartPointer<vtkVolumeProperty> MakeSolidMedium(vtkImageData* image)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(80.0, 0.0);
  opacity->AddPoint(175.0, SURFACE_OPACITY);
  return MakeColoredMedium(opacity, SmallestSpacing(image));
}

vtkSmartPointer<vtkVolumeProperty> MakeSolidMediumInSmoke(vtkImageData* image, double opacity)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(60.0, opacity);
  function->AddPoint(80.0, opacity);
  function->AddPoint(175.0, SURFACE_OPACITY);
  return MakeColoredMedium(function, SmallestSpacing(image));
}

vtkSmartPointer<vtkVolume> MakeSlicedVolume(
  vtkImageData* image, vtkVolumeProperty* property, double surfaceGradient)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetSliceSpacing(0.5 * SmallestSpacing(image));
  // The image must not depend on the speed of the machine.
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSurfaceGradient(surfaceGradient);
  // The light buffer is finer than the volume, to avoid aliasing patterns on lit surfaces.
  mapper->SetLightBufferSize(768);
  // Gallery images are supersampled. Volumes with soft edges need only half as many samples in each
  // direction.
  mapper->SetImageSampleDistance(2.0);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  return volume;
}

vtkShadowedSliceMapper* GetSlicedMapper(vtkVolume* volume)
{
  return vtkShadowedSliceMapper::SafeDownCast(volume->GetMapper());
}

vtkSmartPointer<vtkLight> MakePointLight(const vtkVector3d& position, double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(180.0);
  light->SetIntensity(intensity);
  return light;
}

vtkSmartPointer<vtkLight> MakeParallelLight(const vtkVector3d& from, double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(from[0], from[1], from[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  return light;
}

Lights MakeStudioLights(const vtkVector3d& position, double intensity)
{
  vtkSmartPointer<vtkLight> key = MakePointLight(position, EDGE_GAIN * intensity);
  key->SetDiffuseColor(1.0, 0.96, 0.90);
  vtkSmartPointer<vtkLight> fill = MakeParallelLight(
    { -position[0], 1.5 * position[1], 0.7 * position[2] }, FILL_FRACTION * intensity);
  fill->SetDiffuseColor(0.80, 0.90, 1.0);
  fill->SetShadowAttenuation(0.0F);
  return { key, fill };
}

void ShadowPair::Look(const vtkVector3d& from, const vtkBoundingBox& frame) const
{
  this->Without.LookFrom(from, { 0.0, 0.0, 1.0 });
  this->With.ShareCamera(this->Without);
  this->Without.Frame(frame);
  this->With.Frame(frame);
}

void ShadowPair::SetBackground(const vtkColor3d& lower, const vtkColor3d& upper) const
{
  this->Without.SetBackground(lower, upper);
  this->With.SetBackground(lower, upper);
}

ShadowPair AddShadowPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double surfaceGradient, const std::string& caption)
{
  Panel& without = stage.AddPanel(caption + "without shadows");
  Panel& with = stage.AddPanel(caption + "with shadows");
  Lights weak;
  for (const vtkSmartPointer<vtkLight>& light : lights)
  {
    weak.push_back(vtkSmartPointer<vtkLight>::New());
    weak.back()->DeepCopy(light);
    const double gain = light->GetShadowAttenuation() > 0.0F ? EDGE_GAIN : 1.0;
    weak.back()->SetIntensity(light->GetIntensity() / gain);
  }
  for (Panel* panel : { &without, &with })
  {
    vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(image, property, surfaceGradient);
    GetSlicedMapper(volume)->SetShadows(panel == &with);
    panel->Add(volume);
    panel->SetLights(panel == &with ? lights : weak);
  }
  return { without, with };
}

Panel& AddShadowPanel(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double surfaceGradient)
{
  Panel& panel = stage.AddPanel("");
  panel.Add(MakeSlicedVolume(image, property, surfaceGradient));
  panel.SetLights(lights);
  return panel;
}
}
