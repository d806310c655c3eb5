// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowParts.h"

#include "Benchmarks/Flow/FlowDisc.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "Support/AnalyticFlows/ReferenceFlowAnswers.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkFlowVolume.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace flow
{
namespace
{
const char* const Conservation = "conservation";
constexpr int Surfaces = 5;

struct Conserved
{
  std::string Name;
  vtkSmartPointer<vtkAnalyticFlowSource> Source;
  Disc Inflow;
  /// Of the last time surface, the others before it at equal intervals.
  double Time = 0.0;
};

std::vector<Conserved> MakeCases(int points)
{
  const auto newSource = [points](int field)
  {
    auto source = vtkSmartPointer<vtkAnalyticFlowSource>::New();
    source->SetField(field);
    source->SetDimensions(points, points, points);
    return source;
  };
  const auto contraction = newSource(vtkAnalyticFlowSource::SADDLE);
  contraction->SetSaddleRates(1.0, -0.5, -0.5);
  return {
    { "contraction", contraction, { 0.2, 0.05, 0.1, 0.6 }, 1.4 },
    { "sphere", newSource(vtkAnalyticFlowSource::SPHERE), { -0.9, 0.35, 0.0, 0.2 }, 1.5 },
    { "abc", newSource(vtkAnalyticFlowSource::ABC), { -0.9, 0.0, 0.5, 0.2 }, 0.5 },
  };
}

void AddCase(const Conserved& what, const BenchOptions& options, BenchRows& rows)
{
  what.Source->Update();
  DiscVolume pipeline(what.Inflow);
  pipeline.Field->SetInputData(what.Source->GetOutputDataObject(0));
  pipeline.Field->SetMaximumTime(1.3 * what.Time);
  pipeline.Volume->SetTimeRange(0.0, 1.1 * what.Time);
  pipeline.Volume->GenerateTimeSurfacesOn();
  for (int i = 0; i < Surfaces; ++i)
  {
    pipeline.Volume->SetTimeSurface(i, what.Time * (i + 1) / Surfaces);
  }
  BenchRow row = rows.Make(what.Name, Conservation);
  row.Seconds = TimeOnce(WithThreads(options.Threads,
    [&]()
    {
      pipeline.Volume->Update();
      return vtkSmartPointer<vtkObjectBase>(pipeline.Volume);
    }));
  auto* triangles = vtkUnstructuredGrid::SafeDownCast(pipeline.Volume->GetOutputDataObject(2));
  const auto velocity = [&what](const double* x)
  {
    std::array<double, 3> v;
    what.Source->Evaluate(x, v.data());
    return v;
  };
  const double inflow =
    what.Inflow.Integrate([&velocity](const double* x) { return velocity(x)[0]; });
  double largest = 0.0;
  for (int i = 0; i < Surfaces; ++i)
  {
    // The start of the range is surface 0.
    const double flux = reference::MeasureFlux(triangles, velocity, "TimeSurfaceId", i + 1);
    largest = std::max(largest, std::abs(std::abs(flux) / inflow - 1.0));
  }
  row.Parameter = ThreadsParameter(options.Threads);
  row.SetError("largest relative deviation of a time surface's flux", largest);
  row.Set({ { "surfaces", Surfaces }, { "deviation_percent", 100.0 * largest } });
  rows.Add(row);
}

/**
 * Method `conservation`: stream volumes from a disc in fields without divergence, `contraction`,
 * `sphere` (beside it) and `abc`; the error is the largest deviation of the flux through a time
 * surface from that through the disc, relative to it.
 */
void AddConservationRows(const BenchOptions& options, BenchRows& rows)
{
  for (const Conserved& what : MakeCases(options.Pick(64, 32, 16)))
  {
    AddCase(what, options, rows);
  }
}

std::vector<BenchClaim> CheckConservationClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost("flux through the time surfaces of a stream volume constant to 1 %",
    1.0, rows, CountOf(Conservation, "deviation_percent")) };
}
}

BenchPart MakeConservationPart()
{
  return { AddConservationRows, nullptr, CheckConservationClaims };
}
}
