// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/SpeedPlots.h"
#include "Benchmarks/Suites/BenchParts.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace interval
{
namespace
{
const char* const OnImage = "isotable-image";
const char* const OnHexahedra = "isotable-hexahedra";
const char* const OnHexahedraUnmerged = "isotable-hexahedra-unmerged";

/// Returns the number of triangles that \a work creates.
vtkIdType TrianglesOf(const BenchWork& work)
{
  return vtkDataSet::SafeDownCast(work())->GetNumberOfCells();
}

/// Adds a row for each baseline, measured with the given number of threads. The first of \a works
/// uses Interlume, the others are the baselines.
void AddRows(const BenchRow& common, int threads, const std::vector<std::string>& baselines,
  std::vector<BenchWork> works, const BenchOptions& options, BenchRows& rows)
{
  for (BenchWork& work : works)
  {
    work = WithThreads(threads, work);
  }
  // Runs are short, so repeat them three times as often for a stable median.
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, 3 * options.GetRepeats());
  for (std::size_t i = 0; i < baselines.size(); ++i)
  {
    BenchRow row = common;
    row.Parameter = ThreadsParameter(threads);
    row.SetTimes(seconds[0], baselines[i], seconds[i + 1]);
    row.Set({ { "threads", threads }, { "triangles", TrianglesOf(works[0]) },
      { "peer_triangles", TrianglesOf(works[i + 1]) } });
    rows.Add(row);
  }
}

BenchRow MakeRow(const BenchData& data, const char* method, BenchRows& rows)
{
  BenchRow row = rows.Make(data.Case, method);
  row.Counts["cells"] = data.Data->GetNumberOfCells();
  return row;
}

/// Returns \a data as hexahedra with float or double scalars, the only types that
/// vtkContour3DLinearGrid accepts. Other scalars are converted to float.
vtkSmartPointer<vtkUnstructuredGrid> ToHexahedraOfFloats(vtkDataSet* data)
{
  auto grid = ToHexahedra(data);
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  if (scalars->GetDataType() != VTK_FLOAT && scalars->GetDataType() != VTK_DOUBLE)
  {
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(scalars);
    grid->GetPointData()->SetScalars(floats);
  }
  return grid;
}

void AddHexahedraRows(const BenchData& data, const BenchOptions& options, BenchRows& rows)
{
  auto grid = ToHexahedraOfFloats(data.Data);
  const double value = data.Lower;
  for (int threads : options.GetThreadCounts())
  {
    AddRows(MakeRow(data, OnHexahedra, rows), threads,
      { "contour3dlinear", "contour3dlinear-merge" },
      { [&]() { return methods::IsotableContour(grid, value, true); },
        [&]() { return methods::Contour3DLinearGrid(grid, value, false); },
        [&]() { return methods::Contour3DLinearGrid(grid, value, true); } },
      options, rows);
    AddRows(MakeRow(data, OnHexahedraUnmerged, rows), threads, { "contour3dlinear" },
      { [&]() { return methods::IsotableContour(grid, value, false); },
        [&]() { return methods::Contour3DLinearGrid(grid, value, false); } },
      options, rows);
  }
}

void AddImageRows(const BenchData& data, const BenchOptions& options, BenchRows& rows)
{
  auto image = vtkImageData::SafeDownCast(data.Data);
  if (!image)
  {
    return;
  }
  const double value = data.Lower;
  for (int threads : options.GetThreadCounts())
  {
    AddRows(MakeRow(data, OnImage, rows), threads, { "flyingedges" },
      { [&]() { return methods::IsotableContour(image, value, true); },
        [&]() { return methods::FlyingEdges(image, value); } },
      options, rows);
  }
}

void AddContourRows(const BenchOptions& options, BenchRows& rows)
{
  for (const BenchData& data : MakeSpeedCases(options))
  {
    AddHexahedraRows(data, options, rows);
    AddImageRows(data, options, rows);
  }
}

std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  // Plots are named after the baseline, and two methods have the same baseline. Their plots thus
  // need different prefixes.
  for (const auto& [name, method] :
    { std::make_pair("contour", OnHexahedra), std::make_pair("contour", OnImage),
      std::make_pair("contour-unmerged", OnHexahedraUnmerged) })
  {
    const std::vector<BenchPlot> some = MakeRatioPlots(name, method, rows);
    plots.insert(plots.end(), some.begin(), some.end());
  }
  return plots;
}

std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast("hexahedra, 1 thread: no slower than contour3dlinear-merge", 1.0,
             rows, RatioWithOneThread(OnHexahedra, "contour3dlinear-merge")),
    BenchClaim::AtLeast("hexahedra without shared points, 1 thread: no slower than contour3dlinear",
      1.0, rows, RatioWithOneThread(OnHexahedraUnmerged, "contour3dlinear")),
    BenchClaim::AtLeast("image data, 1 thread: at most twice slower than flyingedges", 0.5, rows,
      RatioWithOneThread(OnImage, "flyingedges")) };
}
}

BenchPart MakeContourPart()
{
  return { AddContourRows, MakePlots, CheckClaims };
}
}
