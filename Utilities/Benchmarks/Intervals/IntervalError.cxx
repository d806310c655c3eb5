// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/AnalyticCases.h"
#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Data/CellSplits.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Intervals/TrilinearRegion.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/SurfaceDistances.h"
#include "Benchmarks/Measures/TetrahedronSums.h"

#include "vtkIntervalVolume.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace interval
{
namespace
{
const char* const VolumeNorm = "volume, relative";
const char* const SurfaceNorm = "surface distance, rms, share of the domain's edge";
const char* const SampledNorm = "volume, relative, with sampling";

/// A method that extracts interval volumes, and its input grid. IsClip is true for the baseline
/// `clip2`.
struct Method
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
  bool IsClip = false;
  double SplitSeconds = 0.0;
};

std::vector<Method> MakeMethods(vtkImageData* image)
{
  std::vector<Method> methods;
  methods.push_back({ "hexahedra", image });
  methods.push_back({ "hexahedra-unstructured", ToHexahedra(image) });
  for (int pieces : { 5, 6 })
  {
    Method method;
    method.Name = "tetrahedra-" + std::to_string(pieces);
    method.SplitSeconds = TimeOnce(
      [&]()
      {
        method.Data = SplitIntoTetrahedra(image, pieces);
        return method.Data;
      });
    methods.push_back(method);
  }
  methods.push_back({ "clip2", image, true });
  return methods;
}

/// The tetrahedra of an interval volume, and triangles that include its surfaces at both bounds.
struct Result
{
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra;
  vtkSmartPointer<vtkPointSet> Boundary;
};

Result Extract(const Method& method, double lower, double upper)
{
  Result result;
  if (method.IsClip)
  {
    result.Tetrahedra = methods::ToTetrahedra(
      methods::ClipTwice(method.Data, lower, upper, vtkAlgorithm::DOUBLE_PRECISION));
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(result.Tetrahedra);
    surface->Update();
    result.Boundary = surface->GetOutput();
  }
  else
  {
    auto filter = methods::NewIntervalVolume(method.Data, lower, upper);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->GenerateBoundariesOn();
    filter->Update();
    result.Tetrahedra = filter->GetOutput(0);
    result.Boundary = filter->GetOutput(1);
  }
  return result;
}

/// Returns the root mean square distance from the exact surface to the triangles of \a boundary
/// that are not on the faces of the domain.
double SurfaceDistance(
  vtkPointSet* boundary, const TrilinearRegion& region, double lower, double upper)
{
  vtkDataArray* scalars = boundary->GetPointData()->GetScalars("value");
  vtkNew<vtkIdList> ids;
  SurfaceDistances sums;
  for (vtkIdType cell = 0; cell < boundary->GetNumberOfCells(); ++cell)
  {
    boundary->GetCellPoints(cell, ids);
    double x[3][3];
    double value = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      boundary->GetPoint(ids->GetId(i), x[i]);
      value += scalars->GetTuple1(ids->GetId(i)) / 3.0;
    }
    if (region.AreOnSameBoxFace(x[0], x[1], x[2]))
    {
      continue;
    }
    const double bound = std::abs(value - lower) < std::abs(value - upper) ? lower : upper;
    sums.AddTriangle(x, [&](const double point[3]) { return region.GetDistance(point, bound); });
  }
  return sums.GetRootMeanSquare();
}

std::vector<BenchSeconds> TimeMethods(
  const std::vector<Method>& all, const AnalyticCase& analytic, const BenchOptions& options)
{
  std::vector<BenchWork> works;
  for (const Method& method : all)
  {
    const BenchWork work = [&method, &analytic]()
    {
      return method.IsClip ? methods::ClipTwice(method.Data, analytic.Lower, analytic.Upper,
                               vtkAlgorithm::DEFAULT_PRECISION)
                           : methods::IntervalVolume(method.Data, analytic.Lower, analytic.Upper);
    };
    works.push_back(WithThreads(1, work));
  }
  return MeasureAlternately(works, options.GetRepeats());
}

