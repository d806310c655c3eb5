// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Flow/ExplicitFlowVolume.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Flow/FlowTubes.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkTetra.h"

#include <cmath>
#include <string>

namespace flow
{
namespace
{
const char* const Explicit = "explicit";
const char* const Implicit = "implicit";
const char* const Again = "implicit-again";
const char* const Refined = "implicit-refined";
constexpr int Levels = 2;

/// Sets the error of the tetrahedra relative to the exact stream volume, and the counts of the row.
void SetErrors(const Tube& tube, vtkUnstructuredGrid* tetrahedra, BenchRow& row)
{
  double total = 0.0;
  double outside = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    tetrahedra->GetCellPoints(cell, ids);
    double x[4][3];
    for (int corner = 0; corner < 4; ++corner)
    {
      tetrahedra->GetPoint(ids->GetId(corner), x[corner]);
    }
    const double volume = std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]));
    double center[3];
    vtkTetra::TetraCenter(x[0], x[1], x[2], x[3], center);
    total += volume;
    if (tube.IsShadow(center) || tube.GetExcess(center) > 0.0)
    {
      outside += volume;
    }
  }
  row.SetError("volume outside of the tube and volume missing, of the tube's",
    (outside + std::abs(tube.Volume - (total - outside))) / tube.Volume);
  row.Set({ { "tetrahedra", tetrahedra->GetNumberOfCells() },
    { "volume_error", std::abs(total - tube.Volume) / tube.Volume } });
}

void AddExplicit(const Tube& tube, int rings, BenchRows& rows)
{
  std::size_t streamlines = 0;
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra;
  const auto work = [&]()
  {
    const ExplicitFlowVolume volume(tube.Field, tube.Inflow, tube.Time, { rings, 4 * rings });
    streamlines = volume.GetNumberOfStreamlines();
    tetrahedra = volume.MakeTetrahedra();
    return vtkSmartPointer<vtkObjectBase>(tetrahedra);
  };
  BenchRow row = rows.Make(tube.Name, Explicit, rings);
  row.Seconds = TimeOnce(WithThreads(1, work));
  SetErrors(tube, tetrahedra, row);
  row.Counts["streamlines"] = streamlines;
  rows.Add(row);
}

/// Samples the part of the domain downstream of the disk's plane. The first layer of samples is on
/// the plane.
void SetSamples(const Tube& tube, int samples, vtkImplicitFlowField* field)
{
  double bounds[6];
  tube.Field->GetBounds(bounds);
  bounds[0] = tube.Inflow.X;
  field->SetInputData(tube.Field);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleBounds(bounds);
  field->SetSampleDimensions(samples, samples, samples);
  // Cells in which the end time is reached also need results at corners that are reached later.
  field->SetMaximumTime(1.3 * tube.Time);
}

void AddImplicit(
  const Tube& tube, int samples, int levels, const BenchOptions& options, BenchRows& rows)
{
  DiskVolume pipeline(tube.Inflow);
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
  row.Counts["streamlines"] = pipeline.Field->GetReport()->GetCount("Samples");
  const BenchSeconds seconds = MeasureAlternately({ again }, options.GetRepeats()).front();
  SetErrors(tube, pipeline.Volume->GetOutput(), row);
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

/**
 * Measures the cases of MakeTubes with one thread. Methods:
 * - `explicit`: ExplicitFlowVolume. The parameter is the number of rings; there are four layers
 *   per ring.
 * - `implicit`: DiskVolume, including its flow field. The parameter is the number of samples along
 *   each edge of a box downstream of the disk's plane.
 * - `implicit-again`: the same volume computed again after modifying the inflow mapping.
 * - `implicit-refined`: like `implicit`, with two levels of refinement.
 */
void AddExplicitRows(const BenchOptions& options, BenchRows& rows)
{
  const auto rings = options.Pick<std::vector<int>>({ 4, 8, 16, 32 }, { 4, 8 }, { 2, 4 });
  const auto samples =
    options.Pick<std::vector<int>>({ 16, 24, 32, 48, 64, 96 }, { 16, 24 }, { 12, 16 });
  const auto refined = options.Pick<std::vector<int>>({ 16, 24, 32, 48 }, { 16 }, { 12 });
  for (const Tube& tube : MakeTubes(options.Pick(128, 64, 24)))
  {
    for (const int number : rings)
    {
      AddExplicit(tube, number, rows);
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
    if (row.Method == Explicit || row.Method == Implicit || row.Method == Refined)
    {
      BenchPlot& plot = FindOrAdd(plots,
        BenchPlot::OfErrors("flow-explicit-" + row.Case,
          "Stream volume, " + row.Case + ", 1 thread", "run time (s)", "misplaced volume / volume",
          "Which sample resolution is required for an accurate stream volume (" + row.Case + ")?",
          "Implicit stream volumes: labels are samples along an edge, with or without refined "
          "cells. The baseline is the explicit stream volume: labels are rings of streamlines. "
          "Ringed: the highest resolution without refinement."));
      plot.AddRow(row, row.Method == Explicit);
      plot.SetDefault(Implicit);
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
