// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Support/AnalyticFlows/ReferenceFlowResults.h"

#include "vtkFlowCriticalPoints.h"
#include "vtkFlowVolume.h"
#include "vtkInflowMapping.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkTerminationPlane.h"
#include "vtkVortexAxis.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVectorFieldTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace approximations
{
namespace
{
using Vector = std::array<double, 3>;

const char* const TimeLabel = "run time (s)";

/// Samples \a velocity at points^3 points in the cube [-1, 1]^3.
vtkSmartPointer<vtkImageData> SampleFlow(
  int points, const std::function<Vector(const Vector&)>& velocity)
{
  auto image =
    reference::MakeFlowImage({ { points, points, points } }, { { -1, 1, -1, 1, -1, 1 } });
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Velocity");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    Vector x;
    image->GetPoint(id, x.data());
    vectors->SetTuple(id, velocity(x).data());
  }
  image->GetPointData()->SetVectors(vectors);
  return image;
}

constexpr double Wave = 4.1;
const Vector Phase = { { 0.7, -0.4, 1.1 } };

/// Returns a velocity that combines waves along all axes. It is zero where all three waves are
/// zero.
Vector Waves(const Vector& x)
{
  const double a = std::sin(Wave * x[0] + Phase[0]);
  const double b = std::sin(Wave * x[1] + Phase[1]);
  const double c = std::sin(Wave * x[2] + Phase[2]);
  return { { a, b + 0.4 * a, c + 0.3 * b * (1.0 + 0.5 * a) } };
}

/// Returns the coordinates, inside the cube, at which the wave along an axis is zero.
std::vector<double> ZerosAlong(int axis)
{
  std::vector<double> zeros;
  for (int k = -5; k <= 5; ++k)
  {
    const double x = (k * vtkMath::Pi() - Phase[axis]) / Wave;
    if (std::abs(x) < 1.0)
    {
      zeros.push_back(x);
    }
  }
  return zeros;
}

/// Returns the mean distance from a zero of Waves() to the nearest point of \a found. Distances are
/// limited to 0.25, so a missed zero counts as 0.25.
double MeasureZeros(vtkPolyData* found)
{
  constexpr double maximum = 0.25;
  double sum = 0.0;
  int number = 0;
  for (const double x : ZerosAlong(0))
  {
    for (const double y : ZerosAlong(1))
    {
      for (const double z : ZerosAlong(2))
      {
        double nearest = maximum;
        for (vtkIdType id = 0; id < found->GetNumberOfPoints(); ++id)
        {
          double point[3];
          found->GetPoint(id, point);
          nearest = std::min(nearest, std::hypot(point[0] - x, point[1] - y, point[2] - z));
        }
        sum += nearest;
        ++number;
      }
    }
  }
  return sum / number;
}

void AddCriticalPointRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const auto sizes =
    options.Pick<std::vector<int>>({ 9, 17, 33, 65, 129 }, { 9, 17, 33, 49 }, { 7, 9 });
  Trials trials;
  trials.SetSize("critical points",
    static_cast<double>(ZerosAlong(0).size() * ZerosAlong(1).size() * ZerosAlong(2).size()));
  for (const int points : sizes)
  {
    auto image = SampleFlow(points, Waves);
    auto own = vtkSmartPointer<vtkFlowCriticalPoints>::New();
    own->SetInputData(image);
    trials.Add("vtkFlowCriticalPoints", NumberText(points),
      points == sizes.back() ? Maker::Default : Maker::Own, WithThreads(1, MakeRerunWork(own)),
      [own]() { return MeasureZeros(own->GetOutput()); });
    auto baseline = vtkSmartPointer<vtkVectorFieldTopology>::New();
    baseline->SetInputData(image);
    // Separatrices are not compared. They cannot be switched off, so they are limited to one step.
    baseline->SetMaxNumSteps(1);
    trials.Add("vtkVectorFieldTopology", NumberText(points), Maker::Baseline,
      WithThreads(1, MakeRerunWork(baseline)),
      [baseline]()
      { return MeasureZeros(vtkPolyData::SafeDownCast(baseline->GetOutputDataObject(0))); });
  }
  trials.Run(question, options, rows);
}

