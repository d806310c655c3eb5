// SPDX-License-Identifier: BSD-3-Clause
// Point arrays of every type are interpolated in space and time, at thick points too; the arrays
// that the filter makes have the documented names, types and values; precision of the points.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{

using namespace reference;

struct CarriedType
{
  int Type;
  int Interpolated;
  double Tolerance;
};

const CarriedType Types[] = { { VTK_CHAR, VTK_FLOAT, 1e-6 }, { VTK_UNSIGNED_CHAR, VTK_FLOAT, 1e-6 },
  { VTK_SHORT, VTK_FLOAT, 1e-6 }, { VTK_INT, VTK_DOUBLE, 1e-13 },
  { VTK_LONG_LONG, VTK_DOUBLE, 1e-13 }, { VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE, 1e-13 },
  { VTK_FLOAT, VTK_FLOAT, 1e-6 }, { VTK_DOUBLE, VTK_DOUBLE, 1e-13 } };

std::string NameOf(int type, int components)
{
  return "array-" + std::to_string(type) + "-" + std::to_string(components);
}

/// An integer at the points of a lattice of integers and at the times used, from 0 to 100.
double Linear(const double* x, double time, int component)
{
  return 3 * x[0] + (2 + component) * x[1] + 4 * x[2] + 5 * time + 7 * component;
}

void AddTypes(const TimeSteps& steps, int components)
{
  for (const TimeStep& step : steps)
  {
    vtkDataSet* data = GetDataSet(step);
    for (const CarriedType& type : Types)
    {
      auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type.Type));
      array->SetName(NameOf(type.Type, components).c_str());
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(data->GetNumberOfPoints());
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        for (int c = 0; c < components; ++c)
        {
          array->SetComponent(i, c, Linear(data->GetPoint(i), step.Time, c));
        }
      }
      data->GetPointData()->AddArray(array);
    }
  }
}

/// Linear in place and time: at a thick point its mean is its value at the mean time.
void CheckInterpolated(vtkUnstructuredGrid* grid, int components, Check& check)
{
  vtkDataArray* times = grid->GetPointData()->GetArray("Time");
  if (!check.That(times != nullptr, "there are times"))
  {
    return;
  }
  for (const CarriedType& type : Types)
  {
    const std::string name = NameOf(type.Type, components);
    vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
    if (!check.That(array != nullptr, name + " is carried"))
    {
      continue;
    }
    check.Equal(array->GetDataType(), type.Interpolated, name + " has type");
    check.Equal(array->GetNumberOfComponents(), components, name + " has components");
    check.Equal(array->GetNumberOfTuples(), grid->GetNumberOfPoints(), name + " has values");
    double error = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        const double expected = Linear(grid->GetPoint(i), times->GetComponent(i, 0), c);
        error = std::max(error, std::abs(array->GetComponent(i, c) - expected));
      }
    }
    check.Near(error, 0, type.Tolerance, name + " is linear in place and time", 50);
  }
}

template <typename Array>
void CheckCellArray(
  vtkUnstructuredGrid* grid, const char* name, const std::set<int>& values, Check& check)
{
  auto* array = Array::SafeDownCast(grid->GetCellData()->GetArray(name));
  if (!check.That(array != nullptr, std::string(name) + " is there with its type"))
  {
    return;
  }
  check.Equal(array->GetNumberOfTuples(), grid->GetNumberOfCells(), std::string(name) + " values");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (!check.That(values.count(array->GetValue(i)) > 0, std::string(name) + " has its values"))
    {
      return;
    }
  }
}

void CheckPointArray(vtkUnstructuredGrid* grid, const char* name, Check& check)
{
  auto* array = vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetArray(name));
  check.That(array && array->GetNumberOfComponents() == 1 &&
      array->GetNumberOfTuples() == grid->GetNumberOfPoints(),
    std::string(name) + " is a double a point");
}

