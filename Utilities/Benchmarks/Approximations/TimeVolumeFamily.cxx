// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Benchmarks/Data/KeptTimeSteps.h"
#include "Benchmarks/Data/MovingFields.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"
#include "Pictures/PictureSettings.h"
#include "Pictures/ReferenceRay.h"
#include "Pictures/VolumeStage.h"

#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

#include "vtkAppendFilter.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace approximations
{
namespace
{
using interval4d::MovingField;
using Mapper = vtkTimeWeightedTetrahedraMapper;

/// The extinction in a unit of length and of time.
constexpr double Extinction = 1.2;
constexpr int MostSlabs = 12;
const std::array<double, 3> Color = { { 0.9, 0.6, 0.3 } };

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const double value : { -1.0, 1.0 })
  {
    color->AddRGBPoint(value, Color[0], Color[1], Color[2]);
    opacity->AddPoint(value, 1.0);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0 / Extinction);
  property->SetInterpolationTypeToLinear();
  return property;
}

/// The length of a line of sight within a ball around a place on the x-axis.
double GetChord(const reference::Ray& ray, double center, double radius)
{
  const double o[3] = { static_cast<double>(ray.Origin[0]) - center,
    static_cast<double>(ray.Origin[1]), static_cast<double>(ray.Origin[2]) };
  double along = 0.0;
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    along += o[axis] * static_cast<double>(ray.Direction[axis]);
    square += o[axis] * o[axis];
  }
  return 2.0 * std::sqrt(std::max(0.0, radius * radius - (square - along * along)));
}

/// The picture of the shell of the field `ball` over all its time, by the chords of its two spheres
/// at many times.
reference::RgbaPicture MakeExpected(vtkCamera* camera, int pixels)
{
  constexpr int times = 800;
  const double length = MovingField::LastTime - MovingField::FirstTime;
  reference::RgbaPicture picture(pixels, pixels);
  const reference::PixelRays rays(camera, { { pixels, pixels } });
  for (int j = 0; j < pixels; ++j)
  {
    for (int i = 0; i < pixels; ++i)
    {
      const reference::Ray ray = rays.Get(i, j);
      double depth = 0.0;
      for (int k = 0; k < times; ++k)
      {
        const double time = MovingField::FirstTime + (k + 0.5) * length / times;
        const double center = -0.5 + 0.5 * time;
        const double radius = 0.3 + 0.025 * time;
        depth += GetChord(ray, center, radius + 0.1) - GetChord(ray, center, radius - 0.1);
      }
      const double alpha = -std::expm1(-Extinction * depth * length / times);
      for (int c = 0; c < 4; ++c)
      {
        picture.At(i, j)[c] = alpha * (c < 3 ? Color[c] : 1.0);
      }
    }
  }
  return picture;
}

/// The interval volumes of all steps, each with the share of time that it stands for.
vtkSmartPointer<vtkUnstructuredGrid> AppendSteps(KeptTimeSteps* steps, double lower, double upper)
{
  vtkNew<vtkAppendFilter> all;
  const int last = steps->GetNumberOfSteps() - 1;
  for (int step = 0; step <= last; ++step)
  {
    auto region =
      methods::IntervalVolume(vtkDataSet::SafeDownCast(steps->GetStep(step)), lower, upper);
    vtkNew<vtkDoubleArray> extents;
    extents->SetName("DeltaT");
    extents->SetNumberOfTuples(region->GetNumberOfPoints());
    extents->Fill(
      (steps->GetTimeOf(1) - steps->GetTimeOf(0)) * (step == 0 || step == last ? 0.5 : 1.0));
    region->GetPointData()->AddArray(extents);
    all->AddInputData(region);
  }
  all->Update();
  return all->GetOutput();
}

void AddTimeVolumeRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const std::vector<MovingField> fields = interval4d::MakeMovingFields(options);
  const MovingField& ball = *std::find_if(
    fields.begin(), fields.end(), [](const MovingField& one) { return one.Name == "ball"; });
  const int pixels = options.Pick(192, 96, 24);
  auto camera = reference::LookAt({ { 0.0, 0.0, 0.0 } }, 1.1, { { -0.4, 0.6, -0.8 } }, false);
  const reference::RgbaPicture expected = MakeExpected(camera, pixels);
  reference::VolumeStage stage(std::array<int, 2>{ { pixels, pixels } });
  auto property = MakeProperty();
  const auto draw = [&](vtkUnstructuredGrid* grid)
  {
    vtkNew<Mapper> mapper;
    mapper->SetInputData(static_cast<vtkDataSet*>(grid));
    mapper->AutoAdjustLevelOfDetailOff();
    stage.SetVolume(mapper, property);
    stage.SetCamera(camera);
    return vtkSmartPointer<Mapper>(mapper);
  };
  Trials trials;
  trials.SetSize("pixels along an edge", pixels);
  const auto add = [&](const std::string& method, int points, bool isDefault,
                     const std::function<vtkSmartPointer<vtkUnstructuredGrid>()>& extract)
  {
    trials.Add(method, NumberText(points), isDefault ? Maker::Default : Maker::Own,
      WithThreads(options.Threads,
        [&draw, &stage, extract]()
        {
          const auto mapper = draw(extract());
          stage.Render();
          return vtkSmartPointer<vtkObjectBase>(mapper);
        }),
      [&draw, &stage, &expected, extract]()
      {
        const auto mapper = draw(extract());
        return reference::ComparePictures(stage.Capture(), expected).Mean;
      });
  };
  const auto sizes = options.Pick<std::vector<int>>({ 13, 17, 25, 33 }, { 9, 13, 17 }, { 7, 9 });
  ball.Source->SetTimeRange(MovingField::FirstTime, MovingField::LastTime);
  for (const int points : sizes)
  {
    ball.Source->SetDimensions(points, points, points);
    for (const int slabs : { 4, MostSlabs })
    {
      auto steps = vtkSmartPointer<KeptTimeSteps>::New();
      ball.Source->SetNumberOfTimeSteps(slabs + 1);
      steps->AddStepsOf(ball.Source);
      const std::string number = NumberText(slabs + 1) + " steps, ";
      const interval4d::Case what = { ball.Name, steps, ball.Lower, ball.Upper, {} };
      add(number + "in time", points, slabs == MostSlabs && points == sizes.back(),
        [what]()
        {
          auto filter = what.NewFilter();
          filter->Update();
          return vtkSmartPointer<vtkUnstructuredGrid>(filter->GetOutput());
        });
      add(number + "on each other", points, false,
        [what]() { return AppendSteps(what.Steps, what.Lower, what.Upper); });
    }
  }
  trials.Run(question, options, rows);
}
}

Family MakeTimeVolumeFamily()
{
  return { { "time-volume-pictures",
             "Volumes in time as pictures: error against time of extraction and a frame",
             "A volume in time, projected, or the volumes of the time steps on each other?",
             "A shell that moves and grows, points along an edge of the grid at each point, "
             "extracted and drawn by its extent in time; against the chords of its spheres.",
             "time of extraction and a frame (s)", "channel difference, mean" },
    AddTimeVolumeRows };
}
}
