// SPDX-License-Identifier: BSD-3-Clause
// Slices of 4-simplices along x, y and z, and by other hyperplanes: volumes of random simplices by
// formula, orientation, filled boxes, interval volumes of stacked time steps, and errors.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingSettings.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace
{

using namespace reference;
using Normal = std::array<double, 4>;

/// Applies the settings of a hyperplane with the given normal. A unit vector selects its axis.
void SetHyperplane(vtkSimplexTimeSlice* slice, const Normal& normal, double position)
{
  slice->FollowTimeOff();
  slice->SetSliceAxis(vtkSimplexTimeSlice::HYPERPLANE);
  for (int axis = 0; axis < 4; ++axis)
  {
    Normal unit{};
    unit[axis] = 1.0;
    if (normal == unit)
    {
      slice->SetSliceAxis(axis);
    }
  }
  slice->SetNormal(normal[0], normal[1], normal[2], normal[3]);
  slice->SetPosition(position);
  slice->SetTime(position);
}

/// Returns coordinates in which the slice is at one time: the position along the normal replaces
/// time, and time replaces the coordinate with the largest component of the normal.
Event Map(const Event& event, const Normal& normal)
{
  int largest = 3;
  double position = 0.0;
  for (int axis = 0; axis < 4; ++axis)
  {
    position += normal[axis] * event[axis];
    largest = std::abs(normal[axis]) > std::abs(normal[largest]) ? axis : largest;
  }
  Event mapped = event;
  mapped[largest] = event[3];
  mapped[3] = position;
  return mapped;
}

void TestRandomSimplices(Check& check)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Normal normals[] = { { { 1, 0, 0, 0 } }, { { 0, 1, 0, 0 } }, { { 0, 0, 1, 0 } },
    { { 0, 0, 0, 1 } }, { { -1, 0, 0, 0 } }, { { 0, 0, 0, -2 } }, { { 0.3, -2.0, 0.5, 1.0 } },
    { { 0.25, 0.5, -0.125, -3.0 } }, { { 0.5, 0.25, 4.0, -0.75 } } };
  for (const Normal& normal : normals)
  {
    check.SetContext("normal " + std::to_string(normal[0]) + " " + std::to_string(normal[1]) + " " +
      std::to_string(normal[2]) + " " + std::to_string(normal[3]));
    int crossed = 0;
    for (int i = 0; i < 300; ++i)
    {
      std::vector<Event> points(5);
      SimplexEvents mapped;
      double range[2] = { 1e9, -1e9 };
      for (int v = 0; v < 5; ++v)
      {
        std::generate(points[v].begin(), points[v].end(), [&] { return uniform(random); });
        mapped[v] = Map(points[v], normal);
        range[0] = std::min(range[0], mapped[v][3]);
        range[1] = std::max(range[1], mapped[v][3]);
      }
      const double position = range[0] + uniform(random) * (range[1] - range[0]);
      auto grid = MakeSimplexGrid(points, { { { 2, 0, 4, 1, 3 } } });
      vtkNew<vtkSimplexTimeSlice> slice;
      slice->SetInputData(grid);
      SetHyperplane(slice, normal, position);
      slice->Update();
      crossed += slice->GetOutput()->GetNumberOfCells() > 0 ? 1 : 0;
      const int sign = Determinant(GetSimplexEvents(grid, 0)) > 0 ? 1 : -1;
      // Mapped coordinates are those of the output, so the formula includes their change of volume.
      const long double expected = std::abs(SliceVolume(mapped, position));
      check.Near(static_cast<double>(sign * MeasureTetrahedra(slice->GetOutput()).Sum),
        static_cast<double>(expected), 1e-11, "signed volume", 1.0);
    }
    check.Equal(crossed, 300, "slices that are not empty");
  }
}

/// Returns the area of the boundary of tetrahedra, from VTK's filter.
double MeasureBoundary(vtkDataSet* tetrahedra)
{
  vtkNew<vtkGeometryFilter> surface;
  surface->SetInputData(tetrahedra);
  surface->Update();
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetOutput()->GetNumberOfCells(); ++cell)
  {
    surface->GetOutput()->GetCellPoints(cell, ids);
    double x[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetOutput()->GetPoint(ids->GetId(i), x[i]);
    }
    area += vtkTriangle::TriangleArea(x[0], x[1], x[2]);
  }
  return area;
}