void CheckNames(const TimeVaryingExtraction& found, Check& check)
{
  const std::set<int> intervals = { 0, 1 };
  const std::set<int> slabs = { 0, 1 };
  for (vtkUnstructuredGrid* grid :
    { found.Tetrahedra.Get(), found.Boundaries.Get(), found.Simplices.Get() })
  {
    CheckPointArray(grid, "Time", check);
    CheckCellArray<vtkIntArray>(grid, "IntervalId", intervals, check);
    CheckCellArray<vtkIntArray>(grid, "TimeSlab", slabs, check);
    // Strings are those of a point, in order with the points of the output.
    auto* text = vtkStringArray::SafeDownCast(grid->GetPointData()->GetAbstractArray("text"));
    if (check.That(text && text->GetNumberOfValues() == grid->GetNumberOfPoints(), "strings"))
    {
      for (vtkIdType i = 0; i < text->GetNumberOfValues(); ++i)
      {
        if (!check.That(text->GetValue(i).rfind("point", 0) == 0, "strings are of points"))
        {
          break;
        }
      }
    }
  }
  CheckPointArray(found.Tetrahedra, "DeltaT", check);
  check.That(!found.Simplices->GetPointData()->HasArray("DeltaT"), "no DeltaT of 4-simplices");
  CheckCellArray<vtkUnsignedCharArray>(
    found.Tetrahedra, "SimplexClass", { 10, 20, 31, 32, 40, 50 }, check);
  CheckCellArray<vtkUnsignedCharArray>(found.Simplices, "AtStep", { 0, 1, 2 }, check);
  CheckCellArray<vtkIntArray>(found.Boundaries, "BoundaryKind", { 0, 1, 2, 3, 4, 5, 6, 7 }, check);
  double range[2];
  found.Tetrahedra->GetPointData()->GetArray("DeltaT")->GetRange(range);
  check.That(range[0] == 0 && range[1] > 0, "DeltaT from 0");
  check.Near(std::max(range[1], 4.0), 4, 1e-14, "DeltaT is at most a slab's length");
}

void CheckTypes(Check& check)
{
  for (const SpaceTimeGrid& grid : AllSpaceTimeGrids({ 3, 2, 2 }, 2))
  {
    for (int components : { 1, 3 })
    {
      // Integer arrays are linear where the points are at integers.
      if (!vtkUnstructuredGrid::SafeDownCast(grid.Data) || !HasBoxDomain(grid.Data))
      {
        continue;
      }
      check.SetContext(grid.Name + ", " + std::to_string(components) + " components");
      TimeSteps steps = RepeatGrid(grid.Data, { 0, 2, 6 });
      MovePoints(steps,
        [](std::array<double, 3>& x, double)
        {
          for (double& coordinate : x)
          {
            coordinate = std::round(2 * coordinate);
          }
        });
      AddRandomTimeField(steps, 1);
      AddTypes(steps, components);
      for (const TimeStep& step : steps)
      {
        vtkNew<vtkStringArray> text;
        text->SetName("text");
        for (vtkIdType i = 0; i < GetDataSet(step)->GetNumberOfPoints(); ++i)
        {
          text->InsertNextValue("point " + std::to_string(i));
        }
        GetDataSet(step)->GetPointData()->AddArray(text);
      }
      const TimeVaryingExtraction found =
        ExtractTimeVarying(steps, { { { 0.2, 0.4 }, { 0.4, 0.7 } } });
      CheckNames(found, check);
      CheckInterpolated(found.Tetrahedra, components, check);
      CheckInterpolated(found.Boundaries, components, check);
      CheckInterpolated(found.Simplices, components, check);
    }
  }
}

/// The means of an arbitrary array at the thick point lie between those of the points around it.
void CheckScalars(Check& check)
{
  check.SetContext("another array as the scalar");
  const TimeSteps steps = RepeatGrid(AllSpaceTimeGrids({ 2, 2, 2 }, 3).front().Data, { 0, 1 });
  AddRandomTimeField(steps, 1, "g");
  AddRandomTimeField(steps, 2, "f");
  const TimeVaryingPipeline pipeline(steps, { { { 0.25, 0.75 } } });
  vtkTimeVaryingIntervalVolume* filter = pipeline.Filter;
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "g");
  filter->Update();
  vtkUnstructuredGrid* grid = filter->GetOutput();
  double range[2];
  grid->GetPointData()->GetArray("g")->GetRange(range);
  check.That(range[0] >= 0.25 - 1e-15 && range[1] <= 0.75 + 1e-15, "it is in the interval");
  grid->GetPointData()->GetArray("f")->GetRange(range);
  check.That(range[0] >= 0 && range[0] < 0.2 && range[1] > 0.8 && range[1] <= 1,
    "the active array is interpolated as any");
}

