// SPDX-License-Identifier: BSD-3-Clause
// What vtkImplicitFlowVolumeMapper sends when one thing changes, what it does not have for what is
// off, and that a picture after many changes is that of a mapper made anew.
#include "FlowDrawing.h"

#include "Support/Pictures/PictureSettings.h"
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

/// A show of paint without light.
struct Show : FlowShow
{
  Show()
  {
    this->Gate->AddPoint(0.0, 1.0);
    this->Gate->AddPoint(0.5, 0.1);
    this->Gate->AddPoint(1.0, 1.0);
    this->Property->SetScalarOpacityUnitDistance(0.2);
  }

  void Apply(const State& state) override
  {
    this->FlowShow::Apply(state);
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
  check.Near(report->GetNumber("GridUploads"), expected.Grid, 0.0, what + ": textures of voxels");
  check.Near(report->GetNumber("InflowUploads"), expected.Inflow, 0.0, what + ": inflow textures");
  check.Near(report->GetNumber("DetailUploads"), expected.Detail, 0.0, what + ": detail textures");
  check.Near(report->GetNumber("GateUploads"), expected.Gate, 0.0, what + ": gates");
  check.Near(
    report->GetNumber("TransferUploads"), expected.Transfer, 0.0, what + ": transfer functions");
  check.Near(report->GetNumber("ArrayUploads"), expected.Array, 0.0, what + ": arrays");
  const int sum = expected.Grid + expected.Inflow + expected.Detail + expected.Gate +
    expected.Transfer + expected.Array;
  check.That((report->GetNumber("UploadedBytes") > 0) == (sum > 0), what + ": bytes");
}

void TestCounters(Check& check)
{
  Show show;
  vtkImplicitFlowVolumeMapper* mapper = show.Mapper;
  vtkSmartPointer<vtkImageData> first = MakeStripes(20.0, 0.3);
  vtkSmartPointer<vtkImageData> second = MakeStripes(9.0, 0.6);
  mapper->SetInflowTexture(0, first);
  mapper->SetInflowTexture(8, second);
  const auto expect = [&](const Uploads& uploads, const std::string& what)
  { CheckUploads(check, show.Draw(), uploads, what); };
  // Cells, places and groups; two images and which surface has which.
  expect({ 3, 3, 0, 0, 0, 0 }, "the first picture");
  check.Near(
    mapper->GetReport()->GetNumber("Textures"), 6, 0.0, "textures without anything that is off");
  check.That(mapper->GetReport()->GetText("Features") == "splits surfaces paint_filter",
    "features: " + mapper->GetReport()->GetText("Features"));
  expect({}, "the same again");
  show.Camera->Azimuth(5.0);
  expect({}, "another view");
  second->GetPointData()->GetScalars()->SetComponent(3, 0, 0.9);
  second->GetPointData()->GetScalars()->Modified();
  second->Modified();
  expect({ 0, 1, 0, 0, 0, 0 }, "a changed image");
  mapper->SetInflowTexture(0, MakeStripes(5.0, 0.4));
  expect({ 0, 1, 0, 0, 0, 0 }, "another image");
  mapper->SetTimeGate(show.Gate);
  // The times are sent when they are needed first.
  expect({ 1, 0, 0, 1, 0, 0 }, "a gate");
  check.Near(mapper->GetReport()->GetNumber("Textures"), 8, 0.0, "textures with a gate");
  mapper->SetTimePhase(0.3);
  expect({}, "another phase");
  mapper->SetTimePeriod(0.7);
  expect({}, "another period");
  show.Gate->AddPoint(0.7, 0.8);
  expect({ 0, 0, 0, 1, 0, 0 }, "a changed gate");
  mapper->SetDetailTexture(MakeStripes(3.0, 0.9));
  expect({ 0, 0, 1, 0, 0, 0 }, "a detail");
  mapper->SetDetailModeToOver();
  expect({}, "another mode");
  mapper->SetDetailTexture(MakeBlock());
  expect({ 0, 0, 1, 0, 0, 0 }, "a detail of three dimensions in place of two");
  mapper->SetOpacityArray("Speed");
  expect({ 0, 0, 0, 0, 1, 1 }, "a further array");
  show.Property->GetScalarOpacity()->AddPoint(0.2, 0.4);
  expect({ 0, 0, 0, 0, 1, 0 }, "a changed transfer function");
  mapper->SetShadingArray("Ways");
  expect({}, "a shading array without Shade");
  show.Property->ShadeOn();
  expect({ 0, 0, 0, 0, 0, 1 }, "shading");
  mapper->SetTimeGate(nullptr);
  mapper->SetDetailTexture(nullptr);
  mapper->SetOpacityArray(nullptr);
  show.Property->ShadeOff();
  expect({}, "all off again");
  check.Near(mapper->GetReport()->GetNumber("Textures"), 6, 0.0, "textures with all off again");
  check.That(mapper->GetReport()->GetText("Features") == "splits surfaces paint_filter",
    "features with all off again: " + mapper->GetReport()->GetText("Features"));
  show.Voxels->GetPointData()->GetArray("AdvectionTime")->Modified();
  show.Voxels->Modified();
  expect({ 3, 0, 0, 0, 0, 0 }, "changed voxels");
}

/// Opacity by an array does not change if the array and the function move together.
void TestOpacityArray(Check& check)
{
  RgbaPicture pictures[2];
  for (const int isMoved : { 0, 1 })
  {
    Show show;
    show.Mapper->SetInflowTexture(0, MakeStripes(20.0, 0.3));
    const double shift = 40.0 * isMoved;
    vtkDataArray* speed = show.Voxels->GetPointData()->GetArray("Speed");
    double range[2];
    speed->GetRange(range);
    for (vtkIdType i = 0; i < speed->GetNumberOfTuples(); ++i)
    {
      speed->SetComponent(i, 0, speed->GetComponent(i, 0) + shift);
    }
    vtkPiecewiseFunction* opacity = show.Property->GetScalarOpacity();
    opacity->RemoveAllPoints();
    opacity->AddPoint(range[0] + shift, 0.0);
    opacity->AddPoint(range[1] + shift, 0.8);
    show.Mapper->SetOpacityArray("Speed");
    pictures[isMoved] = show.Stage.Capture();
  }
  const PictureError error = ComparePictures(pictures[1], pictures[0]);
  check.Near(error.Max, 0.0, 1e-3, "opacity array and function moved together", 1.0);
}

void TestRandom(Check& check)
{
  CheckRandomStates([] { return std::make_unique<Show>(); }, [](vtkInterlumeReport*) {}, check);
}

/// Images of other dimensions that share their arrays, which have changed after all of them, and
/// arrays of other ranges under one function that has: each as by a mapper made anew.
void TestShared(Check& check)
{
  const FlowFormula flow = [](const Place3& x) {
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
  const auto prepare = [](Show& show, vtkImageData* image, const char* opacity)
  {
    show.Camera =
      LookAt(Place3{ { image->GetCenter()[0], image->GetCenter()[1], image->GetCenter()[2] } },
        0.5 * image->GetLength(), { { -0.4, 0.6, -0.9 } }, false);
    show.Stage.SetCamera(show.Camera);
    show.Mapper->SetInflowTexture(0, MakeStripes(20.0, 0.5));
    show.Mapper->SetInputData(static_cast<vtkDataSet*>(image));
    show.Mapper->SetOpacityArray(opacity);
    show.Mapper->SetShadingArray(opacity);
    show.Property->ShadeOn();
  };
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, 0.9);
  function->AddPoint(5.0, 0.1);
  const auto draw = [&](Show& show, int step)
  {
    prepare(show, images[static_cast<std::size_t>(step) % images.size()],
      step % 2 == 0 ? "Slow" : "Fast");
    show.Property->SetScalarOpacity(function);
    return show.Stage.Capture();
  };
  std::vector<RgbaPicture> expected;
  for (int step = 0; step < 6; ++step)
  {
    Show anew;
    expected.push_back(draw(anew, step));
    check.That(LargestAlpha(expected.back()) > 0.2, "something is seen of shared arrays");
  }
  for (const char* name : { "Slow", "Fast" })
  {
    first->GetPointData()->GetArray(name)->Modified();
  }
  function->Modified();
  Show kept;
  for (const int step : { 0, 3, 1, 5, 2, 4, 1, 0, 3, 2 })
  {
    const double error =
      ComparePictures(draw(kept, step), expected[static_cast<std::size_t>(step)]).Max;
    check.Near(error, 0.0, 0.0, "shared arrays, step " + std::to_string(step), 1.0);
  }
}
}

int TestFlowVolumeChanges(int, char*[])
{
  return RunChecks({ TestCounters, TestOpacityArray, TestRandom, TestShared });
}
