// SPDX-License-Identifier: BSD-3-Clause
// What the rows of the suite flow are measured with: streamlines of interpolated fields, tubes by
// formulas, the flux through a disc, the explicit flow volume, where the peer ends.
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
  // |x| has its kink at a face: y grows by the integral of |x|.
  const TrilinearFlow bent(MakeImage(5,
    [](const FlowVector& x) {
      return FlowVector{ { 1.0, std::abs(x[0]), 0.5 } };
    }));
  double x[3] = { -0.9, -0.3, -0.4 };
  bent.Follow(x, 1.5);
  check.Near(x[0], 0.6, 1e-13, "x over a kink");
  check.Near(x[1], -0.3 + 0.5 * (0.81 + 0.36), 1e-13, "y over a kink");
  check.Near(x[2], 0.35, 1e-13, "z over a kink");
  bent.Follow(x, -1.5);
  check.Near(x[1], -0.3, 1e-13, "y, and back");
  bent.Follow(x, 100.0);
  check.Near(x[0], 1.0, 1e-13, "the last face");

  const FlowVector axis = { { 0.3, -0.2, 1.0 } };
  const TrilinearFlow turning(MakeImage(7,
    [&axis](const FlowVector& y) { return reference::Multiply(reference::CrossMatrix(axis), y); }));
  const FlowVector start = { { 0.4, 0.3, -0.2 } };
  const double rate = std::sqrt(1.13);
  const FlowVector end = reference::MapRotation(start, {}, axis, rate, 4.0);
  double place[3] = { start[0], start[1], start[2] };
  turning.Follow(place, 4.0);
  for (std::size_t i = 0; i < 3; ++i)
  {
    check.Near(place[i], end[i], 1e-12, "rotation", 1.0);
  }
}

/// An answer that is off by known amounts along the streamline and across it.
void TestDifference(Check& check)
{
  const auto seeds = flow::MakeSeeds(3, 0.1, 1);
  const flow::Reference exact(
    seeds, [](const double*, double* v) { std::fill_n(v, 3, 0.0), v[0] = 2.0; },
    [](double* x, double time) { x[0] += 2.0 * time; });
  flow::Answer answer;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    flow::End end;
    end.HasAnswer = i != 1;
    end.Time = 0.25;
    seeds->GetPoint(i, end.Place.data());
    end.Place[0] -= 0.5 + 0.02;
    end.Place[1] += i == 0 ? 0.03 : 0.05;
    answer.Ends.push_back(end);
  }
  const flow::Difference apart = exact.Compare(answer, 1, 4.0 * std::hypot(0.02, 0.04));
  check.Near(apart.Mean, 0.04, 1e-12, "distance from the streamline");
  check.Near(apart.Time, 0.01, 1e-12, "error of the time");
  check.Near(apart.Within, 0.5, 0.0, "share within an error");
}

/// vtkStreamTracer takes no step after the one that leaves the box, as ours takes none.
void TestTracerEnds(Check& check)
{
  check.SetContext("end of the peer's streamlines");
  flow::Case what;
  what.Field = MakeImage(9, [](const FlowVector&) { return FlowVector{ { 1.0, 0.25, 0.0 } }; });
  what.Seeds = flow::MakeSeeds(20, 0.3, 1);
  what.Box = { { -0.6, 0.6, -0.6, 0.6, -0.6, 0.6 } };
  what.IsLattice = true;
  flow::TracerSettings settings;
  settings.Parameter = 0.125;
  const auto tracer = flow::NewTracer(what, settings);
  tracer->Update();
  vtkPolyData* lines = tracer->GetOutput();
  vtkIdType outside = 0;
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    outside += lines->GetPoint(i)[0] < -0.6 ? 1 : 0;
  }
  check.Equal(outside, vtkIdType{ 20 }, "points outside, one a streamline");
  const flow::Answer answer = flow::ReadTracer(what, tracer);
  for (const flow::End& end : answer.Ends)
  {
    check.That(end.HasAnswer, "an answer");
    // A step is an eighth of a cell's diagonal at most.
    check.Near(end.Place[0], -0.6, 0.055, "place", 1.0);
  }
}

void TestTubes(Check& check)
{
  const auto tubes = flow::MakeTubes(8);
  const reference::Flow flows[] = { reference::Flow::Linear(
                                      { 1.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0, -0.5 }),
    reference::Flow::RoundSphere(), reference::Flow::RoundSphere() };
  for (std::size_t i = 0; i < tubes.size(); ++i)
  {
    const flow::Tube& tube = tubes[i];
    check.SetContext(tube.Name);
    const flow::Disc& disc = tube.Inflow;
    for (const double radius : { disc.Radius, 0.7 * disc.Radius })
    {
      const auto x = flows[i].Follow(
        { disc.X, disc.Y + radius * std::cos(1.0), disc.Z + radius * std::sin(1.0) }, tube.Time);
      check.Near(tube.GetExcess(x.data()), radius - disc.Radius, 1e-9, "origin", 1.0);
      check.That(!tube.IsShadow(x.data()), "no shadow there");
    }
  }
  // The flux through a plane inside of r by Stokes' stream function, and that of the contraction.
  check.SetContext("volume");
  check.Near(tubes[0].Volume, 2.0 * Pi * 0.36 * 0.1, 1e-6, "contraction");
  const auto speed = [](const double x[3])
  {
    double v[3];
    reference::Flow::RoundSphere().Velocity(x, v);
    return v[0];
  };
  const flow::Disc middle = { -2.0, 0.0, 0.0, 1.5 };
  check.Near(middle.Integrate(speed), Pi * 2.25 * (1.0 - 1.0 / 15.625), 1e-5, "round a sphere");
}

void TestExplicitVolume(Check& check)
{
  check.SetContext("explicit flow volume");
  ExplicitFlowVolume::Settings settings;
  settings.Rings = 5;
  settings.Layers = 3;
  const flow::Disc disc = { -0.8, 0.1, -0.1, 0.4 };
  const auto uniform = MakeImage(5,
    [](const FlowVector&) {
      return FlowVector{ { 1.0, 0.25, 0.0 } };
    });
  const ExplicitFlowVolume straight(uniform, disc, 1.2, settings);
  const auto grid = straight.MakeTetrahedra();
  // A regular polygon of 30 corners.
  check.Near(SumTetrahedra(grid).Volume, 15.0 * 0.16 * std::sin(Pi / 15.0) * 1.2, 1e-12, "volume");
  check.Near(SumTetrahedra(grid).Inverted, 0.0, 0.0, "inverted tetrahedra");
  // Prisms that match leave the first and the last layer and the sides.
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  check.Equal(surface->GetOutput()->GetNumberOfCells(),
    2 * grid->GetNumberOfCells() / (3 * settings.Layers) + 2 * 30 * settings.Layers,
    "faces outside");
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
