// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/Data/AnalyticCases.h"
#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/LevelDistance.h"
#include "Benchmarks/Measures/SurfaceDistances.h"

#include "vtkIdList.h"
#include "vtkImageData.h"

#include <algorithm>

namespace approximations
{
namespace
{
/// Returns the root mean square distance of triangles from a level set of a field, weighted by
/// area.
double MeasureLevel(vtkDataSet* triangles, const AnalyticCase& field, double value)
{
  const auto evaluate = [&field](const double at[3], double gradient[3])
  {
    constexpr double step = 1e-5;
    for (int axis = 0; axis < 3; ++axis)
    {
      double below[3] = { at[0], at[1], at[2] };
      double above[3] = { at[0], at[1], at[2] };
      below[axis] -= step;
      above[axis] += step;
      gradient[axis] =
        (field.Field(above[0], above[1], above[2]) - field.Field(below[0], below[1], below[2])) /
        (2.0 * step);
    }
    return field.Field(at[0], at[1], at[2]);
  };
  SurfaceDistances sums;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellPoints(cell, ids);
    double x[3][3];
    for (int i = 0; i < 3; ++i)
    {
      triangles->GetPoint(ids->GetId(i), x[i]);
    }
    sums.AddTriangle(x,
      [&](const double point[3])
      { return DistanceToLevel(evaluate, point, value, field.High - field.Low); });
  }
  return sums.GetRootMeanSquare() / (field.High - field.Low);
}

void AddContourRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const std::vector<AnalyticCase> fields = MakeAnalyticCases();
  const AnalyticCase& gyroid = *std::find_if(
    fields.begin(), fields.end(), [](const AnalyticCase& one) { return one.Name == "gyroid"; });
  const double value = gyroid.Lower;
  const auto sizes = options.Pick<std::vector<int>>({ 17, 33, 65, 129 }, { 17, 33, 65 }, { 5, 9 });
  Trials trials;
  for (const int points : sizes)
  {
    auto image = gyroid.Sample(points);
    auto grid = ToHexahedra(image);
    const auto add = [&](const char* method, Maker maker, const BenchWork& work)
    {
      trials.Add(method, NumberText(points), maker, WithThreads(1, work),
        [work, &gyroid, value]()
        { return MeasureLevel(vtkDataSet::SafeDownCast(work()), gyroid, value); });
    };
    add("isotable, image", points == sizes.back() ? Maker::Default : Maker::Own,
      [image, value]() { return methods::IsotableContour(image, value, true); });
    add("isotable, hexahedra", Maker::Own,
      [grid, value]() { return methods::IsotableContour(grid, value, true); });
    add("flyingedges, image", Maker::Baseline,
      [image, value]() { return methods::FlyingEdges(image, value); });
    add("contour3dlinear, hexahedra", Maker::Baseline,
      [grid, value]() { return methods::Contour3DLinearGrid(grid, value, true); });
  }
  trials.Run(question, options, rows);
}
}

Family MakeContourFamily()
{
  return {
    { "contour-error", "Contours: error against run time as the grid gets finer, 1 thread",
      "Which contour filter is closest to the surface for its run time?",
      "A contour of the gyroid; labels are grid points along an edge. The error is the distance "
      "of the triangles from the exact level set, integrated over their area.",
      "run time (s)", "distance from the surface, rms, share of the domain's edge" },
    AddContourRows
  };
}
}
