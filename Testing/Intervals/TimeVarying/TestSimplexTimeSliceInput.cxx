// SPDX-License-Identifier: BSD-3-Clause
// Invalid input: an error names the problem and its location, the output is empty, and the filter
// works again with valid input. Ghosts and 4-simplices with a non-finite time are skipped. A time
// outside the range or an empty input yields an empty output without an error. Composite input
// yields composite output.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace
{

using namespace reference;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

KuhnOptions MakeOptions()
{
  KuhnOptions options;
  options.Cells = { { 2, 2, 2, 1 } };
  return options;
}

/// Updates the filter and returns its errors or, depending on \a event, its warnings.
std::string SliceWatched(vtkSimplexTimeSlice* filter, vtkDataObject* input, double t,
  unsigned long event = vtkCommand::ErrorEvent)
{
  vtkNew<vtkTest::ErrorObserver> watch;
  const unsigned long filterTag = filter->AddObserver(event, watch);
  const unsigned long pipelineTag =
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, watch);
  filter->SetInputDataObject(input);
  filter->SetTime(t);
  filter->Update();
  filter->RemoveObserver(filterTag);
  filter->GetExecutive()->RemoveObserver(pipelineTag);
  return event == vtkCommand::ErrorEvent ? watch->GetErrorMessage() : watch->GetWarningMessage();
}

struct ErrorCase
{
  const char* Name;
  double Time;
  std::vector<std::string> Named; ///< texts that the message must contain
  std::function<void(vtkUnstructuredGrid*)> Break;
};

/// Replaces the point array Time.
void SetTimes(vtkUnstructuredGrid* grid, vtkAbstractArray* times)
{
  times->SetName("Time");
  grid->GetPointData()->AddArray(times);
}

/// Sets the type of cell 7 and retains only its first \a points points.
void BreakCell(vtkUnstructuredGrid* grid, int type, vtkIdType points)
{
  vtkNew<vtkUnstructuredGrid> broken;
  broken->SetPoints(grid->GetPoints());
  broken->GetPointData()->ShallowCopy(grid->GetPointData());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    ids->SetNumberOfIds(cell == 7 ? points : 5);
    broken->InsertNextCell(cell == 7 ? type : VTK_POLY_VERTEX, ids);
  }
  grid->ShallowCopy(broken);
}

void CheckErrors(Check& check)
{
  const std::vector<ErrorCase> cases = {
    { "no Time", 0.5, { "Time" },
      [](vtkUnstructuredGrid* grid) { grid->GetPointData()->RemoveArray("Time"); } },
    { "two components", 0.5, { "Time", "2 components" },
      [](vtkUnstructuredGrid* grid)
      {
        vtkNew<vtkDoubleArray> times;
        times->SetNumberOfComponents(2);
        times->SetNumberOfTuples(grid->GetNumberOfPoints());
        SetTimes(grid, times);
      } },
    { "too few times", 0.5, { "Time", "3 tuples", "54 are needed, one for each point" },
      [](vtkUnstructuredGrid* grid)
      {
        vtkNew<vtkDoubleArray> times;
        times->SetNumberOfTuples(3);
        SetTimes(grid, times);
      } },
    { "words", 0.5, { "Time", "vtkStringArray" },
      [](vtkUnstructuredGrid* grid)
      {
        vtkNew<vtkStringArray> times;
        times->SetNumberOfValues(grid->GetNumberOfPoints());
        SetTimes(grid, times);
      } },
    { "a tetrahedron", 0.5, { "Cell 7 ", "type 10", "4 points" },
      [](vtkUnstructuredGrid* grid) { BreakCell(grid, VTK_TETRA, 4); } },
    { "a pyramid", 0.5, { "Cell 7 ", "type 14", "5 points" },
      [](vtkUnstructuredGrid* grid) { BreakCell(grid, VTK_PYRAMID, 5); } },
    { "four points", 0.5, { "Cell 7 ", "type 2", "4 points" },
      [](vtkUnstructuredGrid* grid) { BreakCell(grid, VTK_POLY_VERTEX, 4); } },
    { "no points", 0.5, { "Cell 7 ", "0 points" },
      [](vtkUnstructuredGrid* grid) { BreakCell(grid, VTK_EMPTY_CELL, 0); } },
    { "NaN", NaN, { "nan" }, [](vtkUnstructuredGrid*) {} },
    { "infinity", Infinity, { "inf" }, [](vtkUnstructuredGrid*) {} },
  };
  for (const ErrorCase& one : cases)
  {
    check.SetContext(one.Name);
    auto grid = MakeKuhnGrid(MakeOptions());
    one.Break(grid);
    vtkNew<vtkSimplexTimeSlice> filter;
    const std::string message = SliceWatched(filter, grid, one.Time);
    check.That(!message.empty(), "there is an error");
    for (const std::string& part : one.Named)
    {
      check.That(message.find(part) != std::string::npos, "the error names " + part);
    }
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "points");
    check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells");
    const std::string later = SliceWatched(filter, MakeKuhnGrid(MakeOptions()), 0.5);
    check.That(later.empty(), "no error after the correction: " + later);
    check.That(
      filter->GetOutput()->GetNumberOfCells() > 0, "the filter works after the correction");
  }
}