void AddRowsOf(
  const AnalyticCase& analytic, int points, const BenchOptions& options, BenchRows& rows)
{
  auto image = analytic.Sample(points);
  const TrilinearRegion region(image);
  const double exact = region.GetVolume(analytic.Lower, analytic.Upper);
  const std::vector<Method> all = MakeMethods(image);
  const std::vector<BenchSeconds> seconds = TimeMethods(all, analytic, options);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Method& method = all[i];
    const Result result = Extract(method, analytic.Lower, analytic.Upper);
    const TetrahedronSums sums = SumTetrahedra(result.Tetrahedra);
    const double volume = method.IsClip ? sums.AbsoluteVolume : sums.Volume;
    const double distance =
      SurfaceDistance(result.Boundary, region, analytic.Lower, analytic.Upper) /
      (analytic.High - analytic.Low);

    BenchRow row = rows.Make(analytic.Name, method.Name, points);
    row.Seconds = seconds[i];
    if (!method.IsClip)
    {
      row.Baseline = "clip2";
      row.BaselineSeconds = seconds.back();
    }
    row.Set({ { "threads", 1 }, { "cells", method.Data->GetNumberOfCells() },
      { "tetrahedra", sums.Tetrahedra } });
    if (method.SplitSeconds > 0.0)
    {
      row.Counts["split_seconds"] = method.SplitSeconds;
    }
    auto addNorm = [&](const char* norm, double error)
    {
      row.SetError(norm, error);
      rows.Add(row);
    };
    addNorm(VolumeNorm, std::abs(volume - exact) / exact);
    addNorm(SurfaceNorm, distance);
    if (analytic.Volume)
    {
      addNorm(SampledNorm, std::abs(volume - *analytic.Volume) / *analytic.Volume);
    }
  }
}

BenchPlot MakeErrorPlot(const std::string& theCase, const char* norm, const std::string& name,
  const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("interval-" + theCase + "-" + name,
    theCase + ": error against run time as the grid gets finer, 1 thread", "run time (s)",
    std::string("error: ") + norm,
    "Are case tables of hexahedra worth their run time for the " + name +
      " of an interval volume (" + theCase + ")?",
    "vtkIntervalVolume on hexahedra and on hexahedra split into tetrahedra; two passes of "
    "vtkTableBasedClipDataSet are the baseline. Labels are points along an edge of the grid. "
    "Ringed: hexahedra on the finest grid.");
  for (const BenchRow& row : rows)
  {
    if (row.Case == theCase && row.ErrorNorm == norm)
    {
      plot.AddRow(row, row.Method == "clip2");
    }
  }
  plot.SetDefault("hexahedra");
  return plot;
}

/**
 * Measures errors in the analytic cases. Methods: `hexahedra` (the image data),
 * `hexahedra-unstructured`, `tetrahedra-5` and `tetrahedra-6` (each cell is split beforehand into
 * 5 or 6 tetrahedra, which takes `split_seconds`), and the baseline `clip2`. The parameter is
 * the number of points along an axis. There is one row for each norm:
 * - `volume, relative`: error relative to the volume of the exact trilinear region;
 * - `surface distance, rms, share of the domain's edge`: distance of the result's boundary inside
 *   the domain from the exact trilinear surface;
 * - `volume, relative, with sampling`: error relative to the volume of the analytic region, if it
 *   is known.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<int> resolutions =
    options.Pick<std::vector<int>>({ 9, 17, 33, 65, 97 }, { 5, 9, 13, 17, 25 }, { 5, 7 });
  for (const AnalyticCase& analytic : MakeAnalyticCases())
  {
    for (int points : resolutions)
    {
      AddRowsOf(analytic, points, options, rows);
    }
  }
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const AnalyticCase& analytic : MakeAnalyticCases())
  {
    plots.push_back(MakeErrorPlot(analytic.Name, VolumeNorm, "volume", rows));
    plots.push_back(MakeErrorPlot(analytic.Name, SurfaceNorm, "surface", rows));
  }
  return plots;
}
}

BenchPart MakeErrorPart()
{
  return { AddErrorRows, MakeErrorPlots };
}
}
