// SPDX-License-Identifier: BSD-3-Clause
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace reference
{

vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithmOutput* output)
{
  vtkNew<vtkPolyDataMapper> mapper;
  if (output)
  {
    mapper->SetInputConnection(output);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  actor->GetProperty()->SetSpecular(0.0);
  return actor;
}

vtkSmartPointer<vtkActor> MakeBox(const std::array<double, 6>& bounds)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(bounds.data());
  return MakeActor(box->GetOutputPort());
}

vtkSmartPointer<vtkActor> MakeRectangle(const std::array<double, 3>& origin,
  const std::array<double, 3>& first, const std::array<double, 3>& second)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetPoint1(origin[0] + first[0], origin[1] + first[1], origin[2] + first[2]);
  plane->SetPoint2(origin[0] + second[0], origin[1] + second[1], origin[2] + second[2]);
  return MakeActor(plane->GetOutputPort());
}

vtkSmartPointer<vtkActor> MakeTranslucentSquare(const std::array<double, 3>& center,
  const std::array<double, 3>& normal, double edge, double opacity)
{
  std::array<double, 3> along = normal;
  vtkMath::Normalize(along.data());
  std::array<double, 3> first;
  std::array<double, 3> second;
  vtkMath::Perpendiculars(along.data(), first.data(), second.data(), 0.0);
  std::array<double, 3> origin;
  for (int i = 0; i < 3; ++i)
  {
    first[i] *= edge;
    second[i] *= edge;
    origin[i] = center[i] - 0.5 * (first[i] + second[i]);
  }
  vtkSmartPointer<vtkActor> square = MakeRectangle(origin, first, second);
  square->GetProperty()->SetOpacity(opacity);
  square->GetProperty()->SetColor(0.9, 0.6, 0.2);
  return square;
}

vtkSmartPointer<vtkActor> MakeSphereActor(
  const std::array<double, 3>& center, double radius, int sides)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(sides);
  sphere->SetPhiResolution(sides / 2);
  return MakeActor(sphere->GetOutputPort());
}

vtkSmartPointer<vtkLight> MakeSun(const std::array<double, 3>& direction)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 0.0, 0.0);
  light->SetFocalPoint(direction.data());
  light->SetShadowAttenuation(1.0F);
  return light;
}

vtkSmartPointer<vtkLight> MakePointLight(
  const std::array<double, 3>& position, const std::array<double, 3>& focus)
{
  vtkSmartPointer<vtkLight> light = MakeSun(focus);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(position[0], position[1], position[2]);
  return light;
}

SceneStage::SceneStage(int pixels, double size)
  : Stage(std::array<int, 2>{ { pixels, pixels } })
  , Pixels(pixels)
  , Size(size)
{
  this->Stage.GetVolume()->VisibilityOff();
  this->LookAlong({ { 0.0, 0.0, -1.0 } });
}

SceneStage::~SceneStage()
{
  this->Stage.Release(this->Pass);
}

void SceneStage::LookAlong(const std::array<double, 3>& direction)
{
  vtkNew<vtkCamera> camera;
  camera->SetParallelProjection(1);
  camera->SetParallelScale(0.5 * this->Size);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  const double distance = -4.0 * this->Size / length;
  camera->SetPosition(distance * direction[0], distance * direction[1], distance * direction[2]);
  camera->SetViewUp(0.0, std::abs(direction[1]) > 0.9 * length ? 0.0 : 1.0,
    std::abs(direction[1]) > 0.9 * length ? 1.0 : 0.0);
  camera->SetClippingRange(this->Size, 8.0 * this->Size);
  this->Stage.SetCamera(camera);
}

void SceneStage::AddSmoke(const std::array<double, 6>& bounds, double extinction, int cells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  image->SetSpacing((bounds[1] - bounds[0]) / cells, (bounds[3] - bounds[2]) / cells,
    (bounds[5] - bounds[4]) / cells);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  values->Fill(1.0);
  image->GetPointData()->SetScalars(values);
  const bool isFirst = this->Stage.GetVolume()->GetVisibility() == 0;
  const auto mapper = isFirst ? vtkSmartPointer<vtkShadowedSliceMapper>(this->Mapper)
                              : vtkSmartPointer<vtkShadowedSliceMapper>::New();
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkPiecewiseFunction> opacity;
  const double value = 1.0 - std::exp(-0.1 * extinction);
  opacity->AddPoint(0.0, value);
  opacity->AddPoint(2.0, value);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(0.1);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  property->SetColor(color);
  property->SetShade(0);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  if (isFirst)
  {
    this->Stage.SetVolume(mapper, property);
    this->Stage.GetVolume()->VisibilityOn();
    return;
  }
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  this->Stage.GetRenderer()->AddVolume(volume);
}

RgbaImage SceneStage::Draw(bool hasPass)
{
  if (hasPass)
  {
    this->Stage.SetPass(this->Pass);
  }
  else
  {
    this->Stage.SetPass(vtkNew<vtkRenderStepsPass>());
  }
  return this->Stage.Capture();
}

double SceneStage::At(const RgbaImage& rendered, double x, double y) const
{
  const auto toPixel = [this](double value)
  {
    const int pixel = static_cast<int>(std::floor((value / this->Size + 0.5) * this->Pixels));
    return std::min(std::max(pixel, 0), this->Pixels - 1);
  };
  return rendered.At(toPixel(x), toPixel(y))[0];
}

double SceneStage::FindEdge(
  const RgbaImage& rendered, double from, double to, double y, double level) const
{
  const double step = this->Size / this->Pixels;
  const auto toCenter = [this, step](double x)
  { return (std::floor((x / this->Size + 0.5) * this->Pixels) + 0.5) * step - 0.5 * this->Size; };
  double x = toCenter(from);
  double value = this->At(rendered, x, y);
  while (x + step <= to)
  {
    const double next = this->At(rendered, x + step, y);
    if ((value - level) * (next - level) <= 0.0 && value != next)
    {
      return x + step * (level - value) / (next - value);
    }
    x += step;
    value = next;
  }
  return to;
}

}
