// SPDX-License-Identifier: BSD-3-Clause
#include "FlowDrawing.h"

#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Images/CameraSettings.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace reference
{

namespace
{
FlowEnd TwoSurfaces(const Position3& x)
{
  const bool isLeft = x[0] < 0.1;
  return { x[1] < 0.35, isLeft ? 0 : 8, x[1] + 0.5, x[2] + 0.5, isLeft ? x[0] + 0.6 : x[0] };
}
}

RgbaImage DrawFlow(vtkImplicitFlowVolumeMapper* mapper, vtkImageData* voxels,
  const FlowScene& scene, vtkVolumeProperty* property)
{
  vtkNew<vtkVolumeProperty> plain;
  vtkVolumeProperty* used = property ? property : plain.Get();
  used->SetScalarOpacityUnitDistance(scene.UnitDistance);
  mapper->SetInputData(static_cast<vtkDataSet*>(voxels));
  VolumeStage stage(scene.Size);
  stage.SetVolume(mapper, used);
  stage.SetCamera(scene.Camera);
  const RgbaImage image = stage.Capture();
  mapper->ReleaseGraphicsResources(nullptr);
  return image;
}

FlowEnd Uniform(const Position3& x)
{
  return { true, 0, x[1] + 0.5, x[2] + 0.5, x[0] + 0.5 };
}

vtkSmartPointer<vtkCamera> LookAlong(const Position3& direction, bool isParallel)
{
  return LookAt({ { 0.0, 0.0, 0.0 } }, 0.87, direction, isParallel);
}

Color4 Blob(double u, double v)
{
  const double r = std::hypot(u - 0.5, v - 0.45) / 0.3;
  return { { u, 0.4, v, 0.6 * std::exp(-r * r) } };
}

FlowScene MakeBlobScene()
{
  FlowScene scene;
  scene.Flow = &Uniform;
  scene.Paint = [](const FlowEnd& end) { return Blob(end.U, end.V); };
  scene.UnitDistance = 0.3;
  scene.Camera = LookAlong({ { -0.5, 0.6, -0.4 } });
  return scene;
}

vtkSmartPointer<vtkImageData> MakeTwoFlows()
{
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(13, &TwoSurfaces, { { { 8, 1, 0 } } });
  vtkNew<vtkFloatArray> speed;
  speed->SetName("Speed");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Ways");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
  {
    const double* x = voxels->GetPoint(i);
    speed->InsertNextValue(static_cast<float>(x[0] * x[0] + x[2]));
    vectors->InsertNextTuple3(1.0, x[1], -x[0]);
  }
  voxels->GetPointData()->AddArray(speed);
  voxels->GetPointData()->AddArray(vectors);
  return voxels;
}

vtkSmartPointer<vtkImageData> MakeStripes(double frequency, double alpha)
{
  return MakePaint(33, 17,
    [=](double u, double v) {
      return Color4{ { 0.5 + 0.5 * std::sin(frequency * u), v, 0.3, alpha } };
    });
}

void SetCoefficients(
  vtkVolumeProperty* property, double unitDistance, double ambient, double diffuse)
{
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetAmbient(ambient);
  property->SetDiffuse(diffuse);
  property->SetSpecular(0.0);
}

LightError CompareLight(const RgbaImage& found, const RgbaImage& expected)
{
  LightError error;
  for (int pixel = 0; pixel < found.Width * found.Height; ++pixel)
  {
    const double* drawn = found.At(pixel % found.Width, pixel / found.Width);
    const double* reference = expected.At(pixel % found.Width, pixel / found.Width);
    if (reference[3] < 0.1 || std::abs(drawn[3] - reference[3]) > 0.01)
    {
      continue;
    }
    ++error.Pixels;
    for (int c = 0; c < 3; ++c)
    {
      const double off = std::abs(drawn[c] / drawn[3] - reference[c] / reference[3]);
      error.Mean += off / 3.0;
      error.Largest = std::max(error.Largest, off);
    }
  }
  error.Mean /= std::max(error.Pixels, 1);
  return error;
}

FlowFixture::FlowFixture()
  : Stage(std::array<int, 2>{ { 40, 40 } })
  , Voxels(MakeTwoFlows())
  , Camera(LookAlong({ { -0.4, 0.6, -0.9 } }))
{
  this->Mapper->SetInputData(static_cast<vtkDataSet*>(this->Voxels));
  this->Stage.SetVolume(this->Mapper, this->Property);
  this->Stage.SetCamera(this->Camera);
}

vtkInterlumeReport* FlowFixture::Draw()
{
  this->Stage.Render();
  return this->Mapper->GetReport();
}

void FlowFixture::Apply(const State& state)
{
  const auto is = [&state](int i) { return state[i] > 0.5; };
  this->Gate->RemoveAllPoints();
  this->Gate->AddPoint(0.0, state[9]);
  this->Gate->AddPoint(1.0, 1.0 - state[9]);
  this->Mapper->SetTimeGate(is(9) ? this->Gate.Get() : nullptr);
  this->Mapper->SetOpacityArray(is(10) ? "Speed" : "");
  this->Mapper->SetShadingArray(is(11) ? "Ways" : (is(10) ? "Speed" : ""));
  this->Property->SetShade(is(12));
  this->Mapper->RemoveAllClippingPlanes();
  if (is(13))
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(state[13], -0.3, 0.2);
    this->Mapper->AddClippingPlane(plane);
  }
  this->Mapper->SetCropping(is(14));
  this->Mapper->SetCroppingRegionPlanes(-0.3, 0.4, -0.5, 0.2, -0.1, 0.5);
  this->Mapper->SetCroppingRegionFlags(state[14] > 0.75 ? VTK_CROP_FENCE : VTK_CROP_SUBVOLUME);
  this->Mapper->SetTextureFilter(is(15));
  this->Camera->SetParallelProjection(is(16));
}

