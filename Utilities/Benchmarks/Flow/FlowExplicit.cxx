// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowParts.h"

#include "Benchmarks/Flow/ExplicitFlowVolume.h"
#include "Benchmarks/Flow/FlowTubes.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/LevelDistance.h"
#include "Benchmarks/Measures/SurfaceDistances.h"

#include "vtkCellIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTetra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace flow
{
namespace
{
const char* const Explicit = "explicit";
const char* const Halved = "explicit-halved";
const char* const Implicit = "implicit";
const char* const Again = "implicit-again";
const char* const Refined = "implicit-refined";
constexpr int Levels = 2;
const char* const BoundaryCount = "boundary_distance";

using Corners = std::vector<std::array<double, 3>>;

/// Calls \a visit with the corners of each cell.
template <typename Visitor>
void ForEachCell(vtkDataSet* cells, const Visitor& visit)
{
  Corners corners;
  const auto iterator = vtkSmartPointer<vtkCellIterator>::Take(cells->NewCellIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkPoints* points = iterator->GetPoints();
    corners.resize(static_cast<std::size_t>(points->GetNumberOfPoints()));
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      points->GetPoint(static_cast<vtkIdType>(i), corners[i].data());
    }
    visit(corners);
  }
}

/// What is made of a tube, against what it is.
class TubeErrors
{
public:
  explicit TubeErrors(const Tube& tube)
    : Exact(tube)
  {
  }

  void AddTetrahedra(vtkDataSet* tetrahedra)
  {
    this->Tetrahedra += tetrahedra->GetNumberOfCells();
    ForEachCell(tetrahedra,
      [this](Corners& x)
      {
        const double volume =
          std::abs(vtkTetra::ComputeVolume(x[0].data(), x[1].data(), x[2].data(), x[3].data()));
        double center[3];
        vtkTetra::TetraCenter(x[0].data(), x[1].data(), x[2].data(), x[3].data(), center);
        this->Volume += volume;
        if (this->Exact.IsShadow(center) || this->Exact.GetExcess(center) > 0.0)
        {
          this->Outside += volume;
        }
      });
  }

  void AddSide(const double a[3], const double b[3], const double c[3])
  {
    const double x[3][3] = { { a[0], a[1], a[2] }, { b[0], b[1], b[2] }, { c[0], c[1], c[2] } };
    this->Sides.AddTriangle(x,
      [this](const double* point)
      {
        return DistanceToLevel([this](const double at[3], double gradient[3])
          { return this->Exact.GetExcess(at, gradient); },
          point, 0.0, this->Exact.Inflow.Radius);
      });
  }

  void Fill(BenchRow& row) const
  {
    const double exact = this->Exact.Volume;
    row.SetError("volume outside of the tube and volume missing, of the tube's",
      (this->Outside + std::abs(exact - (this->Volume - this->Outside))) / exact);
    row.Set({ { "tetrahedra", this->Tetrahedra },
      { "volume_error", std::abs(this->Volume - exact) / exact },
      { BoundaryCount, this->Sides.GetRootMeanSquare() } });
  }

private:
  const Tube& Exact;
  vtkIdType Tetrahedra = 0;
  double Volume = 0.0;
  double Outside = 0.0;
  SurfaceDistances Sides;
};

void AddExplicit(const Tube& tube, int rings, bool isHalved, BenchRows& rows)
{
  ExplicitFlowVolume::Settings settings;
  settings.Rings = rings;
  settings.Layers = 4 * rings;
  settings.LongestEdge = isHalved ? 1.5 * tube.Inflow.Radius / rings : 0.0;
  std::unique_ptr<ExplicitFlowVolume> volume;
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra;
  const auto work = [&]()
  {
    volume = std::make_unique<ExplicitFlowVolume>(tube.Field, tube.Inflow, tube.Time, settings);
    tetrahedra = volume->MakeTetrahedra();
    return vtkSmartPointer<vtkObjectBase>(tetrahedra);
  };
  BenchRow row = rows.Make(tube.Name, isHalved ? Halved : Explicit, rings);
  row.Seconds = TimeOnce(WithThreads(1, work));
  TubeErrors errors(tube);
  errors.AddTetrahedra(tetrahedra);
  volume->ForEachSide(
    [&errors](const std::array<double, 3>& a, const std::array<double, 3>& b,
      const std::array<double, 3>& c) { errors.AddSide(a.data(), b.data(), c.data()); });
  errors.Fill(row);
  row.Counts["streamlines"] = volume->GetNumberOfStreamlines();
  rows.Add(row);
}

/// Samples behind the disc's plane, the first of them on it.
void SetSamples(const Tube& tube, int samples, vtkImplicitFlowField* field)
{
  double bounds[6];
  tube.Field->GetBounds(bounds);
  bounds[0] = tube.Inflow.X;
  field->SetInputData(tube.Field);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleBounds(bounds);
  field->SetSampleDimensions(samples, samples, samples);
  // Cells across the end need answers behind it.
  field->SetMaximumTime(1.3 * tube.Time);
}

void AddImplicit(
  const Tube& tube, int samples, int levels, const BenchOptions& options, BenchRows& rows)
{
  DiscVolume pipeline(tube.Inflow);
  SetSamples(tube, samples, pipeline.Field);
  pipeline.Field->SetRefinementLevels(levels);
  pipeline.Volume->SetTimeRange(0.0, tube.Time);
  const auto work = WithThreads(1,
    [&pipeline]()
    {
      pipeline.Volume->Update();
      return vtkSmartPointer<vtkObjectBase>(pipeline.Volume->GetOutput());
    });
  const auto again = [&pipeline, &work]()
  {
    pipeline.Mapping->Modified();
    return work();
  };
  BenchRow row = rows.Make(tube.Name, levels > 0 ? Refined : Implicit, samples);
  row.Seconds = TimeOnce(work);
  row.Counts["streamlines"] = pipeline.Field->GetReport().Samples;
  const BenchSeconds seconds = MeasureAlternately({ again }, options.GetRepeats()).front();
  TubeErrors errors(tube);
  errors.AddTetrahedra(pipeline.Volume->GetOutput());
  // Not part of the time, as the sides of the explicit volume are not.
  pipeline.Volume->GenerateStreamSurfacesOn();
  pipeline.Volume->Update();
  ForEachCell(vtkDataSet::SafeDownCast(pipeline.Volume->GetOutputDataObject(1)),
    [&errors](Corners& x) { errors.AddSide(x[0].data(), x[1].data(), x[2].data()); });
  errors.Fill(row);
  rows.Add(row);
  if (levels > 0)
  {
    return;
  }
  BenchRow changed = row;
  changed.Method = Again;
  changed.Seconds = seconds;
  rows.Add(changed);
}

/// The plot of that name for such a row, which is made where it is missing.
BenchPlot MakePlot(const std::string& tube, bool isBoundary)
{
  return BenchPlot::OfErrors("flow-explicit-" + tube + (isBoundary ? "-boundary" : ""),
    "Stream volume, " + tube + ", 1 thread", "run time (s)",
    isBoundary ? "boundary, rms distance (unit of length)" : "misplaced volume / volume",
    std::string("How fine are samples to be for the ") + (isBoundary ? "boundary" : "volume") +
      " of the stream volume " + tube + "?",
    "Implicit by samples along an edge, cells refined or not, and again on a field that is there, "
    "which is no choice for the first time; explicit, the peer, by rings of streamlines, halved "
    "where they part or not. Ringed: the finest samples without refinement.");
}

/**
 * The cases of MakeTubes, by one thread. Methods, with their parameters:
 * - `explicit`, `explicit-halved`: ExplicitFlowVolume, without and with edges halved that grow
 *   beyond 1.5 times what they are on the disc; its rings, four layers for each;
 * - `implicit`: DiscVolume, from the field to the volume; samples along each side of a box behind
 *   the disc's plane;
 * - `implicit-again`: the same volume after a change of the inflow mapping;
 * - `implicit-refined`: as `implicit`, with two levels of refinement.
 */
void AddExplicitRows(const BenchOptions& options, BenchRows& rows)
{
  const auto rings = options.Pick<std::vector<int>>({ 4, 8, 16, 32 }, { 4, 8 }, { 2, 4 });
  // Halving makes some ten times as many where streamlines part at a stagnation point.
  const auto halvedRings = options.Pick<std::vector<int>>({ 4, 8, 16 }, { 4 }, { 2 });
  const auto samples =
    options.Pick<std::vector<int>>({ 16, 24, 32, 48, 64, 96 }, { 16, 24 }, { 12, 16 });
  const auto refined = options.Pick<std::vector<int>>({ 16, 24, 32, 48 }, { 16 }, { 12 });
  for (const Tube& tube : MakeTubes(options.Pick(128, 64, 24)))
  {
    for (const int number : rings)
    {
      AddExplicit(tube, number, false, rows);
    }
    for (const int number : halvedRings)
    {
      AddExplicit(tube, number, true, rows);
    }
    for (const int number : samples)
    {
      AddImplicit(tube, number, 0, options, rows);
    }
    for (const int number : refined)
    {
      AddImplicit(tube, number, Levels, options, rows);
    }
  }
}

std::vector<BenchPlot> MakeExplicitPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    const bool isPeer = row.Method == Explicit || row.Method == Halved;
    if (isPeer || row.Method == Implicit || row.Method == Again || row.Method == Refined)
    {
      for (const bool isBoundary : { false, true })
      {
        const double error = isBoundary ? row.Counts[BoundaryCount].get<double>() : *row.Error;
        BenchPlot& plot = FindOrAdd(plots, MakePlot(row.Case, isBoundary));
        plot.AddPoint(row.Method, isPeer, *row.Seconds, error, row.GetParameterText());
        plot.SetNoChoice(Again);
        plot.SetDefault(Implicit);
      }
    }
  }
  return plots;
}
}

BenchPart MakeExplicitPart()
{
  return { AddExplicitRows, MakeExplicitPlots };
}
}
