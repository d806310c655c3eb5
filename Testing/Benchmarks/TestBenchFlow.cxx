// SPDX-License-Identifier: BSD-3-Clause
// Tests the references of the suite flow: streamlines of interpolated fields, analytic stream
// tubes, the flux through a disc, the explicit flow volume, and the end points of vtkStreamTracer.
#include "Benchmarks/Flow/ExplicitFlowVolume.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Flow/FlowReference.h"
#include "Benchmarks/Flow/FlowTubes.h"
#include "Benchmarks/Flow/TrilinearFlow.h"
#include "Benchmarks/Measures/TetrahedronSums.h"

#include "Support/AnalyticFlows/ReferenceFlow.h"
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using reference::Check;
using reference::FlowVector;

constexpr double Pi = 3.14159265358979323846;

vtkSmartPointer<vtkImageData> MakeImage(int points, const reference::FlowFunction& velocity)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetOrigin(-1.0, -1.0, -1.0);
  const double spacing = 2.0 / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  reference::SetVelocity(image, velocity);
  return image;
}

void TestTrilinearFlow(Check& check)
{
  // The kink of |x| is at a cell face. Along a streamline, y increases by the integral of |x|.
  const TrilinearFlow bent(MakeImage(5,
    [](const FlowVector& x) {
      return FlowVector{ { 1.0, std::abs(x[0]), 0.5 } };
    }));
  double x[3] = { -0.9, -0.3, -0.4 };
  bent.Follow(x, 1.5);
  check.Near(x[0], 0.6, 1e-13, "x across a kink");
  check.Near(x[1], -0.3 + 0.5 * (0.81 + 0.36), 1e-13, "y across a kink");
  check.Near(x[2], 0.35, 1e-13, "z across a kink");
  bent.Follow(x, -1.5);
  check.Near(x[1], -0.3, 1e-13, "y after tracing back");
  bent.Follow(x, 100.0);
  check.Near(x[0], 1.0, 1e-13, "the streamline ends at the boundary");

  const FlowVector axis = { { 0.3, -0.2, 1.0 } };
  const TrilinearFlow rotating(MakeImage(7,
    [&axis](const FlowVector& y) { return reference::Multiply(reference::CrossMatrix(axis), y); }));
  const FlowVector start = { { 0.4, 0.3, -0.2 } };
  const double rate = std::sqrt(1.13);
  const FlowVector end = reference::MapRotation(start, {}, axis, rate, 4.0);
  double position[3] = { start[0], start[1], start[2] };
  rotating.Follow(position, 4.0);
  for (std::size_t i = 0; i < 3; ++i)
  {
    check.Near(position[i], end[i], 1e-12, "rotation", 1.0);
  }
}

/// Compares a result that has known errors parallel and perpendicular to the streamline with the
/// exact result.
void TestDifference(Check& check)
{
  const auto seeds = flow::MakeSeeds(3, 0.1, 1);
  const flow::Reference exact(
    seeds, [](const double*, double* v) { std::fill_n(v, 3, 0.0), v[0] = 2.0; },
    [](double* x, double time) { x[0] += 2.0 * time; });
  flow::MethodResult result;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    flow::End end;
    end.HasResult = i != 1;
    end.Time = 0.25;
    seeds->GetPoint(i, end.Position.data());
    end.Position[0] -= 0.5 + 0.02;
    end.Position[1] += i == 0 ? 0.03 : 0.05;
    result.Ends.push_back(end);
  }
  const flow::Difference difference = exact.Compare(result, 1, 4.0 * std::hypot(0.02, 0.04));
  check.Near(difference.Mean, 0.04, 1e-12, "distance from the streamline");
  check.Near(difference.Time, 0.01, 1e-12, "error of the time");
  check.Near(difference.Within, 0.5, 0.0, "fraction within an error");
}

