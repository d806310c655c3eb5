// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/Interval4dThroughput.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

namespace interval4d
{
namespace
{
Case MakeGrid(int points)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToVortex();
  source->SetDimensions(points, points, points);
  source->SetTimeRange(0.0, 1.0);
  source->SetNumberOfTimeSteps(2);
  Case what;
  what.Name = "vortex, 2 x " + std::to_string(points) + "^3 points";
  what.Steps = vtkSmartPointer<KeptTimeSteps>::New();
  what.Steps->AddStepsOf(source);
  // Above every value.
  what.Upper = 100.0;
  return what;
}

/// The values of the first step, the largest first.
std::vector<double> SortedValues(const Case& what)
{
  vtkDataArray* scalars =
    vtkImageData::SafeDownCast(what.Steps->GetStep(0))->GetPointData()->GetScalars();
  std::vector<double> values(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = scalars->GetTuple1(static_cast<vtkIdType>(i));
  }
  std::sort(values.rbegin(), values.rend());
  return values;
}

void AddRow(const Case& what, double share, const BenchOptions& options, BenchRows& rows)
{
  vtkIdType simplices = 0;
  const BenchWork work = [&]()
  {
    auto filter = what.NewFilter();
    filter->Update();
    simplices = filter->GetReport().Simplices;
    return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
  };
  BenchRow row = rows.Make(what.Name, "throughput");
  row.Parameter = share;
  row.Seconds = MeasureAlternately({ WithThreads(1, work) }, options.GetRepeats()).front();
  row.Counts["cells"] = what.GetNumberOfCells();
  row.Counts["lower"] = what.Lower;
  row.Counts["simplices"] = simplices;
  row.Counts["simplices_per_second"] = static_cast<double>(simplices) / *row.Seconds;
  rows.Add(row);
}
}

void AddThroughputRows(const BenchOptions& options, BenchRows& rows)
{
  const auto sizes = options.Pick<std::vector<int>>({ 32, 64, 96, 128 }, { 32, 64 }, { 12, 16 });
  const auto shares = options.Pick<std::vector<double>>(
    { 0.00001, 0.0001, 0.001, 0.01, 0.03 }, { 0.0001, 0.001, 0.01, 0.03 }, { 0.01, 0.03 });
  for (const int points : sizes)
  {
    Case what = MakeGrid(points);
    const std::vector<double> values = SortedValues(what);
    for (const double share : shares)
    {
      const auto inside = static_cast<std::size_t>(share * static_cast<double>(values.size()));
      if (inside > 0)
      {
        what.Lower = values[inside];
        AddRow(what, share, options, rows);
      }
    }
  }
}

std::vector<BenchPlot> MakeThroughputPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot;
  plot.Name = "interval4d-throughput";
  plot.Title = "4-simplices, projected and cut into tetrahedra, 1 thread";
  plot.XLabel = "4-simplices";
  plot.YLabel = "4-simplices a second";
  plot.LogX = true;
  plot.LogY = true;
  plot.Rises = true;
  for (const BenchRow& row : rows)
  {
    if (row.Method == "throughput" && row.Counts["simplices"].get<double>() > 0.0)
    {
      plot.AddPoint(row.Case, false, row.Counts["simplices"].get<double>(),
        row.Counts["simplices_per_second"].get<double>());
    }
  }
  return plot.AllSeries.empty() ? std::vector<BenchPlot>() : std::vector<BenchPlot>{ plot };
}
}
