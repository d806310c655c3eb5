// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fuzz
{

namespace
{

using Interval = std::array<double, 2>;

struct Choice
{
  vtkSmartPointer<vtkDataObject> Input;
  std::vector<Interval> Intervals;
  bool HasBoundaries = false;
  bool KeepsOrigins = false;
  bool HasCriterion = false;
  int Precision = vtkAlgorithm::DOUBLE_PRECISION;
};

void SetIntervals(vtkIntervalVolume* filter, const std::vector<Interval>& intervals)
{
  filter->SetNumberOfIntervals(static_cast<int>(intervals.size()));
  for (std::size_t i = 0; i < intervals.size(); ++i)
  {
    filter->SetInterval(static_cast<int>(i), intervals[i][0], intervals[i][1]);
  }
}

vtkSmartPointer<vtkIntervalVolume> MakeFilter(const Choice& choice)
{
  auto filter = vtkSmartPointer<vtkIntervalVolume>::New();
  filter->SetInputDataObject(choice.Input);
  filter->SetOutputPointsPrecision(choice.Precision);
  filter->SetGenerateBoundaries(choice.HasBoundaries);
  filter->SetKeepOrigins(choice.KeepsOrigins);
  if (choice.HasCriterion)
  {
    filter->AddCriterion("f", 0.2, 0.7);
  }
  SetIntervals(filter, choice.Intervals);
  return filter;
}

std::vector<Interval> MakeIntervals(FuzzRandom& random, vtkDataArray* values)
{
  std::vector<Interval> intervals;
  const int count = random.Whole(1, 4);
  for (int i = 0; i < count; ++i)
  {
    Interval interval = { { MakeBound(random, values), MakeBound(random, values) } };
    if (!random.Chance(0.05))
    {
      interval = { { std::min(interval[0], interval[1]), std::max(interval[0], interval[1]) } };
    }
    // Next to the one before, on itself, or anywhere.
    if (i > 0 && random.Chance(0.3) && interval[1] >= intervals.back()[1])
    {
      interval[0] = intervals.back()[1];
    }
    if (random.Chance(0.1))
    {
      interval[1] = interval[0];
    }
    intervals.push_back(interval);
  }
  return intervals;
}

/// Two blocks, one of them sometimes nothing.
vtkSmartPointer<vtkDataObject> MakeBlocks(FuzzRandom& random, vtkDataSet* data)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(2);
  blocks->SetBlock(0, data);
  if (random.Chance(0.5))
  {
    blocks->SetBlock(1, MakeData(random).Data);
  }
  return blocks;
}

vtkUnstructuredGrid* GetGrid(vtkAlgorithm* filter)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

/// The largest magnitude of finite values: interpolated ones are rounded by that times an epsilon.
double LargestValue(vtkDataArray* values)
{
  double largest = 1e-300;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = std::abs(values->GetTuple1(i));
    largest = std::isfinite(value) ? std::max(largest, value) : largest;
  }
  return largest;
}

/// Values of the points of each interval's cells are within its bounds, but for rounding.
void CheckValues(vtkUnstructuredGrid* grid, const std::vector<Interval>& intervals, double largest,
  reference::Check& check)
{
  vtkDataArray* ids = grid ? grid->GetCellData()->GetArray("IntervalId") : nullptr;
  vtkDataArray* values = grid ? grid->GetPointData()->GetScalars() : nullptr;
  if (!ids || !values)
  {
    return;
  }
  double worst = 0.0;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const Interval& interval = intervals.at(static_cast<std::size_t>(ids->GetTuple1(cell)));
    grid->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      const double value = values->GetTuple1(points->GetId(i));
      worst = std::max({ worst, (interval[0] - value) / largest, (value - interval[1]) / largest });
    }
  }
  check.Near(worst, 0.0, 1e-6, "values outside of their interval", 1.0);
}

/// Points are finite, whatever those of the input are; single precision, in which images give them
/// by default, may overflow, of which the filter warns.
void CheckPoints(vtkUnstructuredGrid* grid, reference::Check& check)
{
  vtkIdType nonFinite = 0;
  for (vtkIdType p = 0; grid && p < grid->GetNumberOfPoints(); ++p)
  {
    const double* x = grid->GetPoint(p);
    nonFinite += !(std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]));
  }
  check.That(nonFinite == 0 || grid->GetPoints()->GetDataType() == VTK_FLOAT,
    std::to_string(nonFinite) + " points are not finite");
}

