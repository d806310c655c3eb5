// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Benchmarks/Data/KeptTimeSteps.h"
#include "Benchmarks/Data/MovingFields.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"
#include "Support/Pictures/PictureSettings.h"
#include "Support/Pictures/ReferenceRay.h"
#include "Support/Pictures/VolumeStage.h"

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

/// A shell between two spheres that moves along x and grows.
struct Shell
{
  double Center;
  double Velocity;
  double Radius;
  double Growth;
  double HalfWidth;
  /// The extinction in a unit of length and of time.
  double Extinction;
  /// Slabs of time of the data.
  std::vector<int> Slabs;
};

/// From one of 13 steps to the next it moves by less than half of its thickness.
const Shell Slow = { -0.5, 0.5, 0.3, 0.025, 0.1, 1.2, { 4, 12 } };
/// From one of 3 steps to the next it grows by four times its thickness.
const Shell Fast = { 0.0, 0.0, 0.2, 0.24, 0.03, 8.0, { 2 } };

const std::array<double, 3> Color = { { 0.9, 0.6, 0.3 } };

vtkSmartPointer<vtkVolumeProperty> MakeProperty(double extinction)
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
  property->SetScalarOpacityUnitDistance(1.0 / extinction);
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

/// The picture of a shell over all its time, by the chords of its two spheres at many times.
reference::RgbaPicture MakeExpected(const Shell& shell, vtkCamera* camera, int pixels)
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
        const double center = shell.Center + shell.Velocity * time;
        const double radius = shell.Radius + shell.Growth * time;
        depth += GetChord(ray, center, radius + shell.HalfWidth) -
          GetChord(ray, center, radius - shell.HalfWidth);
      }
      const double alpha = -std::expm1(-shell.Extinction * depth * length / times);
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

/// The field whose values are how far a place is from the middle of a shell.
vtkSmartPointer<vtkAnalyticFieldSource> MakeSource(const Shell& shell)
{
  auto source = vtkSmartPointer<vtkAnalyticFieldSource>::New();
  source->SetField(vtkAnalyticFieldSource::BALL);
  source->SetOutputScalarType(VTK_DOUBLE);
  source->SetTimeRange(MovingField::FirstTime, MovingField::LastTime);
  source->SetCenter(shell.Center, 0.0, 0.0);
  source->SetVelocity(shell.Velocity, 0.0, 0.0);
  source->SetRadius(shell.Radius);
  source->SetGrowth(shell.Growth);
  return source;
}

void AddShellRows(
  const Shell& shell, const Question& question, const BenchOptions& options, BenchRows& rows)
{
  auto source = MakeSource(shell);
  const int pixels = options.Pick(192, 96, 24);
  auto camera = reference::LookAt({ { 0.0, 0.0, 0.0 } }, 1.1, { { -0.4, 0.6, -0.8 } }, false);
  const reference::RgbaPicture expected = MakeExpected(shell, camera, pixels);
  reference::VolumeStage stage(std::array<int, 2>{ { pixels, pixels } });
  auto property = MakeProperty(shell.Extinction);
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
  // With fewer than 25 points the error is the grid's, and no way in time makes it smaller.
  const auto sizes = options.Pick<std::vector<int>>({ 13, 17, 25, 33 }, { 9, 17, 25 }, { 7, 9 });
  for (const int points : sizes)
  {
    source->SetDimensions(points, points, points);
    for (const int slabs : shell.Slabs)
    {
      auto steps = vtkSmartPointer<KeptTimeSteps>::New();
      source->SetNumberOfTimeSteps(slabs + 1);
      steps->AddStepsOf(source);
      const std::string number = NumberText(slabs + 1) + " steps, ";
      const interval4d::Case what = { question.Name, steps, -shell.HalfWidth, shell.HalfWidth, {} };
      add(number + "in time", points, slabs == shell.Slabs.back() && points == sizes.back(),
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
  trials.Run(question, options, rows, ClockOf(stage.GetWindow()));
}

void AddSlowRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  AddShellRows(Slow, question, options, rows);
}

void AddFastRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  AddShellRows(Fast, question, options, rows);
}

const char* const TimeLabel = "time of extraction and a frame (s)";
const char* const Norm = "channel difference, mean";
}

Family MakeTimeVolumeFamily()
{
  return { { "time-volume-pictures",
             "Volumes in time as pictures: error against time of extraction and a frame",
             "A volume in time, projected, or the volumes of the time steps on each other?",
             "A shell that moves and grows, points along an edge of the grid at each point, "
             "extracted and drawn by its extent in time; against the chords of its spheres. It "
             "moves by less than half of its thickness between two of 13 steps, so that these may "
             "as well be drawn on each other, of several times fewer tetrahedra, until the grid is "
             "so fine that its error is less than that of the steps.",
             TimeLabel, Norm },
    AddSlowRows };
}

Family MakeFastTimeVolumeFamily()
{
  return { { "time-volume-fast-pictures",
             "Fast volumes in time as pictures: error against time of extraction and a frame",
             "And where what is in the volume moves by more than its thickness between two steps?",
             "A shell that grows by four times its thickness between two of 3 steps; else as "
             "before. Steps on each other are shells apart, which more points do not mend, so that "
             "volumes in time are what is made where nobody asks for anything.",
             TimeLabel, Norm },
    AddFastRows };
}
}
