// SPDX-License-Identifier: BSD-3-Clause
// Uploads of vtkImplicitFlowVolumeMapper after single changes, resources of features that are off,
// and images after many changes compared with images of a new mapper.
#include "FlowDrawing.h"

#include "Support/Images/CameraSettings.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

vtkSmartPointer<vtkImageData> MakeBlock()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (vtkIdType i = 0; i < 64; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      image->GetPointData()->GetScalars()->SetComponent(
        i, c, static_cast<double>((37 * i + 61 * c) % 256));
    }
  }
  return image;
}

/// A fixture that also varies the inflow textures, the detail texture and the time gate, but has no
/// lights.
struct Fixture : FlowFixture
{
  Fixture()
  {
    this->Gate->AddPoint(0.0, 1.0);
    this->Gate->AddPoint(0.5, 0.1);
    this->Gate->AddPoint(1.0, 1.0);
    this->Property->SetScalarOpacityUnitDistance(0.2);
  }

  void Apply(const State& state) override
  {
    this->FlowFixture::Apply(state);
    const auto is = [&state](int i) { return state[i] > 0.5; };
    this->Mapper->RemoveAllInflowTextures();
    this->Mapper->SetInflowTexture(0, is(0) ? MakeStripes(30.0 * state[0], 0.4) : nullptr);
    this->Mapper->SetInflowTexture(
      vtkImplicitFlowVolumeMapper::ALL, is(1) ? MakeStripes(7.0, state[1]) : nullptr);
    this->Mapper->SetDetailTexture(
      is(2) ? (is(3) ? MakeBlock() : MakeStripes(11.0, 0.8)) : nullptr);
    this->Mapper->SetDetailMode(static_cast<int>(3.0 * state[4]));
    this->Mapper->SetDetailScale(1.0 + state[4], 2.0, 1.5);
    this->Mapper->SetTimeGateTarget(static_cast<int>(3.0 * state[5]));
    this->Mapper->SetTimeGateRepeat(is(6));
    this->Mapper->SetTimePhase(4.0 * state[6] - 2.0);
    this->Mapper->SetSampleDistance(0.05 * state[7]);
    this->Mapper->SetDefaultColor(state[8], 0.5, 0.6, 0.3);
  }
};

struct Uploads
{
  int Grid = 0;
  int Inflow = 0;
  int Detail = 0;
  int Gate = 0;
  int Transfer = 0;
  int Array = 0;
};

void CheckUploads(
  Check& check, vtkInterlumeReport* report, const Uploads& expected, const std::string& what)
{
  check.Equal(report->GetCount("GridUploads"), expected.Grid, what + ": voxel textures");
  check.Equal(report->GetCount("InflowUploads"), expected.Inflow, what + ": inflow textures");
  check.Equal(report->GetCount("DetailUploads"), expected.Detail, what + ": detail textures");
  check.Equal(report->GetCount("GateUploads"), expected.Gate, what + ": gates");
  check.Equal(
    report->GetCount("TransferUploads"), expected.Transfer, what + ": transfer functions");
  check.Equal(report->GetCount("ArrayUploads"), expected.Array, what + ": arrays");
  const int sum = expected.Grid + expected.Inflow + expected.Detail + expected.Gate +
    expected.Transfer + expected.Array;
  check.That((report->GetNumber("UploadedBytes") > 0) == (sum > 0), what + ": bytes");
}