/// The volumes of two intervals that meet are that of both together, and all values have all.
void CheckVolumes(vtkDataSet* data, FuzzRandom& random, reference::Check& check)
{
  vtkDataArray* values = data->GetPointData()->GetScalars();
  double range[2];
  values->GetRange(range);
  const double middle = range[0] + random.Unit() * (range[1] - range[0]);
  const auto volume = [&](const std::vector<Interval>& intervals)
  {
    Choice choice;
    choice.Input = data;
    choice.Intervals = intervals;
    const auto filter = MakeFilter(choice);
    Messages messages;
    filter->Update();
    return reference::MeasureTetrahedra(GetGrid(filter));
  };
  const auto whole = volume({ { range[0], range[1] } });
  const double expected = static_cast<double>(reference::MeshVolume(data));
  check.Near(static_cast<double>(whole.Sum), expected, 1e-10, "volume of all values", 1e-300);
  // An interval without width has cells of the other as well.
  if (range[0] < middle && middle < range[1])
  {
    const auto parts = volume({ { range[0], middle }, { middle, range[1] } });
    check.Near(static_cast<double>(parts.Sum), expected, 1e-10, "volume of two intervals", 1e-300);
  }
}

}

void RunIntervals(FuzzRandom& random, std::string& text, reference::Check& check)
{
  const FuzzData data = MakeData(random);
  vtkDataArray* values = data.Data->GetPointData()->GetScalars();
  Choice choice;
  choice.Intervals = MakeIntervals(random, values);
  choice.HasBoundaries = random.Chance(0.5);
  choice.KeepsOrigins = random.Chance(0.3);
  choice.HasCriterion = random.Chance(0.2);
  choice.Precision = random.Whole(0, 2);
  const bool isComposite = random.Chance(0.15);
  choice.Input = isComposite ? MakeBlocks(random, data.Data) : data.Data.Get();
  text = data.Text + (isComposite ? ", blocks" : "") + ", intervals";
  for (const Interval& interval : choice.Intervals)
  {
    text += " [" + std::to_string(interval[0]) + ", " + std::to_string(interval[1]) + "]";
  }
  CheckRun([&choice]() { return MakeFilter(choice); }, !isComposite, check);

  // Other bounds and back again, by the index of values.
  Messages messages;
  const auto filter = MakeFilter(choice);
  filter->Update();
  const std::string before = BytesOf(filter);
  if (!isComposite)
  {
    CheckValues(GetGrid(filter), choice.Intervals, LargestValue(values), check);
    CheckPoints(GetGrid(filter), check);
  }
  SetIntervals(filter, MakeIntervals(random, values));
  filter->Update();
  SetIntervals(filter, choice.Intervals);
  filter->Update();
  check.That(BytesOf(filter) == before, "the same after other intervals");
  if (data.IsTame && data.Data->GetNumberOfCells() > 0 &&
    data.Data->GetCell(0)->GetCellDimension() == 3)
  {
    CheckVolumes(data.Data, random, check);
  }
}

void RunContours(FuzzRandom& random, std::string& text, reference::Check& check)
{
  const FuzzData data = MakeData(random);
  vtkDataArray* values = data.Data->GetPointData()->GetScalars();
  std::vector<double> contours(static_cast<std::size_t>(random.Whole(1, 3)));
  text = data.Text + ", contours";
  for (double& contour : contours)
  {
    contour = MakeBound(random, values);
    text += " " + std::to_string(contour);
  }
  const auto make = [&]()
  {
    auto filter = vtkSmartPointer<vtkIsotableContour>::New();
    filter->SetInputDataObject(data.Data);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->SetNumberOfContours(static_cast<int>(contours.size()));
    for (std::size_t i = 0; i < contours.size(); ++i)
    {
      filter->SetValue(static_cast<int>(i), contours[i]);
    }
    return filter;
  };
  CheckRun(make, true, check);
  Messages messages;
  const auto filter = make();
  filter->Update();
  vtkUnstructuredGrid* grid = GetGrid(filter);
  CheckPoints(grid, check);
  vtkDataArray* found = grid ? grid->GetPointData()->GetScalars() : nullptr;
  const double largest = LargestValue(values);
  double worst = 0.0;
  for (vtkIdType i = 0; found && i < found->GetNumberOfTuples(); ++i)
  {
    double nearest = 1.0;
    for (const double contour : contours)
    {
      nearest = std::min(nearest, std::abs(found->GetTuple1(i) - contour) / largest);
    }
    worst = std::max(worst, nearest);
  }
  check.Near(worst, 0.0, 1e-6, "values off the contours", 1.0);
}

}