/// Returns the center of the vortex at a height.
std::array<double, 2> AxisAt(double z)
{
  return { { 0.3 * std::sin(2.0 * z), 0.2 * std::cos(3.0 * z) } };
}

/// Returns the velocity of a vortex around a curved axis, with a Gaussian speed profile.
Vector BentVortex(const Vector& x)
{
  const std::array<double, 2> axis = AxisAt(x[2]);
  const double a = x[0] - axis[0];
  const double b = x[1] - axis[1];
  const double speed = std::exp(-3.0 * (a * a + b * b)) * (1.0 + 0.5 * a);
  return { { -speed * b, speed * a, 0.5 } };
}

/// Returns the mean distance of a polyline from the axis at equidistant heights, with linear
/// interpolation between its points. The distance counts as 1 at heights that the polyline does not
/// reach.
double MeasureAxis(vtkPolyData* line)
{
  constexpr int heights = 400;
  std::vector<Vector> points(static_cast<std::size_t>(line->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    line->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::sort(points.begin(), points.end(),
    [](const Vector& first, const Vector& second) { return first[2] < second[2]; });
  double sum = 0.0;
  for (int k = 0; k < heights; ++k)
  {
    const double z = 2.0 * (k + 0.5) / heights - 1.0;
    const auto above = std::find_if(
      points.begin(), points.end(), [z](const Vector& point) { return point[2] >= z; });
    if (above == points.begin() || above == points.end())
    {
      sum += 1.0;
      continue;
    }
    const Vector& below = *(above - 1);
    const double fraction = (z - below[2]) / ((*above)[2] - below[2]);
    const std::array<double, 2> axis = AxisAt(z);
    sum += std::hypot(below[0] + fraction * ((*above)[0] - below[0]) - axis[0],
      below[1] + fraction * ((*above)[1] - below[1]) - axis[1]);
  }
  return sum / heights;
}

void AddVortexAxisRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const auto sizes =
    options.Pick<std::vector<int>>({ 9, 17, 33, 65, 129 }, { 9, 17, 33, 49 }, { 7, 9 });
  Trials trials;
  for (const int points : sizes)
  {
    auto image = SampleFlow(points, BentVortex);
    for (const int planes : { 0, 5 })
    {
      auto filter = vtkSmartPointer<vtkVortexAxis>::New();
      filter->SetInputData(image);
      filter->SetNumberOfPlanes(planes);
      trials.Add(planes == 0 ? "a plane for each layer" : "five planes", NumberText(points),
        planes == 0 && points == sizes.back() ? Maker::Default : Maker::Own,
        WithThreads(1, MakeRerunWork(filter)),
        [filter]() { return MeasureAxis(filter->GetOutput()); });
    }
  }
  trials.Run(question, options, rows);
}

constexpr double Radius = 0.3;

/// A stream surface through a circle on a plane, in uniform flow.
struct RoundSurface
{
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;
  vtkNew<vtkTerminationPlane> Inflow;
  vtkSmartPointer<vtkStreamSurfaceParameters> Parameters =
    vtkSmartPointer<vtkStreamSurfaceParameters>::New();

  RoundSurface(vtkImageData* flow, int resolution)
  {
    this->Mapping->SetInputData(flow);
    this->Mapping->SetFormula(vtkInflowMapping::ALL, "(u-0.5)*(u-0.5)+(v-0.5)*(v-0.5)");
    this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
    this->Volume->SetStreamSurface(0, Radius * Radius);
    this->Volume->GenerateStreamSurfacesOn();
    this->Parameters->SetInputConnection(this->Volume->GetOutputPort(1));
    this->Parameters->SetMapping(this->Mapping);
    this->Inflow->SetOrigin(0.0, 0.0, 0.0);
    this->Inflow->SetPoint1(0.0, 1.0, 0.0);
    this->Inflow->SetPoint2(0.0, 0.0, 1.0);
    this->Parameters->AddTerminationSurface(this->Inflow, 0);
    this->Parameters->SetResolution(resolution);
  }
};

/// Returns the mean difference between the texture coordinate s and the arc length along the circle
/// at the points of the triangles, as a fraction of the circumference. The start and orientation of
/// a contour are arbitrary, so the better orientation is used and the mean offset is removed.
double MeasureArcs(vtkPolyData* surface)
{
  vtkDataArray* texture = surface->GetPointData()->GetArray("StreamTexture");
  const double turn = 2.0 * vtkMath::Pi();
  double smallest = std::numeric_limits<double>::infinity();
  for (const double sense : { 1.0, -1.0 })
  {
    std::vector<double> angles;
    double sine = 0.0;
    double cosine = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; texture && cell < surface->GetNumberOfCells(); ++cell)
    {
      surface->GetCellPoints(cell, ids);
      for (const vtkIdType id : *ids)
      {
        double x[3];
        surface->GetPoint(id, x);
        angles.push_back(
          texture->GetComponent(id, 0) / Radius - sense * std::atan2(x[2] - 0.5, x[1] - 0.5));
        sine += std::sin(angles.back());
        cosine += std::cos(angles.back());
      }
    }
    const double start = std::atan2(sine, cosine);
    double sum = 0.0;
    for (const double angle : angles)
    {
      sum += std::abs(std::remainder(angle - start, turn));
    }
    if (!angles.empty())
    {
      smallest = std::min(smallest, sum / (turn * static_cast<double>(angles.size())));
    }
  }
  return smallest;
}

void AddStreamSurfaceRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int points = options.Pick(96, 48, 16);
  auto flow = reference::MakeFlowImage({ { 5, points, points } }, { { 0, 1, 0, 1, 0, 1 } });
  reference::AddFlow(flow, reference::UniformFlow(0.5), { { { 0, 0, 0 } } });
  Trials trials;
  trials.SetSize("samples across the flow", points);
  std::vector<std::unique_ptr<RoundSurface>> surfaces;
  const int usual = vtkSmartPointer<vtkStreamSurfaceParameters>::New()->GetResolution();
  for (const int resolution : options.Pick<std::vector<int>>(
         { 8, 16, 32, 64, 128, 256, 512, 1024 }, { 8, 32, 128, 256, 1024 }, { 8, 256 }))
  {
    surfaces.push_back(std::make_unique<RoundSurface>(flow, resolution));
    const auto filter = surfaces.back()->Parameters;
    trials.Add("vtkStreamSurfaceParameters", NumberText(resolution),
      resolution == usual ? Maker::Default : Maker::Own, WithThreads(1, MakeRerunWork(filter)),
      [filter]() { return MeasureArcs(filter->GetOutput()); });
  }
  trials.Run(question, options, rows);
}
}

Family MakeCriticalPointFamily()
{
  return { { "critical-points", "Critical points: error against run time as the grid gets finer",
             "How accurately are the zeros of a sampled flow located?",
             "Waves with known zeros on images; labels are points along an edge. The baseline is "
             "vtkVectorFieldTopology with separatrices of one step; 1 thread.",
             TimeLabel, "mean distance of a zero from the nearest point, at most 0.25" },
    AddCriticalPointRows };
}

Family MakeVortexAxisFamily()
{
  return {
    { "vortex-axis", "The axis of a vortex: error against run time as the grid gets finer",
      "How accurately is the axis of a sampled vortex located?",
      "A vortex around a curved axis on images; labels are points along an edge. The polyline is "
      "compared with the exact axis at equidistant heights; 1 thread.",
      TimeLabel, "mean distance from the axis (unit of length)" },
    AddVortexAxisRows
  };
}

Family MakeStreamSurfaceFamily()
{
  return { { "stream-surface-resolution",
             "Parameters of stream surfaces: error against run time, 1 thread",
             "Which grid resolution is sufficient for tracing inflow contours?",
             "A stream surface through a circle; labels are values of Resolution. s is compared "
             "with the arc length of the circle.",
             TimeLabel, "mean difference of s, share of the contour's length" },
    AddStreamSurfaceRows };
}
}
