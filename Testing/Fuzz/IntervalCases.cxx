// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "Support/Checks/LargestError.h"
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
  bool HasOrigins = false;
  bool HasCriterion = false;
  int Operation = vtkIntervalVolume::INTERSECTION;
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
  filter->SetGenerateOriginArrays(choice.HasOrigins);
  if (choice.HasCriterion)
  {
    filter->AddCriterion("f", 0.2, 0.7);
    filter->SetCriteriaOperation(choice.Operation);
  }
  SetIntervals(filter, choice.Intervals);
  return filter;
}

std::vector<Interval> MakeIntervals(FuzzRandom& random, vtkDataArray* values)
{
  std::vector<Interval> intervals;
  const int count = random.Integer(1, 4);
  for (int i = 0; i < count; ++i)
  {
    Interval interval = { { MakeBound(random, values), MakeBound(random, values) } };
    if (!random.Chance(0.05))
    {
      interval = { { std::min(interval[0], interval[1]), std::max(interval[0], interval[1]) } };
    }
    // Some intervals are adjacent to the previous interval, and some are degenerate.
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

/// Returns two blocks; the second is null in some cases.
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

/// Returns the largest magnitude of the finite values, which scales the rounding error of
/// interpolation.
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

/// Checks that the values at the points of each interval's cells are within the bounds, up to
/// rounding error. Cells of a criterion belong to no interval.
void CheckValues(vtkUnstructuredGrid* grid, const std::vector<Interval>& intervals, double largest,
  reference::Check& check)
{
  vtkDataArray* ids = grid ? grid->GetCellData()->GetArray("IntervalId") : nullptr;
  vtkDataArray* values = grid ? grid->GetPointData()->GetScalars() : nullptr;
  if (!ids || !values)
  {
    return;
  }
  double largestError = 0.0;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (ids->GetTuple1(cell) < 0)
    {
      continue;
    }
    const Interval& interval = intervals.at(static_cast<std::size_t>(ids->GetTuple1(cell)));
    grid->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      const double value = values->GetTuple1(points->GetId(i));
      largestError = std::max(
        { largestError, (interval[0] - value) / largest, (value - interval[1]) / largest });
    }
  }
  check.Near(largestError, 0.0, 1e-6, "distance of values from their interval", 1.0);
}

/// Checks that all points are finite. In single precision, the default for images, coordinates may
/// overflow, and the filter then warns.
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

/// Checks that an interval that covers all values has the volume of the mesh, and that two adjacent
/// intervals together have the same volume.
void CheckVolumes(vtkDataSet* data, FuzzRandom& random, reference::Check& check)
{
  vtkDataArray* values = data->GetPointData()->GetScalars();
  double range[2];
  values->GetRange(range);
  const double bound = range[0] + random.Unit() * (range[1] - range[0]);
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
  const auto full = volume({ { range[0], range[1] } });
  const double expected = static_cast<double>(reference::MeshVolume(data));
  check.Near(static_cast<double>(full.Sum), expected, 1e-10, "volume of the full range", 1e-300);
  // With an interval of zero width, cells of that constant value would be counted twice.
  if (range[0] < bound && bound < range[1])
  {
    const auto parts = volume({ { range[0], bound }, { bound, range[1] } });
    check.Near(
      static_cast<double>(parts.Sum), expected, 1e-10, "volume of two adjacent intervals", 1e-300);
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
  choice.HasOrigins = random.Chance(0.3);
  choice.HasCriterion = random.Chance(0.2);
  choice.Operation = choice.HasCriterion ? random.Integer(0, 2) : choice.Operation;
  choice.Precision = random.Integer(0, 2);
  const bool isComposite = random.Chance(0.15);
  choice.Input = isComposite ? MakeBlocks(random, data.Data) : data.Data.Get();
  text = data.Text + (isComposite ? ", blocks" : "") + ", intervals";
  for (const Interval& interval : choice.Intervals)
  {
    text += " [" + std::to_string(interval[0]) + ", " + std::to_string(interval[1]) + "]";
  }
  CheckRun([&choice]() { return MakeFilter(choice); }, !isComposite, check);

  // Change the bounds and restore them; both updates use the cached value index.
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
  check.That(BytesOf(filter) == before, "the output is restored with the intervals");
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
  std::vector<double> contours(static_cast<std::size_t>(random.Integer(1, 3)));
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
  double largestError = 0.0;
  for (vtkIdType i = 0; found && i < found->GetNumberOfTuples(); ++i)
  {
    double nearest = 1.0;
    for (const double contour : contours)
    {
      nearest = std::min(nearest, std::abs(found->GetTuple1(i) - contour) / largest);
    }
    reference::KeepLargest(largestError, nearest);
  }
  check.Near(largestError, 0.0, 1e-6, "distance of values from the isovalues", 1.0);
}

}
