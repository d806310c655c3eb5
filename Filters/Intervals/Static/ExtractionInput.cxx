// SPDX-License-Identifier: BSD-3-Clause
#include "Static/ExtractionInput.h"

#include "Output/ExtractionReport.h"
#include "Arrays/ExtractionArrays.h"
#include "Common/ArrayCheck.h"
#include "Common/AxisCheck.h"
#include "Common/GlobalIds.h"
#include "Common/GridCheck.h"
#include "Common/IntervalCheck.h"
#include "Pass/NonFinitePoints.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace interlume
{

namespace
{
vtkDataArray* GetAxis(vtkRectilinearGrid* grid, int axis)
{
  vtkDataArray* const axes[] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  return axes[axis];
}

// Returns an error for the first array with fewer than \a number tuples, which would be read past
// its end.
Error FindShortArray(vtkDataSetAttributes* arrays, vtkIdType number, const char* thing)
{
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(a);
    if (array->GetNumberOfTuples() < number)
    {
      return ArrayCheck::Describe(array) + " has " +
        ArrayCheck::Count(array->GetNumberOfTuples(), "tuple") + "; " + std::to_string(number) +
        " are needed, one for each " + thing;
    }
  }
  return {};
}

// Returns the smallest nonzero distance between successive coordinates, or 0.
double FindMinimumStep(vtkDataArray* coordinates)
{
  double minimum = 0.0;
  for (vtkIdType i = 1; i < coordinates->GetNumberOfTuples(); ++i)
  {
    const double step =
      std::abs(coordinates->GetComponent(i, 0) - coordinates->GetComponent(i - 1, 0));
    minimum = step > 0.0 && (minimum == 0.0 || step < minimum) ? step : minimum;
  }
  return minimum;
}

// Returns an error if a polygon or strip of a surface is invalid.
Error FindPolygonError(vtkDataSet* input)
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  Error error;
  for (const int type : { VTK_POLYGON, VTK_TRIANGLE_STRIP })
  {
    if (surface && !error)
    {
      vtkNew<vtkUnstructuredGrid> grid;
      grid->SetPoints(surface->GetPoints());
      grid->SetCells(type, type == VTK_POLYGON ? surface->GetPolys() : surface->GetStrips());
      error = GridCheck::FindError(grid);
    }
  }
  return error;
}
}

Error ExtractionInput::CheckScalars(
  vtkDataSet* input, vtkAbstractArray* array, int association, const std::string& wanted)
{
  if (!array)
  {
    return "The input has no " + wanted + ".";
  }
  // Structured grids do not use global ids, unless they are extracted as polygons.
  int dimensions[3];
  const bool usesIds = !ExtractionArrays::GetRowDimensions(input, dimensions) ||
    *std::min_element(dimensions, dimensions + 3) < 2;
  return ArrayCheck::MakeSentence(
    ArrayCheck::FindError(input, array, association, 1)
      .Then([&] { return GridCheck::FindError(input); })
      .Then([&] { return FindPolygonError(input); })
      .Then([&] { return usesIds ? GlobalIds::FindError(input) : Error(); })
      .Then(
        [&] { return FindShortArray(input->GetPointData(), input->GetNumberOfPoints(), "point"); })
      .Then(
        [&] { return FindShortArray(input->GetCellData(), input->GetNumberOfCells(), "cell"); }));
}

Error ExtractionInput::CheckIntervals(const std::vector<std::array<double, 2>>& intervals)
{
  Error error;
  for (std::size_t i = 0; !error && i < intervals.size(); ++i)
  {
    error =
      IntervalCheck::FindError("Interval " + std::to_string(i), intervals[i][0], intervals[i][1]);
  }
  return error;
}

std::string ExtractionInput::CheckPrecision(vtkDataSet* input, int precision)
{
  double sizes[3] = { 0.0, 0.0, 0.0 };
  if (vtkImageData* image = vtkImageData::SafeDownCast(input))
  {
    image->GetSpacing(sizes);
  }
  else if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      sizes[axis] = FindMinimumStep(GetAxis(grid, axis));
    }
  }
  double size = 0.0;
  for (const double one : sizes)
  {
    size = one != 0.0 && (size == 0.0 || std::abs(one) < size) ? std::abs(one) : size;
  }
  if (size == 0.0 || ExtractionArrays::ChoosePointType(input, precision) != VTK_FLOAT)
  {
    return std::string();
  }
  double bounds[6];
  input->GetBounds(bounds);
  double farthest = 0.0;
  for (const double bound : bounds)
  {
    farthest = std::max(farthest, std::abs(bound));
  }
  constexpr double tolerance = 0.01;
  const double rounding = 0.5 * farthest * std::numeric_limits<float>::epsilon();
  if (rounding <= tolerance * size || !std::isfinite(farthest))
  {
    return std::string();
  }
  std::ostringstream message;
  message << "Points in single precision have errors of up to " << rounding
          << ", but cells are only " << size << " wide, at a distance of up to " << farthest
          << " from the origin. Set OutputPointsPrecision to double, or move the origin.";
  return message.str();
}