/// Hypercubes fill [0,1]^3 x [0,3]. Their slices along a spatial axis fill a box, also where faces
/// of hypercubes lie in the hyperplane and at the ends.
void TestFilledBoxes(Check& check)
{
  for (const double moved : { 0.0, 0.15 })
  {
    KuhnOptions options;
    options.MovedInSpace = moved;
    options.MovedInTime = moved;
    auto grid = MakeKuhnGrid(options);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double position : { 0.0, 0.1, 1.0 / 3, 0.5, 2.0 / 3, 0.9, 1.0 })
      {
        check.SetContext("axis " + std::to_string(axis) + " at " + std::to_string(position) +
          ", moved by " + std::to_string(moved));
        vtkNew<vtkSimplexTimeSlice> slice;
        slice->SetInputData(grid);
        slice->SetSliceAxis(axis);
        slice->SetPosition(position);
        slice->Update();
        const TetrahedraVolume volume = MeasureTetrahedra(slice->GetOutput());
        check.Near(static_cast<double>(volume.Sum), 3.0, 1e-12, "volume");
        check.Equal(volume.Inverted, 0, "inverted tetrahedra");
        check.Near(MeasureBoundary(slice->GetOutput()), 14.0, 1e-12, "area of the boundary");
        double bounds[6];
        slice->GetOutput()->GetBounds(bounds);
        check.Near(bounds[2 * axis + 1], 3.0, 1e-12, "time is the coordinate of the axis");
        check.Near(slice->GetReport()->GetNumber("Time"), position, 0.0, "reported position");
      }
    }
  }
}

/// Returns the tetrahedra of a slice along an axis.
vtkSmartPointer<vtkUnstructuredGrid> SliceAlong(
  vtkUnstructuredGrid* simplices, int axis, double position)
{
  vtkNew<vtkSimplexTimeSlice> slice;
  slice->SetInputData(simplices);
  slice->SetSliceAxis(axis);
  slice->SetPosition(position);
  slice->WarnOnEmptyOutputOff();
  slice->Update();
  return slice->GetOutput();
}

/// Returns the image of a plane of grid points perpendicular to an axis at all time steps, which
/// are 1 apart. Time replaces the axis.
vtkSmartPointer<vtkImageData> StackPlane(const TimeSteps& steps, int axis, int plane)
{
  vtkImageData* first = vtkImageData::SafeDownCast(steps[0].Data);
  int points[3];
  double spacing[3];
  first->GetDimensions(points);
  first->GetSpacing(spacing);
  points[axis] = static_cast<int>(steps.size());
  spacing[axis] = 1.0;
  auto stacked = vtkSmartPointer<vtkImageData>::New();
  stacked->SetDimensions(points);
  stacked->SetSpacing(spacing);
  vtkNew<vtkDoubleArray> values;
  for (int k = 0; k < points[2]; ++k)
  {
    for (int j = 0; j < points[1]; ++j)
    {
      for (int i = 0; i < points[0]; ++i)
      {
        int at[3] = { i, j, k };
        vtkDataSet* step = GetDataSet(steps[at[axis]]);
        at[axis] = plane;
        values->InsertNextValue(
          step->GetPointData()->GetScalars()->GetComponent(first->ComputePointId(at), 0));
      }
    }
  }
  stacked->GetPointData()->SetScalars(values);
  return stacked;
}

/// Interval volumes over time are sliced at planes of grid points. The result is the interval
/// volume of the image that consists of this plane at all time steps. If the field is not linear,
/// faces are not planar, and their triangles depend on the dimension.
void TestStackedSteps(const std::string& field, double tolerance, Check& check)
{
  const std::vector<double> times{ 0.0, 1.0, 2.0, 3.0 };
  const int cells = 4;
  const TimeSteps steps = RepeatGrid(MakeImage({ { cells, cells, cells } }), times);
  TimeVaryingSettings settings;
  settings.Intervals = { { 0.3, 0.6 } };
  if (field == "linear")
  {
    AddSpaceTimeField(steps,
      [](const std::array<double, 3>& x, double time, vtkIdType)
      { return 0.11 * x[0] - 0.23 * x[1] + 0.07 * x[2] + 0.19 * time + 0.01; });
  }
  else
  {
    AddRandomTimeField(steps, 5);
  }
  const TimeVaryingExtraction extraction = ExtractTimeVarying(steps, settings);
  double bounds[6];
  GetDataSet(steps[0])->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int plane = 0; plane <= cells; ++plane)
    {
      check.SetContext(
        field + ", axis " + std::to_string(axis) + ", plane " + std::to_string(plane));
      vtkNew<vtkIntervalVolume> interval;
      interval->SetInputData(StackPlane(steps, axis, plane));
      interval->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      interval->SetInterval(0, settings.Intervals[0][0], settings.Intervals[0][1]);
      interval->Update();
      const double position =
        bounds[2 * axis] + plane * (bounds[2 * axis + 1] - bounds[2 * axis]) / cells;
      const TetrahedraVolume volume =
        MeasureTetrahedra(SliceAlong(extraction.Simplices, axis, position));
      const TetrahedraVolume expected =
        MeasureTetrahedra(vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(0)));
      check.That(expected.Sum > 0.01L, "there is an interval volume");
      check.Near(
        static_cast<double>(volume.Sum), static_cast<double>(expected.Sum), tolerance, "volume");
      check.That(volume.Inverted == 0 || field != "linear", "no inverted tetrahedra");
    }
  }
}