RgbaImage DrawRefined(FlowFixture& fixture, Check& check)
{
  vtkRenderWindow* window = fixture.Stage.GetWindow();
  window->SetDesiredUpdateRate(1e9);
  fixture.Mapper->ProgressiveRenderingOn();
  RgbaImage image = fixture.Stage.Capture();
  check.That(fixture.Mapper->GetRefinementPending(), "the first image is coarse");
  window->SetDesiredUpdateRate(1e-4);
  for (int pass = 0; fixture.Mapper->GetRefinementPending() && pass < 3; ++pass)
  {
    image = fixture.Stage.Capture();
  }
  check.That(!fixture.Mapper->GetRefinementPending(), "the image becomes final");
  check.That(fixture.Stage.Capture().Values == image.Values, "the final image is shown again");
  check.Equal(
    fixture.Mapper->GetReport()->GetCount("Passes"), 0, "no rays are cast without a change");
  return image;
}

void CheckRandomStates(const std::function<std::unique_ptr<FlowFixture>()>& make,
  const std::function<void(vtkInterlumeReport*)>& inspect, Check& check)
{
  const std::unique_ptr<FlowFixture> reused = make();
  const std::unique_ptr<FlowFixture> refined = make();
  Random random(21);
  double largest = 0.0;
  for (int change = 0; change < 24; ++change)
  {
    FlowFixture::State state;
    for (double& value : state)
    {
      value = random.Get(0.0, 1.0);
    }
    reused->Apply(state);
    const RgbaImage after = reused->Stage.Capture();
    const std::unique_ptr<FlowFixture> fresh = make();
    fresh->Apply(state);
    const RgbaImage expected = fresh->Stage.Capture();
    const ImageError error = CompareImages(after, expected);
    refined->Apply(state);
    check.That(DrawRefined(*refined, check).Values == expected.Values,
      "change " + std::to_string(change) + ": the refined image equals that of a new mapper");
    vtkInterlumeReport* report = reused->Mapper->GetReport();
    check.Near(error.Max, 0.0, 0.0,
      "change " + std::to_string(change) + ", " + report->GetText("Features"), 1.0);
    inspect(report);
    reference::KeepLargest(largest, LargestAlpha(after));
  }
  check.That(largest > 0.2, "some image is not empty");
}

}