void TestCounters(Check& check)
{
  Fixture fixture;
  vtkImplicitFlowVolumeMapper* mapper = fixture.Mapper;
  vtkSmartPointer<vtkImageData> first = MakeStripes(20.0, 0.3);
  vtkSmartPointer<vtkImageData> second = MakeStripes(9.0, 0.6);
  mapper->SetInflowTexture(0, first);
  mapper->SetInflowTexture(8, second);
  const auto expect = [&](const Uploads& uploads, const std::string& what)
  { CheckUploads(check, fixture.Draw(), uploads, what); };
  // The first frame uploads three voxel textures (cells, positions and groups), two inflow textures
  // and the surface table.
  expect({ 3, 3, 0, 0, 0, 0 }, "first image");
  check.Equal(
    mapper->GetReport()->GetCount("Textures"), 6, "no textures for features that are off");
  check.That(mapper->GetReport()->GetText("Features") == "splits surfaces paint_filter",
    "features: " + mapper->GetReport()->GetText("Features"));
  expect({}, "drawing again");
  fixture.Camera->Azimuth(5.0);
  expect({}, "another view");
  second->GetPointData()->GetScalars()->SetComponent(3, 0, 0.9);
  second->GetPointData()->GetScalars()->Modified();
  second->Modified();
  expect({ 0, 1, 0, 0, 0, 0 }, "a changed inflow texture");
  mapper->SetInflowTexture(0, MakeStripes(5.0, 0.4));
  expect({ 0, 1, 0, 0, 0, 0 }, "another inflow texture");
  mapper->SetTimeGate(fixture.Gate);
  // Advection times are uploaded when they are first required.
  expect({ 1, 0, 0, 1, 0, 0 }, "a time gate");
  check.Equal(mapper->GetReport()->GetCount("Textures"), 8, "textures with a time gate");
  mapper->SetTimePhase(0.3);
  expect({}, "another phase");
  mapper->SetTimePeriod(0.7);
  expect({}, "another period");
  fixture.Gate->AddPoint(0.7, 0.8);
  expect({ 0, 0, 0, 1, 0, 0 }, "a changed time gate");
  mapper->SetDetailTexture(MakeStripes(3.0, 0.9));
  expect({ 0, 0, 1, 0, 0, 0 }, "a detail texture");
  mapper->SetDetailModeToOver();
  expect({}, "another mode");
  mapper->SetDetailTexture(MakeBlock());
  expect(
    { 0, 0, 1, 0, 0, 0 }, "a three-dimensional detail texture instead of a two-dimensional one");
  mapper->SetOpacityArray("Speed");
  expect({ 0, 0, 0, 0, 1, 1 }, "an additional array");
  fixture.Property->GetScalarOpacity()->AddPoint(0.2, 0.4);
  expect({ 0, 0, 0, 0, 1, 0 }, "a changed transfer function");
  mapper->SetShadingArray("Ways");
  expect({}, "a shading array without Shade");
  fixture.Property->ShadeOn();
  expect({ 0, 0, 0, 0, 0, 1 }, "shading");
  mapper->SetTimeGate(nullptr);
  mapper->SetDetailTexture(nullptr);
  mapper->SetOpacityArray(nullptr);
  fixture.Property->ShadeOff();
  expect({}, "all features off again");
  check.Equal(mapper->GetReport()->GetCount("Textures"), 6, "textures with all features off again");
  check.That(mapper->GetReport()->GetText("Features") == "splits surfaces paint_filter",
    "features with all features off again: " + mapper->GetReport()->GetText("Features"));
  fixture.Voxels->GetPointData()->GetArray("AdvectionTime")->Modified();
  fixture.Voxels->Modified();
  expect({ 3, 0, 0, 0, 0, 0 }, "changed voxels");
}

/// Opacity from an array is unchanged if the array and the transfer function are shifted together.
void TestOpacityArray(Check& check)
{
  RgbaImage rendered[2];
  for (const int isMoved : { 0, 1 })
  {
    Fixture fixture;
    fixture.Mapper->SetInflowTexture(0, MakeStripes(20.0, 0.3));
    const double shift = 40.0 * isMoved;
    vtkDataArray* speed = fixture.Voxels->GetPointData()->GetArray("Speed");
    double range[2];
    speed->GetRange(range);
    for (vtkIdType i = 0; i < speed->GetNumberOfTuples(); ++i)
    {
      speed->SetComponent(i, 0, speed->GetComponent(i, 0) + shift);
    }
    vtkPiecewiseFunction* opacity = fixture.Property->GetScalarOpacity();
    opacity->RemoveAllPoints();
    opacity->AddPoint(range[0] + shift, 0.0);
    opacity->AddPoint(range[1] + shift, 0.8);
    fixture.Mapper->SetOpacityArray("Speed");
    rendered[isMoved] = fixture.Stage.Capture();
  }
  const ImageError error = CompareImages(rendered[1], rendered[0]);
  check.Near(error.Max, 0.0, 1e-3, "opacity array and transfer function shifted together", 1.0);
}

