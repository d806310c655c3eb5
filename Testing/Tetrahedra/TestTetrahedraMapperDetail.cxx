// SPDX-License-Identifier: BSD-3-Clause
// Tests images during interaction and progressive images: brightness and opacity against the image
// at rest, the image at rest after interaction, changes in random order against a new mapper, and
// the level of detail of new meshes.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderWindow.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr std::array<int, 2> SIZE = { { 120, 96 } };
constexpr std::array<int, 5> BLENDS = { { Mapper::COMPOSITE_BLEND, Mapper::MAXIMUM_INTENSITY_BLEND,
  Mapper::ADDITIVE_BLEND, Mapper::PRIORITY_BLEND, Mapper::OPTICAL_DEPTH_BLEND } };
constexpr double STILL = 1e-4;
/// No level of detail is fast enough, so the coarsest one is drawn.
constexpr double FASTEST = 1e9;

/// Input and settings of a mapper.
struct State
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkVolumeProperty> Property = MakeRamp(0.1, 1.0, 0.25);
  Point3 Direction{ { 0.3, -0.4, 1.0 } };
  double Zoom = 1.0;
  bool IsParallel = false;
  int Blend = Mapper::AUTOMATIC_BLEND;
  int Path = Mapper::SOFTWARE_PATH;
  double Rate = STILL;
  vtkNew<vtkPlaneCollection> Planes;
};

/// A mesh of 5 n^3 tetrahedra that becomes finer toward one side.
vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(int cells, bool hasTime)
{
  auto grid = MakeCube(cells);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    double x[3];
    points->GetPoint(p, x);
    x[0] = std::pow(x[0], 1.5);
    points->SetPoint(p, x);
  }
  if (hasTime)
  {
    AddLinearArray(grid, "DeltaT", 0.5, { { 0.0, 0.5, 1.0 } });
  }
  AddSlabIndices(grid, "IntervalId", 2, 3);
  return grid;
}

vtkSmartPointer<vtkVolumeProperty> MakePeak(double unitDistance)
{
  auto property = MakeRamp(0.0, 1.0, unitDistance);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.4, 0.0);
  opacity->AddPoint(0.5, 1.0);
  opacity->AddPoint(0.6, 0.0);
  opacity->AddPoint(1.0, 0.0);
  property->SetScalarOpacity(opacity);
  return property;
}

RgbaImage Draw(VolumeStage& stage, Mapper* mapper, State& state)
{
  mapper->SetInputData(static_cast<vtkDataSet*>(state.Grid));
  mapper->SetRenderPath(state.Path);
  mapper->SetBlendMode(state.Blend);
  mapper->SetClippingPlanes(state.Planes);
  stage.SetVolume(mapper, state.Property);
  auto camera = LookAt(state.Grid, state.Direction, state.IsParallel);
  camera->Zoom(state.Zoom);
  stage.SetCamera(camera);
  stage.GetWindow()->SetDesiredUpdateRate(state.Rate);
  return stage.Capture();
}

RgbaImage DrawFresh(State& state)
{
  VolumeStage stage(SIZE);
  vtkNew<Mapper> mapper;
  return Draw(stage, mapper, state);
}

std::array<double, 4> GetMean(const RgbaImage& image)
{
  std::array<double, 4> mean{};
  for (std::size_t i = 0; i < image.Values.size(); ++i)
  {
    mean[i % 4] += 4.0 * image.Values[i] / static_cast<double>(image.Values.size());
  }
  return mean;
}

void TestBrightness(Check& check, int path, int cells, const std::vector<int>& functions)
{
  for (const bool hasTime : { false, true })
  {
    State state;
    state.Path = path;
    state.Grid = MakeMesh(cells, hasTime);
    for (const int blend : BLENDS)
    {
      for (const int function : functions)
      {
        state.Blend = blend;
        state.Property = function == 0 ? MakeRamp(0.1, 1.0, 4.0)
          : function == 1              ? MakeRamp(1.0, 1.0, 0.25)
                                       : MakePeak(0.5);
        const std::string name = GetPathName(path) + ", blend " + std::to_string(blend) +
          ", function " + std::to_string(function) + (hasTime ? ", in time: " : ": ");
        VolumeStage stage(SIZE);
        vtkNew<Mapper> mapper;
        state.Rate = STILL;
        const RgbaImage still = Draw(stage, mapper, state);
        const auto expected = GetMean(still);
        state.Rate = FASTEST;
        const RgbaImage coarse = Draw(stage, mapper, state);
        check.That(mapper->GetReport()->GetNumber("TetrahedraDrawn") <
            mapper->GetReport()->GetNumber("Tetrahedra"),
          name + "a subset is drawn");
        check.That(mapper->GetReport()->GetNumber("PixelStride") > 1, name + "fewer pixels");
        const auto found = GetMean(coarse);
        for (int c = 0; c < 4; ++c)
        {
          // A maximum grows less than linearly with the covered area.
          const double tolerance = blend == Mapper::MAXIMUM_INTENSITY_BLEND ? 0.1 : 0.04;
          check.Near(found[c], expected[c], tolerance, name + "channel " + std::to_string(c), 0.05);
        }
        check.That(
          Draw(stage, mapper, state).Values == coarse.Values, name + "no flicker at one level");
        state.Rate = STILL;
        check.That(Draw(stage, mapper, state).Values == still.Values, name + "still again");
        check.Equal(mapper->GetReport()->GetCount("PixelStride"), 1, name + "all pixels");
        check.Equal(mapper->GetReport()->GetCount("TetrahedronStride"), 1, name + "all tetrahedra");
      }
    }
  }
}