/// Many values equal a bound, so that some cells are tetrahedra at a time step. They are no part of
/// slices along an axis of space, because their slices are flat. A slice at a plane of grid points
/// consists of the limits of the slices on both sides.
void TestTies(Check& check)
{
  const int cells = 4;
  const TimeSteps steps =
    RepeatGrid(MakeImage({ { cells, cells, cells } }), { 0.0, 1.0, 2.0, 3.0 });
  AddIntegerTimeField(steps, 4, 5);
  TimeVaryingSettings settings;
  settings.Intervals = { { 1.0, 2.0 } };
  const auto simplices = ExtractTimeVarying(steps, settings).Simplices;
  vtkNew<vtkUnsignedCharArray> parts;
  parts->DeepCopy(simplices->GetCellData()->GetArray("AtStep"));
  parts->SetName("Part");
  simplices->GetCellData()->AddArray(parts);
  double range[2];
  parts->GetRange(range);
  check.Near(range[1], vtkTimeVaryingSettings::TETRAHEDRON_AT_STEP, 0.0, "tetrahedra at steps");
  double bounds[6];
  GetDataSet(steps[0])->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = (bounds[2 * axis + 1] - bounds[2 * axis]) / cells;
    for (int plane = 0; plane <= cells; ++plane)
    {
      check.SetContext("ties, axis " + std::to_string(axis) + ", plane " + std::to_string(plane));
      int at[3] = { 0, 0, 0 };
      at[axis] = plane;
      vtkImageData* image = vtkImageData::SafeDownCast(steps[0].Data);
      const double position = image->GetPoint(image->ComputePointId(at))[axis];
      const auto measure = [&](double offset)
      { return MeasureTetrahedra(SliceAlong(simplices, axis, position + offset * size)); };
      const double volume = static_cast<double>(measure(0.0).SumOfAbsolute);
      const double below = static_cast<double>(measure(-1e-9).SumOfAbsolute);
      const double above = static_cast<double>(measure(1e-9).SumOfAbsolute);
      check.That(volume >= std::max(below, above) - 1e-6, "the slice contains both limits");
      check.That(volume <= below + above + 1e-6, "the slice contains nothing else");
      const auto between = SliceAlong(simplices, axis, position + 0.3 * size);
      between->GetCellData()->GetArray("Part")->GetRange(range);
      check.That(range[1] < vtkTimeVaryingSettings::TETRAHEDRON_AT_STEP,
        "tetrahedra at a step are not sliced");
    }
  }
}

void TestErrors(Check& check)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  auto grid = MakeKuhnGrid(KuhnOptions());
  vtkNew<vtkSimplexTimeSlice> slice;
  slice->SetInputData(grid);
  const auto getErrors = [&](const Normal& normal, double position)
  {
    slice->SetSliceAxis(vtkSimplexTimeSlice::HYPERPLANE);
    slice->SetNormal(normal[0], normal[1], normal[2], normal[3]);
    slice->SetPosition(position);
    const std::string errors = UpdateAndGetErrors(slice);
    check.Equal(slice->GetOutput()->GetNumberOfCells(), 0, "no output");
    return errors;
  };
  check.SetContext("errors");
  check.Contains(getErrors({ { 0, 0, 0, 0 } }, 0.0), "Normal (0, 0, 0, 0)");
  check.Contains(getErrors({ { 0, nan, 0, 0 } }, 0.0), "Set a finite Normal");
  check.Contains(getErrors({ { 1, 0, 0, 0 } }, nan), "Set a finite Position");
  slice->SetPosition(7.0);
  check.Contains(WarningsOf(slice), "positions range from 0 to 1");
  slice->SetSliceAxis(vtkSimplexTimeSlice::TIME_AXIS);
  slice->SetTime(1.5);
  slice->Update();
  check.Near(static_cast<double>(MeasureTetrahedra(slice->GetOutput()).Sum), 1.0, 1e-12,
    "volume of a slice at a time, after the others");
}

}

int TestSimplexSliceAxes(int, char*[])
{
  Check check;
  TestRandomSimplices(check);
  TestFilledBoxes(check);
  TestStackedSteps("linear", 1e-12, check);
  TestStackedSteps("random", 0.02, check);
  TestTies(check);
  TestErrors(check);
  return check.Result();
}