void TestRandom(Check& check)
{
  CheckRandomStates([] { return std::make_unique<Fixture>(); }, [](vtkInterlumeReport*) {}, check);
}

/// Draws several vtkImageData of different dimensions that share their arrays, with two opacity
/// arrays of different ranges that share a transfer function. The arrays and the function are
/// modified first. Each frame must equal that of a new mapper.
void TestShared(Check& check)
{
  const FlowFormula flow = [](const Position3& x) {
    return FlowEnd{ x[1] < 0.4, 0, x[1] + 0.5, x[2] + 0.5, x[0] + 0.5 };
  };
  vtkSmartPointer<vtkImageData> first = MakeFlowVoxels(12, flow);
  for (const double scale : { 1.0, 5.0 })
  {
    vtkNew<vtkFloatArray> speed;
    speed->SetName(scale == 1.0 ? "Slow" : "Fast");
    for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
    {
      speed->InsertNextValue(static_cast<float>(scale * std::fmod(0.37 * i, 1.0)));
    }
    first->GetPointData()->AddArray(speed);
  }
  std::vector<vtkSmartPointer<vtkImageData>> images{ first };
  for (const std::array<int, 3>& size :
    { std::array<int, 3>{ { 24, 12, 6 } }, std::array<int, 3>{ { 6, 16, 18 } } })
  {
    images.push_back(vtkSmartPointer<vtkImageData>::New());
    images.back()->ShallowCopy(first);
    images.back()->SetExtent(3, size[0] + 2, -2, size[1] - 3, 0, size[2] - 1);
    images.back()->SetSpacing(0.06, -0.07, 0.08);
  }
  const auto prepare = [](Fixture& fixture, vtkImageData* image, const char* opacity)
  {
    fixture.Camera =
      LookAt(Position3{ { image->GetCenter()[0], image->GetCenter()[1], image->GetCenter()[2] } },
        0.5 * image->GetLength(), { { -0.4, 0.6, -0.9 } }, false);
    fixture.Stage.SetCamera(fixture.Camera);
    fixture.Mapper->SetInflowTexture(0, MakeStripes(20.0, 0.5));
    fixture.Mapper->SetInputData(static_cast<vtkDataSet*>(image));
    fixture.Mapper->SetOpacityArray(opacity);
    fixture.Mapper->SetShadingArray(opacity);
    fixture.Property->ShadeOn();
  };
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, 0.9);
  function->AddPoint(5.0, 0.1);
  const auto draw = [&](Fixture& fixture, int step)
  {
    prepare(fixture, images[static_cast<std::size_t>(step) % images.size()],
      step % 2 == 0 ? "Slow" : "Fast");
    fixture.Property->SetScalarOpacity(function);
    return fixture.Stage.Capture();
  };
  std::vector<RgbaImage> expected;
  for (int step = 0; step < 6; ++step)
  {
    Fixture fresh;
    expected.push_back(draw(fresh, step));
    check.That(LargestAlpha(expected.back()) > 0.2, "the image of shared arrays is not empty");
  }
  for (const char* name : { "Slow", "Fast" })
  {
    first->GetPointData()->GetArray(name)->Modified();
  }
  function->Modified();
  Fixture reused;
  for (const int step : { 0, 3, 1, 5, 2, 4, 1, 0, 3, 2 })
  {
    const double error =
      CompareImages(draw(reused, step), expected[static_cast<std::size_t>(step)]).Max;
    check.Near(error, 0.0, 0.0, "shared arrays, step " + std::to_string(step), 1.0);
  }
}
}

int TestFlowVolumeChanges(int, char*[])
{
  return RunChecks({ TestCounters, TestOpacityArray, TestRandom, TestShared });
}