/// Arrays that a step lacks are left out, and arrays named as those the filter makes are replaced.
void CheckOtherArrays(Check& check)
{
  check.SetContext("arrays of some steps");
  const TimeSteps steps = RepeatGrid(AllSpaceTimeGrids({ 2, 2, 2 }, 3).front().Data, { 0, 1, 2 });
  AddRandomTimeField({ steps[0], steps[1] }, 4, "early");
  AddRandomTimeField({ steps[2] }, 4, "late");
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>&, double, vtkIdType) { return -77.0; }, "Time");
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>&, double, vtkIdType) { return -77.0; }, "DeltaT");
  AddRandomTimeField(steps, 2);
  const TimeVaryingPipeline pipeline(steps, { { { 0.25, 0.75 } } });
  vtkTimeVaryingIntervalVolume* filter = pipeline.Filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  check.That(!observer->GetError(), "no error: " + observer->GetErrorMessage());
  for (int port = 0; port < 3; ++port)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
    check.That(grid->GetNumberOfCells() > 0, "there is output");
    for (int i = 0; i < grid->GetPointData()->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = grid->GetPointData()->GetAbstractArray(i);
      check.Equal(array->GetNumberOfTuples(), grid->GetNumberOfPoints(),
        std::string(array->GetName()) + " has a value for each point");
    }
    check.That(!grid->GetPointData()->HasArray("early") && !grid->GetPointData()->HasArray("late"),
      "arrays that a step lacks are not there");
    double range[2];
    grid->GetPointData()->GetArray("Time")->GetRange(range);
    check.That(range[0] >= 0 && range[1] <= 2, "the times are the filter's");
  }
  double range[2];
  filter->GetOutput()->GetPointData()->GetArray("DeltaT")->GetRange(range);
  check.That(range[0] == 0 && range[1] > 0, "DeltaT is the filter's");
}

/// Point arrays of three steps: `b` has another place in the last one, and others have roles.
void AddMixedArrays(const TimeSteps& steps)
{
  const auto add = [](const char* name, double rate)
  {
    return [name, rate](const TimeStep& step)
    {
      AddSpaceTimeField(
        { step },
        [rate](const std::array<double, 3>& x, double time, vtkIdType)
        { return rate * x[0] + x[1] + 2.0 * x[2] - rate * rate * time; },
        name);
    };
  };
  for (const TimeStep& step : steps)
  {
    GetDataSet(step)->GetPointData()->Initialize();
    const bool isLast = step.Time == steps.back().Time;
    if (!isLast)
    {
      add("a", 3.0)(step);
    }
    double box[6];
    GetDataSet(step)->GetBounds(box);
    AddSpaceTimeField({ step },
      [&box](const std::array<double, 3>& x, double time, vtkIdType)
      { return (x[2] - box[4]) / (box[5] - box[4]) + 0.125 * time; });
    if (isLast)
    {
      add("a", 3.0)(step);
    }
    add("b", 5.0)(step);
    vtkNew<vtkDoubleArray> places;
    places->SetNumberOfComponents(3);
    places->SetName("places");
    for (vtkIdType i = 0; i < GetDataSet(step)->GetNumberOfPoints(); ++i)
    {
      places->InsertNextTuple(GetDataSet(step)->GetPoint(i));
    }
    GetDataSet(step)->GetPointData()->SetVectors(places);
    GetDataSet(step)->GetPointData()->SetActiveScalars("f");
  }
}

/// Arrays without a name come out as with one, on every kind of grid.
void CheckUnnamedArrays(Check& check)
{
  const char* const names[] = { "a", "f", "b", "places" };
  for (const SpaceTimeGrid& grid : AllSpaceTimeGrids({ 2, 2, 2 }, 3))
  {
    check.SetContext("arrays without a name, " + grid.Name);
    const TimeSteps steps = RepeatGrid(grid.Data, { 0, 1, 2 });
    AddMixedArrays(steps);
    const TimeVaryingSettings settings = { { { -1.0, 0.65 } } };
    const TimeVaryingExtraction named = ExtractTimeVarying(steps, settings);
    for (const TimeStep& step : steps)
    {
      for (const char* name : names)
      {
        GetDataSet(step)->GetPointData()->GetArray(name)->SetName(nullptr);
      }
    }
    const TimeVaryingExtraction unnamed = ExtractTimeVarying(steps, settings);
    // The fraction of the height below 0.65 - t / 8 is 0.525 in the mean over two units of time.
    const double expected = static_cast<double>(MeshVolume(grid.Data)) * 2.0 * 0.525;
    if (HasBoxDomain(grid.Data))
    {
      check.Near(static_cast<double>(MeasureSimplices(unnamed.Simplices).Sum), expected, 1e-12,
        "hypervolume");
    }
    vtkUnstructuredGrid* const found[] = { unnamed.Tetrahedra, unnamed.Boundaries,
      unnamed.Simplices };
    vtkUnstructuredGrid* const wanted[] = { named.Tetrahedra, named.Boundaries, named.Simplices };
    for (int port = 0; port < 3; ++port)
    {
      vtkPointData* arrays = found[port]->GetPointData();
      int place = 0;
      for (int a = 0; a < arrays->GetNumberOfArrays() && place < 4; ++a)
      {
        if (!arrays->GetArray(a)->GetName())
        {
          vtkDataArray* same = wanted[port]->GetPointData()->GetArray(names[place++]);
          double difference = same->GetNumberOfTuples() != arrays->GetArray(a)->GetNumberOfTuples();
          for (vtkIdType i = 0; difference == 0.0 && i < same->GetNumberOfTuples(); ++i)
          {
            for (int c = 0; c < same->GetNumberOfComponents(); ++c)
            {
              difference = std::max(difference,
                std::abs(same->GetComponent(i, c) - arrays->GetArray(a)->GetComponent(i, c)));
            }
          }
          check.Near(difference, 0.0, 0.0, std::string("values of ") + names[place - 1], 1.0);
        }
      }
      check.Equal(place, 4, "arrays without a name of port " + std::to_string(port));
      check.That(arrays->GetScalars() && !arrays->GetScalars()->GetName() && arrays->GetVectors(),
        "scalars and vectors are active");
    }
  }
}

