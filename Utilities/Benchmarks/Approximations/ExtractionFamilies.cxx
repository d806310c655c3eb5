// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/Data/AnalyticCases.h"
#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Data/CellSplits.h"
#include "Benchmarks/Data/KeptTimeSteps.h"
#include "Benchmarks/Data/MovingFields.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/LevelDistance.h"
#include "Benchmarks/Measures/SurfaceDistances.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"

#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace approximations
{
namespace
{
const char* const TimeLabel = "run time (s)";

/// The root mean square, over the area, of how far triangles are from the level of a field.
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
    add("flyingedges, image", Maker::Peer,
      [image, value]() { return methods::FlyingEdges(image, value); });
    add("contour3dlinear, hexahedra", Maker::Peer,
      [grid, value]() { return methods::Contour3DLinearGrid(grid, value, true); });
  }
  trials.Run(question, options, rows);
}

/// The volume in space and time of projected 4-simplices: their extents in time are linear.
double MeasureInTime(vtkUnstructuredGrid* tetrahedra)
{
  vtkDataArray* extents = tetrahedra->GetPointData()->GetArray("DeltaT");
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    vtkCell* one = tetrahedra->GetCell(cell);
    double x[4][3];
    double extent = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      one->GetPoints()->GetPoint(i, x[i]);
      extent += 0.25 * extents->GetTuple1(one->GetPointId(i));
    }
    double edges[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(x[i + 1], x[0], edges[i]);
    }
    sum += extent * std::abs(vtkMath::Determinant3x3(edges[0], edges[1], edges[2])) / 6.0;
  }
  return sum;
}

/// A ball that moves and grows, at steps that are held in memory: as images, or cut into so many
/// tetrahedra a cell.
vtkSmartPointer<KeptTimeSteps> MakeSteps(const interval4d::MovingField& ball, int pieces)
{
  auto steps = vtkSmartPointer<KeptTimeSteps>::New();
  steps->AddStepsOf(ball.Source);
  if (pieces == 0)
  {
    return steps;
  }
  auto cut = vtkSmartPointer<KeptTimeSteps>::New();
  for (int step = 0; step < steps->GetNumberOfSteps(); ++step)
  {
    cut->AddStep(steps->GetTimeOf(step),
      SplitIntoTetrahedra(vtkImageData::SafeDownCast(steps->GetStep(step)), pieces));
  }
  return cut;
}

/// The integral of a ball's volume over the time of all steps; Simpson's rule is exact for it.
double ExactInTime(const interval4d::MovingField& ball)
{
  using interval4d::MovingField;
  const double middle = 0.5 * (MovingField::FirstTime + MovingField::LastTime);
  return (MovingField::LastTime - MovingField::FirstTime) / 6.0 *
    (ball.Volume(MovingField::FirstTime) + 4.0 * ball.Volume(middle) +
      ball.Volume(MovingField::LastTime));
}

void AddTableRouteRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const std::vector<interval4d::MovingField> fields = interval4d::MakeMovingFields(options);
  const interval4d::MovingField& ball =
    *std::find_if(fields.begin(), fields.end(), [](const auto& one) { return one.Name == "ball"; });
  const double exact = ExactInTime(ball);
  constexpr int numberOfSteps = 5;
  const auto sizes =
    options.Pick<std::vector<int>>({ 13, 17, 25, 33, 49 }, { 9, 13, 17, 25 }, { 7, 9 });
  Trials trials;
  trials.SetSize("time steps", numberOfSteps);
  for (const int points : sizes)
  {
    ball.Source->SetDimensions(points, points, points);
    ball.Source->SetTimeRange(
      interval4d::MovingField::FirstTime, interval4d::MovingField::LastTime);
    ball.Source->SetNumberOfTimeSteps(numberOfSteps);
    for (const int pieces : { 0, 5, 6 })
    {
      const interval4d::Case one = { ball.Name, MakeSteps(ball, pieces), ball.Lower, ball.Upper,
        {} };
      auto filter = one.NewFilter();
      filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      trials.Add(pieces == 0 ? "hexahedra" : "tetrahedra-" + NumberText(pieces), NumberText(points),
        pieces == 0 && points == sizes.back() ? Maker::Default : Maker::Own,
        WithThreads(1, Again(filter)),
        [filter, exact]() { return std::abs(MeasureInTime(filter->GetOutput()) - exact) / exact; });
    }
  }
  trials.Run(question, options, rows);
}
}

Family MakeContourFamily()
{
  return { { "contour-error", "Contours: error against run time as the grid gets finer, 1 thread",
             "How far is a contour from the surface, by which filter?",
             "A contour of the gyroid, points along an edge of the grid at each point; distances "
             "of triangles from the formula's own surface, integrated over their area.",
             TimeLabel, "distance from the surface, rms, share of the domain's edge" },
    AddContourRows };
}

Family MakeTableRouteFamily()
{
  return { { "table-routes", "Time-varying interval volumes: error against run time, 1 thread",
             "Which tables for an interval volume in time: of hexahedra or of tetrahedra?",
             "A shell that moves and grows, points along an edge of the grid at each point; cells "
             "as they are, or cut into five or six tetrahedra before; against the closed form.",
             TimeLabel, "volume in space and time, relative" },
    AddTableRouteRows };
}
}