/// Tests that vtkStreamTracer stops after the step that leaves the box, and that GetTracerResult()
/// returns the last point inside the box.
void TestTracerEnds(Check& check)
{
  check.SetContext("end of vtkStreamTracer's streamlines");
  flow::Case flowCase;
  flowCase.Field = MakeImage(9, [](const FlowVector&) { return FlowVector{ { 1.0, 0.25, 0.0 } }; });
  flowCase.Seeds = flow::MakeSeeds(20, 0.3, 1);
  flowCase.Box = { { -0.6, 0.6, -0.6, 0.6, -0.6, 0.6 } };
  flowCase.IsBoxGrid = true;
  flow::TracerSettings settings;
  settings.Parameter = 0.125;
  const auto tracer = flow::NewTracer(flowCase, settings);
  tracer->Update();
  vtkPolyData* lines = tracer->GetOutput();
  vtkIdType outside = 0;
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    outside += lines->GetPoint(i)[0] < -0.6 ? 1 : 0;
  }
  check.Equal(outside, vtkIdType{ 20 }, "points outside, one per streamline");
  const flow::MethodResult result = flow::GetTracerResult(flowCase, tracer);
  for (const flow::End& end : result.Ends)
  {
    check.That(end.HasResult, "the sample has a result");
    // A step is at most an eighth of a cell diagonal long, and the last point is within one step of
    // the box face.
    check.Near(end.Position[0], -0.6, 0.055, "end point", 1.0);
  }
}

void TestTubes(Check& check)
{
  const auto tubes = flow::MakeTubes(8);
  const reference::Flow flows[] = { reference::Flow::Linear(
                                      { 1.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0, -0.5 }),
    reference::Flow::PotentialAroundSphere(), reference::Flow::PotentialAroundSphere() };
  for (std::size_t i = 0; i < tubes.size(); ++i)
  {
    const flow::Tube& tube = tubes[i];
    check.SetContext(tube.Name);
    const flow::Disk& disk = tube.Inflow;
    for (const double radius : { disk.Radius, 0.7 * disk.Radius })
    {
      const auto x = flows[i].Follow(
        { disk.X, disk.Y + radius * std::cos(1.0), disk.Z + radius * std::sin(1.0) }, tube.Time);
      check.Near(tube.GetExcess(x.data()), radius - disk.Radius, 1e-9, "origin", 1.0);
      check.That(!tube.IsShadow(x.data()), "the point is outside the shadow");
    }
  }
  // The expected flux through a disk of radius r follows from Stokes' stream function.
  check.SetContext("volume");
  check.Near(tubes[0].Volume, 2.0 * Pi * 0.36 * 0.1, 1e-6, "contraction");
  const auto speed = [](const double x[3])
  {
    double v[3];
    reference::Flow::PotentialAroundSphere().Velocity(x, v);
    return v[0];
  };
  const flow::Disk center = { -2.0, 0.0, 0.0, 1.5 };
  check.Near(
    center.Integrate(speed), Pi * 2.25 * (1.0 - 1.0 / 15.625), 1e-5, "flow around a sphere");
}

void TestExplicitVolume(Check& check)
{
  check.SetContext("explicit flow volume");
  ExplicitFlowVolume::Settings settings;
  settings.Rings = 5;
  settings.Layers = 3;
  const flow::Disk disk = { -0.8, 0.1, -0.1, 0.4 };
  const auto uniform = MakeImage(5,
    [](const FlowVector&) {
      return FlowVector{ { 1.0, 0.25, 0.0 } };
    });
  const ExplicitFlowVolume straight(uniform, disk, 1.2, settings);
  const auto grid = straight.MakeTetrahedra();
  // The cross section is a regular polygon with 30 vertices.
  check.Near(SumTetrahedra(grid).Volume, 15.0 * 0.16 * std::sin(Pi / 15.0) * 1.2, 1e-12, "volume");
  check.Near(SumTetrahedra(grid).Inverted, 0.0, 0.0, "inverted tetrahedra");
  // If the faces of adjacent prisms match, the surface consists of the faces of the first and last
  // layer and the sides.
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  check.Equal(surface->GetOutput()->GetNumberOfCells(),
    2 * grid->GetNumberOfCells() / (3 * settings.Layers) + 2 * 30 * settings.Layers,
    "boundary faces");
}
}

int main()
{
  Check check;
  TestTrilinearFlow(check);
  TestDifference(check);
  TestTracerEnds(check);
  TestTubes(check);
  TestExplicitVolume(check);
  return check.Result();
}