/// An array without a name that a step lacks is left out with a warning; the others stay.
void CheckUnnamedLeftOut(Check& check)
{
  check.SetContext("an array without a name of some steps");
  const TimeSteps steps = RepeatGrid(AllSpaceTimeGrids({ 2, 2, 2 }, 3).front().Data, { 0, 1, 2 });
  AddMixedArrays(steps);
  for (const TimeStep& step : steps)
  {
    GetDataSet(step)->GetPointData()->GetArray("f")->SetName(nullptr);
    GetDataSet(step)->GetPointData()->GetArray("b")->SetName(nullptr);
  }
  vtkPointData* last = GetDataSet(steps[2])->GetPointData();
  for (int a = last->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    if (!last->GetArray(a)->GetName() && last->IsArrayAnAttribute(a) < 0)
    {
      last->RemoveArray(a);
    }
  }
  const TimeVaryingPipeline pipeline(steps, { { { -1.0, 0.65 } } });
  const std::string said = WarningsOf(pipeline.Filter);
  check.That(said.find("point array without a name is left out") != std::string::npos,
    "it is reported: " + said);
  vtkPointData* arrays = pipeline.Filter->GetOutput()->GetPointData();
  check.That(arrays->GetScalars() != nullptr, "the scalars stay");
  check.Equal(arrays->GetNumberOfArrays(), 5, "scalars, a, places, Time, DeltaT");
}

void SetPointsType(const TimeSteps& steps, int type)
{
  for (const TimeStep& step : steps)
  {
    auto* grid = vtkPointSet::SafeDownCast(step.Data);
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->SetNumberOfPoints(grid->GetNumberOfPoints());
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, grid->GetPoint(i));
    }
    grid->SetPoints(points);
  }
}

void CheckPrecision(const SpaceTimeGrid& grid, int type, Check& check)
{
  const TimeSteps steps = RepeatGrid(grid.Data, { 0, 1 });
  const bool hasPoints = vtkPointSet::SafeDownCast(grid.Data) != nullptr;
  if (hasPoints)
  {
    SetPointsType(steps, type);
  }
  AddRandomTimeField(steps, 2);
  const TimeVaryingPipeline pipeline(steps, { { { 0.25, 0.75 } } });
  vtkTimeVaryingIntervalVolume* filter = pipeline.Filter;
  const int own = hasPoints ? type : grid.Name == "image" ? VTK_FLOAT : VTK_DOUBLE;
  const std::pair<int, int> cases[] = { { vtkAlgorithm::DEFAULT_PRECISION, own },
    { vtkAlgorithm::SINGLE_PRECISION, VTK_FLOAT }, { vtkAlgorithm::DOUBLE_PRECISION, VTK_DOUBLE } };
  for (const auto& [precision, expected] : cases)
  {
    check.SetContext(grid.Name + ", points of type " + std::to_string(type) + ", precision " +
      std::to_string(precision));
    filter->SetOutputPointsPrecision(precision);
    filter->Update();
    for (int port = 0; port < 3; ++port)
    {
      auto* found = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
      check.Equal(found->GetPoints()->GetDataType(), expected,
        "type of the points of port " + std::to_string(port));
    }
    auto* simplices = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(2));
    check.Near(static_cast<double>(MeasureWeighted(filter->GetOutput()).Sum),
      static_cast<double>(MeasureSimplices(simplices).Sum), expected == VTK_FLOAT ? 1e-5 : 1e-12,
      "hypervolume");
  }
}

}

int TestTimeVaryingArrays(int, char*[])
{
  Check check;
  CheckTypes(check);
  CheckScalars(check);
  CheckOtherArrays(check);
  CheckUnnamedArrays(check);
  CheckUnnamedLeftOut(check);
  for (const SpaceTimeGrid& grid : AllSpaceTimeGrids({ 2, 2, 2 }, 3))
  {
    CheckPrecision(grid, VTK_FLOAT, check);
    CheckPrecision(grid, VTK_DOUBLE, check);
  }
  return check.Result();
}