std::string ExtractionInput::CheckPolyhedra(vtkIdType numberOfConcave)
{
  return numberOfConcave == 0 ? std::string()
                              : std::to_string(numberOfConcave) +
      " polyhedra cannot be split around the mean of their points, because they or their faces are "
      "concave. Their tetrahedra overlap, and volumes are too large. Split them into convex cells "
      "first.";
}

vtkIdType ExtractionInput::CountFoldedRectilinearCells(vtkDataSet* input)
{
  vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input);
  vtkIdType unfolded = 1;
  int size[3] = { 1, 1, 1 };
  if (grid)
  {
    grid->GetDimensions(size);
  }
  for (int axis = 0; grid && axis < 3; ++axis)
  {
    unfolded *=
      std::max(size[axis] - 1, 1) - AxisCheck::Find(GetAxis(grid, axis), size[axis]).Number;
  }
  return grid ? grid->GetNumberOfCells() - unfolded : 0;
}

std::string ExtractionInput::CheckFolding(vtkDataSet* input, vtkIdType numberOfFolded)
{
  if (numberOfFolded == 0)
  {
    return {};
  }
  vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input);
  if (!grid)
  {
    return std::to_string(numberOfFolded) +
      " cells are folded or intersect themselves, so their output overlaps. Check the order of "
      "their points (voxels and hexahedra have different orders), or move the points.";
  }
  std::string words;
  int size[3];
  grid->GetDimensions(size);
  for (int axis = 0; axis < 3; ++axis)
  {
    const AxisCheck reversals = AxisCheck::Find(GetAxis(grid, axis), size[axis]);
    if (reversals.Number > 0)
    {
      words += (words.empty() ? "" : ", and ") + reversals.Describe(axis, GetAxis(grid, axis));
    }
  }
  return ArrayCheck::MakeSentence(words + ": " + std::to_string(numberOfFolded) +
    " cells have no volume or overlap others. Use coordinates that increase or decrease strictly");
}

std::vector<std::string> ExtractionInput::GetWarnings(
  vtkDataSet* input, int dimension, int precision, const ExtractionReport& report)
{
  std::vector<std::string> warnings;
  if (report.LinearizedCells > 0)
  {
    warnings.push_back(std::to_string(report.LinearizedCells) +
      " quadratic or higher-order cells are treated as linear cells with the same corners.");
  }
  if (report.UnsupportedCells > 0)
  {
    warnings.push_back(std::to_string(report.UnsupportedCells) +
      " cells are skipped because their type is not supported.");
  }
  for (const std::string& warning : { CheckPolyhedra(report.ConcavePolyhedra),
         CheckFolding(input, report.FoldedCells), CheckPrecision(input, precision),
         report.NonFiniteCells > 0 ? NonFinitePoints(input).Describe(input, dimension)
                                   : std::string() })
  {
    if (!warning.empty())
    {
      warnings.push_back(warning);
    }
  }
  return warnings;
}

vtkSmartPointer<vtkDataSet> ExtractionInput::HideCells(
  vtkDataSet* input, const std::function<bool(vtkIdList*)>& isHidden)
{
  const auto copy = vtk::TakeSmartPointer(input->NewInstance());
  copy->ShallowCopy(input);
  const vtkIdType cells = input->GetNumberOfCells();
  vtkUnsignedCharArray* const before = input->GetCellGhostArray();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(cells);
  vtkNew<vtkIdList> first;
  if (cells > 0)
  {
    // Build the structures that the parallel calls need.
    input->GetCellPoints(0, first);
  }
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> points;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        input->GetCellPoints(cell, points);
        const int flags = before ? before->GetValue(cell) : 0;
        ghosts->SetValue(cell,
          static_cast<unsigned char>(
            isHidden(points) ? flags | vtkDataSetAttributes::HIDDENCELL : flags));
      }
    });
  copy->GetCellData()->AddArray(ghosts);
  return copy;
}

std::string ExtractionInput::DescribeArrayToProcess(vtkAlgorithm* owner)
{
  vtkInformation* info = owner->GetInputArrayInformation(0);
  if (info->Has(vtkDataObject::FIELD_NAME()))
  {
    return std::string("point or cell array \"") + info->Get(vtkDataObject::FIELD_NAME()) + "\"";
  }
  return "active scalars";
}

}