/// Changes one part of the state.
void Change(State& state, std::mt19937& random)
{
  const auto pick = [&random](int number) { return static_cast<int>(random() % number); };
  switch (pick(8))
  {
    case 0:
      state.Property = pick(2) ? MakeRamp(0.1 * pick(5), 1.0, 0.5) : MakePeak(0.1 + pick(2));
      break;
    case 1:
      state.Direction = { { 0.1 + pick(5), -0.4, 1.0 } };
      break;
    case 2:
      state.Zoom = 0.5 + pick(3);
      break;
    case 3:
      state.IsParallel = !state.IsParallel;
      break;
    case 4:
      state.Grid = MakeMesh(std::array<int, 4>{ { 1, 2, 17, 20 } }[pick(4)], pick(2) == 1);
      break;
    case 5:
      state.Blend = pick(6);
      break;
    case 6:
      state.Planes->RemoveAllItems();
      if (pick(2))
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.3 + 0.1 * pick(4), 0.5, 0.5);
        plane->SetNormal(1.0, 0.2, pick(3));
        state.Planes->AddItem(plane);
      }
      break;
    default:
      vtkDataArray* scalars = state.Grid->GetPointData()->GetArray("f");
      for (vtkIdType p = 0; p < scalars->GetNumberOfTuples(); ++p)
      {
        scalars->SetComponent(p, 0, 1.1 - scalars->GetComponent(p, 0));
      }
      scalars->Modified();
      state.Grid->Modified();
  }
}

void TestChanges(Check& check, int path, int changes)
{
  std::mt19937 random(7);
  State state;
  state.Path = path;
  state.Grid = MakeMesh(20, false);
  VolumeStage stage(SIZE);
  vtkNew<Mapper> mapper;
  for (int i = 0; i < changes; ++i)
  {
    Change(state, random);
    state.Rate = random() % 3 ? FASTEST : STILL;
    check.That(Draw(stage, mapper, state).Values == DrawFresh(state).Values,
      GetPathName(path) + ": after change " + std::to_string(i) +
        ", the image equals that of a new mapper");
  }
}

/// Renders until the image is final, and returns it.
RgbaImage DrawRefined(VolumeStage& stage, Mapper* mapper, State& state, Check& check)
{
  RgbaImage image = Draw(stage, mapper, state);
  for (int pass = 0; mapper->GetRefinementPending() && pass < 3; ++pass)
  {
    image = stage.Capture();
  }
  check.That(!mapper->GetRefinementPending(), "the image becomes final");
  return image;
}

/// Tests that refined images equal those of a new mapper after changes in random order.
void TestRefinement(Check& check, int path, int changes)
{
  std::mt19937 random(11);
  State state;
  state.Path = path;
  state.Grid = MakeMesh(20, false);
  VolumeStage stage(SIZE);
  vtkNew<Mapper> mapper;
  mapper->ProgressiveRenderingOn();
  int coarse = 0;
  for (int i = 0; i < changes; ++i)
  {
    Change(state, random);
    state.Rate = FASTEST;
    Draw(stage, mapper, state);
    coarse += mapper->GetRefinementPending() ? 1 : 0;
    state.Rate = STILL;
    check.That(DrawRefined(stage, mapper, state, check).Values == DrawFresh(state).Values,
      GetPathName(path) + ": the refined image after change " + std::to_string(i));
    stage.Capture();
    check.Equal(mapper->GetReport()->GetCount("UploadedImageBytes"), 0, "nothing is drawn again");
  }
  check.That(coarse > changes / 2, "coarse images are drawn");
}

/// Tests the first image of a large mesh, which is drawn before the mesh is built.
void TestSample(Check& check, bool hasTime)
{
  State state;
  state.Grid = MakeMesh(46, hasTime);
  state.Property = MakePeak(0.5);
  const std::string name = hasTime ? "sample in time: " : "sample: ";
  VolumeStage stage(SIZE);
  vtkNew<Mapper> mapper;
  mapper->ProgressiveRenderingOn();
  state.Rate = FASTEST;
  const auto found = GetMean(Draw(stage, mapper, state));
  check.That(mapper->GetRefinementPending(), name + "the image is not final");
  check.Equal(mapper->GetReport()->GetCount("Tetrahedra"),
    static_cast<int>(state.Grid->GetNumberOfCells()), name + "tetrahedra of the input");
  check.That(mapper->GetReport()->GetNumber("TetrahedraDrawn") < 100000, name + "few are drawn");
  state.Rate = STILL;
  const RgbaImage final = DrawRefined(stage, mapper, state, check);
  VolumeStage freshStage(SIZE);
  vtkNew<Mapper> fresh;
  check.That(final.Values == Draw(freshStage, fresh, state).Values, name + "the final image");
  const auto memory = [](Mapper* drawn) { return drawn->GetReport()->GetNumber("MemoryBytes"); };
  check.That(memory(mapper) > memory(fresh), name + "memory of the sample");
  mapper->ProgressiveRenderingOff();
  Draw(stage, mapper, state);
  check.Near(memory(mapper), memory(fresh), 0.0, name + "memory with the setting off again");
  const auto expected = GetMean(final);
  for (int c = 0; c < 4; ++c)
  {
    check.Near(found[c], expected[c], 0.05, name + "channel " + std::to_string(c), 0.05);
  }
}