void CheckNothing(Check& check)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkNew<vtkUnstructuredGrid> pointsOnly;
  auto grid = MakeKuhnGrid(MakeOptions());
  pointsOnly->SetPoints(grid->GetPoints());
  pointsOnly->GetPointData()->ShallowCopy(grid->GetPointData());
  const struct
  {
    const char* Name;
    vtkUnstructuredGrid* Input;
    double Time;
    std::vector<std::string> Named;
  } cases[] = { { "nothing", nothing, 0.5, { "no 4-simplices" } },
    { "no cells", pointsOnly, 0.5, { "0.5" } },
    { "before", grid, -0.001, { "time -0.001", "from 0 to 1" } },
    { "after", grid, 1.001, { "time 1.001", "from 0 to 1" } },
    { "long before", grid, -1e308, { "-1e+308", "from 0 to 1" } } };
  for (const auto& one : cases)
  {
    check.SetContext(one.Name);
    vtkNew<vtkSimplexTimeSlice> filter;
    const std::string message = SliceWatched(filter, one.Input, one.Time, vtkCommand::WarningEvent);
    for (const std::string& part : one.Named)
    {
      check.That(
        message.find(part) != std::string::npos, "the warning has " + part + ": " + message);
    }
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "points");
    check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells");
  }
}

/// Returns a grid of the cells that \a isSelected accepts.
Grid Select(vtkUnstructuredGrid* grid, const std::function<bool(vtkIdType)>& isSelected)
{
  std::vector<Event> points(grid->GetNumberOfPoints());
  std::vector<SimplexIds> simplices;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const SimplexIds ids = GetSimplexIds(grid, cell);
    const SimplexEvents events = GetSimplexEvents(grid, cell);
    for (size_t v = 0; v < ids.size(); ++v)
    {
      points[ids[v]] = events[v];
    }
    if (isSelected(cell))
    {
      simplices.push_back(ids);
    }
  }
  return MakeSimplexGrid(points, simplices);
}

/// Checks that slices of two grids are equal.
void CheckSame(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* expected, Check& check)
{
  for (const double t : { 0.0, 0.4, 1.0 })
  {
    auto slice = SliceAt(expected, t);
    check.That(slice->GetNumberOfCells() > 0, "there are tetrahedra");
    check.That(FindDifference(SliceAt(grid, t), slice).empty(),
      "the slice contains exactly the expected tetrahedra");
  }
}

void CheckLeftOut(Check& check)
{
  for (const double time : { NaN, Infinity, -Infinity })
  {
    check.SetContext("time " + std::to_string(time));
    auto grid = MakeKuhnGrid(MakeOptions());
    auto uses = [&grid](vtkIdType cell)
    {
      const SimplexIds ids = GetSimplexIds(grid, cell);
      return std::find(ids.begin(), ids.end(), 11) != ids.end();
    };
    auto expected = Select(grid, [&uses](vtkIdType cell) { return !uses(cell); });
    grid->GetPointData()->GetArray("Time")->SetComponent(11, 0, time);
    CheckSame(grid, expected, check);
  }
  const unsigned char cellMarks[] = { vtkDataSetAttributes::DUPLICATECELL,
    vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::REFINEDCELL };
  for (const unsigned char mark : cellMarks)
  {
    check.SetContext("cells flagged " + std::to_string(mark));
    auto grid = MakeKuhnGrid(MakeOptions());
    auto expected = Select(grid, [](vtkIdType cell) { return cell % 3 != 0; });
    vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); cell += 3)
    {
      ghosts->SetValue(cell, mark);
    }
    CheckSame(grid, expected, check);
  }
  check.SetContext("a hidden point");
  auto grid = MakeKuhnGrid(MakeOptions());
  auto expected = Select(grid,
    [&grid](vtkIdType cell)
    {
      const SimplexIds ids = GetSimplexIds(grid, cell);
      return std::find(ids.begin(), ids.end(), 11) == ids.end();
    });
  grid->AllocatePointGhostArray()->SetValue(11, vtkDataSetAttributes::HIDDENPOINT);
  CheckSame(grid, expected, check);
}

/// Slices of 4-simplices with repeated points or with equal times are empty.
void CheckDegenerate(Check& check)
{
  check.SetContext("degenerate");
  const std::vector<Event> points = { { { 0, 0, 0, 0 } }, { { 1, 0, 0, 0 } }, { { 0, 1, 0, 1 } },
    { { 0, 0, 1, 1 } }, { { 1, 1, 1, 0 } }, { { 2, 1, 1, 0 } } };
  auto grid = MakeSimplexGrid(points,
    { { { 0, 1, 2, 3, 3 } }, { { 0, 0, 2, 3, 1 } }, { { 4, 0, 1, 4, 2 } }, { { 0, 1, 4, 5, 0 } } });
  for (const double t : { 0.0, 0.5, 1.0 })
  {
    check.Equal(SliceAt(grid, t)->GetNumberOfPoints(), 0, "points");
    check.Equal(SliceAt(grid, t)->GetNumberOfCells(), 0, "cells");
  }
}

void CheckComposite(Check& check)
{
  check.SetContext("composite");
  KuhnOptions other = MakeOptions();
  other.Seed = 5;
  const std::vector<Grid> leaves = { MakeKuhnGrid(MakeOptions()), MakeKuhnGrid(other) };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(0, leaves[0]);
  blocks->SetBlock(2, leaves[1]);
  vtkNew<vtkSimplexTimeSlice> filter;
  const std::string message = SliceWatched(filter, blocks, 0.4);
  check.That(message.empty(), "no error: " + message);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  if (!check.That(
        output && output->GetNumberOfBlocks() == 3, "the output has the structure of the input"))
  {
    return;
  }
  for (unsigned int i : { 0u, 1u })
  {
    auto* slice = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(2 * i));
    check.That(slice && FindDifference(slice, SliceAt(leaves[i], 0.4)).empty(), "slice of a leaf");
  }
}

}

int TestSimplexTimeSliceInput(int, char*[])
{
  Check check;
  CheckErrors(check);
  CheckNothing(check);
  CheckLeftOut(check);
  CheckDegenerate(check);
  CheckComposite(check);
  return check.Result();
}