void TestEmpty(Check& check, int path)
{
  State state;
  state.Path = path;
  state.Rate = FASTEST;
  VolumeStage stage(SIZE);
  vtkNew<Mapper> mapper;
  state.Grid = MakeMesh(20, false);
  state.Property = MakeRamp(0.0, 0.0, 1.0);
  const auto isBlank = [&]()
  {
    const RgbaImage image = Draw(stage, mapper, state);
    return std::all_of(image.Values.begin(), image.Values.end(), [](float x) { return x == 0.0f; });
  };
  check.That(isBlank(), "transparent mesh");
  check.Equal(mapper->GetReport()->GetCount("TetrahedraDrawn"), 0, "no tetrahedra are drawn");
  state.Property = MakeRamp(1.0, 1.0, 1.0);
  check.That(!isBlank(), "opaque mesh");
  auto empty = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mapper->SetInputData(static_cast<vtkDataSet*>(empty));
  stage.Capture();
  check.Equal(mapper->GetReport()->GetCount("TetrahedraDrawn"), 0, "empty mesh");
  check.That(!isBlank(), "opaque mesh again");
  // All values are NaN.
  vtkDataArray* scalars = state.Grid->GetPointData()->GetArray("f");
  for (vtkIdType p = 0; p < scalars->GetNumberOfTuples(); ++p)
  {
    scalars->SetComponent(p, 0, vtkMath::Nan());
  }
  state.Grid->Modified();
  check.That(isBlank(), "mesh without finite values");
}

/// Tests that the measured time of a mesh determines the detail of the next one. Few tetrahedra
/// that fill a large window take longer than estimated.
void TestNewMeshes(Check& check)
{
  State state;
  state.Rate = 1000.0;
  const std::array<int, 2> size{ { 1000, 800 } };
  VolumeStage stage(size);
  vtkNew<Mapper> mapper;
  const auto draw = [&](vtkSmartPointer<vtkUnstructuredGrid> grid)
  {
    state.Grid = grid;
    Draw(stage, mapper, state);
    return mapper->GetReport()->GetCount("PixelStride");
  };
  const auto first = MakeCube(1);
  check.Equal(draw(first), 1, "estimate: full detail");
  check.Equal(draw(first), 4, "measured: reduced");
  check.Equal(draw(MakeBox({ { 1, 1, 1 } })), 4, "a similar mesh: reduced");
  check.Equal(draw(MakeBox({ { 2, 2, 2 } })), 1, "a larger mesh: estimate");
}

/// Tests that a mapper whose frames are all still uses no memory for subsets.
void TestMemory(Check& check)
{
  State state;
  state.Grid = MakeMesh(20, false);
  VolumeStage stage(SIZE);
  vtkNew<Mapper> mapper;
  Draw(stage, mapper, state);
  const auto still = mapper->GetReport()->GetNumber("MemoryBytes");
  mapper->AutoAdjustLevelOfDetailOff();
  state.Rate = FASTEST;
  Draw(stage, mapper, state);
  check.Near(mapper->GetReport()->GetNumber("MemoryBytes"), still, 0.0, "memory without subsets");
  mapper->AutoAdjustLevelOfDetailOn();
  Draw(stage, mapper, state);
  check.That(mapper->GetReport()->GetNumber("MemoryBytes") > still, "memory with a subset");
}
}

int TestTetrahedraMapperDetail(int, char*[])
{
  Check check;
  TestBrightness(check, Mapper::SOFTWARE_PATH, 32, { 0, 1, 2 });
  TestBrightness(check, Mapper::OPENGL_PATH, 20, { 1 });
  TestChanges(check, Mapper::SOFTWARE_PATH, 30);
  TestChanges(check, Mapper::OPENGL_PATH, 12);
  TestRefinement(check, Mapper::SOFTWARE_PATH, 20);
  TestRefinement(check, Mapper::OPENGL_PATH, 8);
  TestSample(check, false);
  TestSample(check, true);
  TestEmpty(check, Mapper::SOFTWARE_PATH);
  TestEmpty(check, Mapper::OPENGL_PATH);
  TestNewMeshes(check);
  TestMemory(check);
  return check.Result();
}
