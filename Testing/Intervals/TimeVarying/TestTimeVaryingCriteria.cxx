// SPDX-License-Identifier: BSD-3-Clause
// Criteria of vtkTimeVaryingIntervalVolume: hypervolumes by formula, slices in time compared with
// clipped tetrahedra, parts that add up, conforming 4-simplices with a closed boundary, ties, cell
// arrays, messages.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceChain.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace
{

using namespace reference;
using Filter = vtkTimeVaryingIntervalVolume;

const std::vector<double> Times = { 1.0, 1.5, 4.0 };

using Criterion = Range;

TimeVaryingExtraction Extract(const TimeSteps& steps, const std::vector<Interval>& intervals,
  const std::vector<Criterion>& criteria, int operation = Filter::INTERSECTION)
{
  TimeVaryingSettings settings;
  settings.Intervals = intervals;
  settings.Criteria = criteria;
  settings.CriteriaOperation = operation;
  const TimeVaryingPipeline pipeline(steps, settings);
  pipeline.Filter->WarnOnEmptyOutputOff();
  pipeline.Filter->Update();
  const auto output = [&](int port)
  { return vtkUnstructuredGrid::SafeDownCast(pipeline.Filter->GetOutputDataObject(port)); };
  return { output(0), output(1), output(2), pipeline.Filter->GetReport() };
}

double Measure(const TimeVaryingExtraction& found)
{
  return static_cast<double>(MeasureSimplices(found.Simplices).Sum);
}

/// Checks that 4-simplices and tetrahedra have the given hypervolume. On linear arrays, no
/// 4-simplex is inverted.
void CheckMeasure(const TimeVaryingExtraction& found, double expected, double scale, Check& check,
  bool isLinear = false)
{
  const HypervolumeSum simplices = MeasureSimplices(found.Simplices);
  const HypervolumeSum tetrahedra = MeasureWeightedTetrahedra(found.Tetrahedra);
  check.Near(static_cast<double>(simplices.Sum), expected, 1e-12, "hypervolume", scale);
  if (isLinear)
  {
    check.Near(static_cast<double>(simplices.SumOfAbsolute), expected, 1e-12,
      "hypervolume without orientation", scale);
  }
  check.Near(static_cast<double>(tetrahedra.Sum), expected, 1e-12, "weighted tetrahedra", scale);
  check.Equal(found.Report->GetCount("Simplices"), simplices.Count, "reported 4-simplices");
}

/// Returns the area of { (y, t) : y + rate t <= bound } in a rectangle.
double AreaBelow(const double y[2], const double t[2], double rate, double bound)
{
  const double height = y[1] - y[0];
  const auto integral = [height](double v) {
    return v <= 0.0 ? 0.0 : v >= height ? height * (v - 0.5 * height) : 0.5 * v * v;
  };
  return (integral(bound - rate * t[0] - y[0]) - integral(bound - rate * t[1] - y[0])) / rate;
}

/// On linear arrays, the hypervolumes are known.
void CheckLinear(const NamedGrid& grid, Check& check)
{
  if (!HasBoxDomain(grid.Data))
  {
    return;
  }
  double box[6];
  grid.Data->GetBounds(box);
  const double x[2] = { box[0], box[1] };
  const double lengths[3] = { box[1] - box[0], box[3] - box[2], box[5] - box[4] };
  constexpr double rate = 0.3;
  const TimeSteps steps = RepeatGrid(grid.Data, Times);
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>& p, double t, vtkIdType) { return p[1] + rate * t; },
    "g");
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>& p, double, vtkIdType) { return p[2]; }, "h");
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>& p, double, vtkIdType) { return p[0]; }, "f");
  const Interval interval = { { x[0] + 0.21 * lengths[0], x[0] + 0.66 * lengths[0] } };
  const double g[2] = { box[2] + 0.37 * lengths[1] + rate, box[2] + 0.83 * lengths[1] + 2 * rate };
  const double area = AreaBelow(box + 2, std::array<double, 2>{ { 1.0, 4.0 } }.data(), rate, g[1]) -
    AreaBelow(box + 2, std::array<double, 2>{ { 1.0, 4.0 } }.data(), rate, g[0]);
  const double width = 0.45 * lengths[0];
  const double domain = 3.0 * lengths[0] * lengths[1] * lengths[2];
  check.SetContext(grid.Name + ", linear, intersection");
  CheckMeasure(Extract(steps, { interval }, { { "g", g[0], g[1] } }), width * area * lengths[2],
    domain, check, true);
  check.SetContext(grid.Name + ", linear, two criteria");
  const double h[2] = { box[4] + 0.1 * lengths[2], box[4] + 0.4 * lengths[2] };
  CheckMeasure(Extract(steps, { interval }, { { "g", g[0], g[1] }, { "h", h[0], h[1] } }),
    width * area * 0.3 * lengths[2], domain, check, true);
  check.SetContext(grid.Name + ", linear, difference");
  CheckMeasure(Extract(steps, { interval }, { { "g", g[0], g[1] } }, Filter::DIFFERENCE),
    width * (3.0 * lengths[1] - area) * lengths[2], domain, check, true);
  check.SetContext(grid.Name + ", linear, union");
  const double outside = (lengths[0] - width) * lengths[2];
  CheckMeasure(Extract(steps, { interval }, { { "g", g[0], g[1] } }, Filter::UNION),
    3.0 * width * lengths[1] * lengths[2] + outside * area, domain, check, true);
  check.SetContext(grid.Name + ", linear, union with two criteria");
  CheckMeasure(
    Extract(steps, { interval }, { { "g", g[0], g[1] }, { "h", h[0], h[1] } }, Filter::UNION),
    3.0 * width * lengths[1] * lengths[2] + outside * (area + 0.3 * (3.0 * lengths[1] - area)),
    domain, check, true);
}

vtkSmartPointer<vtkUnstructuredGrid> SliceAt(vtkUnstructuredGrid* simplices, double time)
{
  vtkNew<vtkSimplexTimeSlice> slice;
  slice->SetInputData(simplices);
  slice->SetTime(time);
  slice->WarnOnEmptyOutputOff();
  slice->Update();
  return slice->GetOutput();
}

/// On tetrahedra with arrays that are linear in space and time, the volume at any time is that of
/// the clipped tetrahedra.
void CheckSlices(const NamedGrid& grid, Check& check)
{
  if (!IsTetrahedral(grid.Data))
  {
    return;
  }
  check.SetContext(grid.Name + ", slices");
  const auto at = [&grid](const std::vector<double>& times)
  {
    const TimeSteps steps = RepeatGrid(grid.Data, times);
    AddDriftingField(steps, -0.2, 31, "g");
    AddDriftingField(steps, 0.15, 32, "f");
    return steps;
  };
  const std::vector<Interval> intervals = { { { 0.4, 0.9 } } };
  const std::vector<Criterion> criteria = { { "g", -0.1, 0.4 } };
  const TimeVaryingExtraction found = Extract(at(Times), intervals, criteria);
  const TimeVaryingExtraction united = Extract(at(Times), intervals, criteria, Filter::UNION);
  const double scale = static_cast<double>(MeshVolume(grid.Data));
  for (const double time : { 1.0, 1.2, 1.5, 2.0, 3.3, 4.0 })
  {
    const TimeSteps step = at({ time });
    const auto clip = [&step](const std::vector<Range>& ranges)
    { return static_cast<double>(ClippedVolume(GetDataSet(step.front()), ranges)); };
    const double f = clip({ { "f", 0.4, 0.9 } });
    const double g = clip({ { "g", -0.1, 0.4 } });
    const double both = clip({ { "f", 0.4, 0.9 }, { "g", -0.1, 0.4 } });
    const auto expect = [&](vtkUnstructuredGrid* simplices, double expected, const char* name)
    {
      check.Near(static_cast<double>(MeasureTetrahedra(SliceAt(simplices, time)).Sum), expected,
        1e-12, "volume of " + std::string(name) + " at time " + std::to_string(time), scale);
    };
    expect(found.Simplices, both, "the intersection");
    expect(united.Simplices, f + g - both, "the union");
    check.That(both > 0.001 * scale, "there is volume at time " + std::to_string(time));
  }
}

/// Checks that the faces of all 4-simplices cancel each other, the boundary cells of port 1, or lie
/// on the boundary of the box.
void CheckClosed(const TimeVaryingExtraction& found, vtkDataSet* grid, Check& check)
{
  std::map<std::array<vtkIdType, 4>, int> uses;
  for (const OrientedSimplex<4>& face : FacesOf(FourSimplicesOf(found.Simplices)))
  {
    uses[face.Key] += face.Sign;
  }
  for (vtkIdType c = 0; c < found.Boundaries->GetNumberOfCells(); ++c)
  {
    vtkIdType size;
    const vtkIdType* ids;
    found.Boundaries->GetCellPoints(c, size, ids);
    if (size == 4)
    {
      const OrientedSimplex<4> cell(std::array<vtkIdType, 4>{ { ids[0], ids[1], ids[2], ids[3] } });
      const int kind = static_cast<int>(
        found.Boundaries->GetCellData()->GetArray("BoundaryKind")->GetComponent(c, 0));
      // The volumes at the start and the end have the orientation of the grid.
      uses[cell.Key] -= kind == Filter::VOLUME_AT_START ? 0 : cell.Sign;
    }
  }
  double box[6];
  grid->GetBounds(box);
  vtkDataArray* times = found.Simplices->GetPointData()->GetArray("Time");
  long long open = 0;
  for (const auto& [key, use] : uses)
  {
    bool isOnBox = false;
    for (int side = 0; side < 6; ++side)
    {
      isOnBox |= std::all_of(key.begin(), key.end(),
        [&, bound = box[side], axis = side / 2](vtkIdType id)
        { return std::abs(found.Simplices->GetPoint(id)[axis] - bound) < 1e-12; });
    }
    const bool isAtEnd = std::all_of(key.begin(), key.end(),
      [times](vtkIdType id)
      {
        return times->GetComponent(id, 0) == Times.front() ||
          times->GetComponent(id, 0) == Times.back();
      });
    open += use != 0 && !isOnBox && !isAtEnd;
  }
  check.Equal(open, 0, "faces without a neighbor that are not on the boundary");
}

/// The parts that satisfy a criterion and that do not add up to the intervals.
void CheckParts(const NamedGrid& grid, const TimeSteps& steps, const Criterion& criterion,
  const std::vector<Interval>& intervals, Check& check)
{
  const TimeVaryingExtraction all = Extract(steps, intervals, {});
  const TimeVaryingExtraction inside = Extract(steps, intervals, { criterion });
  const TimeVaryingExtraction outside =
    Extract(steps, intervals, { criterion }, Filter::DIFFERENCE);
  const double scale = Measure(all);
  check.That(Measure(inside) > 0.01 * scale && Measure(outside) > 0.01 * scale, "both parts exist");
  CheckMeasure(inside, scale - Measure(outside), scale, check);
  CheckMeasure(outside, scale - Measure(inside), scale, check);
  for (std::size_t i = 0; i < intervals.size(); ++i)
  {
    const int item = static_cast<int>(i);
    check.Near(static_cast<double>(MeasureSimplices(inside.Simplices, item).Sum +
                 MeasureSimplices(outside.Simplices, item).Sum),
      static_cast<double>(MeasureSimplices(all.Simplices, item).Sum), 1e-12, "interval", scale);
  }
  if (HasBoxDomain(grid.Data))
  {
    CheckClosed(inside, grid.Data, check);
    CheckClosed(outside, grid.Data, check);
  }
  vtkDataArray* values = inside.Tetrahedra->GetPointData()->GetArray(criterion.Array);
  double range[2];
  values->GetRange(range);
  check.That(range[0] >= criterion.Lower - 1e-12 && range[1] <= criterion.Upper + 1e-12,
    "the values of the criterion");
  check.Equal(inside.Simplices->GetPointData()->GetArray(criterion.Array)->GetNumberOfTuples(),
    inside.Simplices->GetNumberOfPoints(), "a value for each point");
}

/// Slices at the time steps have the volumes of vtkIntervalVolume with the same criterion.
void CheckSteps(
  const TimeSteps& steps, const Criterion& criterion, const Interval& interval, Check& check)
{
  for (const int operation : { Filter::INTERSECTION, Filter::UNION, Filter::DIFFERENCE })
  {
    const TimeVaryingExtraction found = Extract(steps, { interval }, { criterion }, operation);
    for (const TimeStep& step : steps)
    {
      vtkNew<vtkIntervalVolume> expected;
      expected->SetInputData(GetDataSet(step));
      expected->SetInterval(0, interval[0], interval[1]);
      expected->AddCriterion(criterion.Array, criterion.Lower, criterion.Upper);
      expected->SetCriteriaOperation(operation);
      expected->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      expected->WarnOnEmptyOutputOff();
      expected->Update();
      check.Near(static_cast<double>(MeasureTetrahedra(SliceAt(found.Simplices, step.Time)).Sum),
        static_cast<double>(MeasureTetrahedra(expected->GetOutput()).Sum), 1e-12,
        "volume of operation " + std::to_string(operation) + " at step " +
          std::to_string(step.Time),
        1.0);
    }
  }
}

/// The union of intervals and a criterion that is satisfied everywhere is the domain. A union keeps
/// the intervals and their surfaces, and the region outside of them has the IntervalId -1. \a gaps
/// is that region without the criterion, or empty if values equal its bounds.
void CheckUnion(const NamedGrid& grid, const TimeSteps& steps, const Criterion& criterion,
  const std::vector<Interval>& intervals, const std::vector<Interval>& gaps, Check& check)
{
  const TimeVaryingExtraction all = Extract(steps, intervals, {});
  const TimeVaryingExtraction both = Extract(steps, intervals, { criterion }, Filter::UNION);
  const double scale = Measure(all);
  double expected = scale;
  if (gaps.empty())
  {
    expected = Measure(both);
  }
  else
  {
    expected += Measure(Extract(steps, gaps, { criterion }));
  }
  CheckMeasure(both, expected, scale, check);
  check.That(expected > scale, "there is a region outside of the intervals");
  for (std::size_t i = 0; i < intervals.size(); ++i)
  {
    const int item = static_cast<int>(i);
    check.Near(static_cast<double>(MeasureSimplices(both.Simplices, item).Sum),
      static_cast<double>(MeasureSimplices(all.Simplices, item).Sum), 1e-12, "interval", scale);
  }
  for (int kind = 0; kind < Filter::VOLUME_AT_START; ++kind)
  {
    check.Equal(both.Report->GetCount("Boundaries", kind), all.Report->GetCount("Boundaries", kind),
      "boundary cells of kind " + std::to_string(kind));
  }
  double ids[2];
  for (vtkUnstructuredGrid* output : { both.Tetrahedra, both.Boundaries, both.Simplices })
  {
    output->GetCellData()->GetArray("IntervalId")->GetRange(ids);
    check.Equal(static_cast<long long>(ids[0]), -1, "IntervalId of the region outside");
  }
  if (HasBoxDomain(grid.Data))
  {
    double box[6];
    grid.Data->GetBounds(box);
    const double domain = 3.0 * (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
    CheckMeasure(Extract(steps, intervals, { criterion, { "g", -9.0, 9.0 } }, Filter::UNION),
      domain, domain, check);
  }
}

/// Simplices with a NaN are dropped, together with their boundary.
void CheckNotFinite(Check& check)
{
  check.SetContext("NaN");
  const NamedGrid grid = MakeAllGridTypes({ 4, 3, 3 }, 4).front();
  const TimeSteps steps = RepeatGrid(grid.Data, Times);
  AddRandomTimeField(steps, 12, "g");
  AddRandomTimeField(steps, 11, "f");
  GetDataSet(steps[1])->GetPointData()->GetArray("g")->SetComponent(30, 0, std::nan(""));
  GetDataSet(steps[0])->GetPointData()->GetArray("g")->SetComponent(
    21, 0, std::numeric_limits<double>::infinity());
  const TimeVaryingExtraction found = Extract(steps, { { { 0.2, 0.8 } } }, { { "g", -5.0, 5.0 } });
  check.That(found.Simplices->GetNumberOfCells() > 100, "there are 4-simplices");
  std::map<std::array<vtkIdType, 4>, int> faces;
  for (const OrientedSimplex<4>& face : FacesOf(FourSimplicesOf(found.Simplices)))
  {
    ++faces[face.Key];
  }
  long long loose = 0;
  for (int kind = Filter::LOWER_SURFACE_IN_TIME; kind <= Filter::VOLUME_AT_END; ++kind)
  {
    for (const auto& cell : BoundaryCellsOf<4>(found.Boundaries, 0, kind))
    {
      loose += faces.count(OrientedSimplex<4>(cell).Key) == 0;
    }
  }
  check.Equal(loose, 0, "boundary cells without a 4-simplex");
}

void CheckRandom(const NamedGrid& grid, Check& check)
{
  const TimeSteps steps = RepeatGrid(grid.Data, Times);
  check.SetContext(grid.Name + ", random");
  AddRandomTimeField(steps, 12, "g");
  AddRandomTimeField(steps, 11, "f");
  CheckParts(grid, steps, { "g", 0.3, 0.8 }, { { { 0.2, 0.5 } }, { { 0.5, 0.9 } } }, check);
  CheckSteps(steps, { "g", 0.3, 0.8 }, { { 0.2, 0.5 } }, check);
  CheckUnion(grid, steps, { "g", 0.3, 0.8 }, { { { 0.2, 0.5 } }, { { 0.5, 0.9 } } },
    { { { -9.0, 0.2 } }, { { 0.9, 9.0 } } }, check);
  check.SetContext(grid.Name + ", ties");
  AddIntegerTimeField(steps, 3, 14, "g");
  AddIntegerTimeField(steps, 3, 13, "f");
  CheckParts(grid, steps, { "g", 0.0, 1.0 }, { { { 0.0, 1.0 } } }, check);
  CheckParts(grid, steps, { "g", 1.0, 2.0 }, { { { 0.5, 2.0 } } }, check);
  CheckParts(grid, steps, { "g", 0.5, 1.0 }, { { { 0.0, 1.5 } } }, check);
  CheckUnion(grid, steps, { "g", 0.5, 1.5 }, { { { 0.0, 1.0 } }, { { 2.0, 2.0 } } }, {}, check);
  CheckUnion(grid, steps, { "g", 1.0, 2.0 }, { { { 0.5, 1.0 } } }, {}, check);
  for (const Criterion& criterion : { Criterion{ "g", 0.0, 1.0 }, Criterion{ "g", 1.0, 7.0 },
         Criterion{ "g", 2.0, 2.0 }, Criterion{ "g", 0.5, 1.5 } })
  {
    CheckSteps(steps, criterion, { { 0.5, 2.0 } }, check);
    CheckSteps(steps, criterion, { { 0.0, 1.0 } }, check);
  }
}

/// The surfaces in time where a criterion equals its bounds have their own kinds, and are generated
/// only if surfaces in time are.
void CheckBoundaries(Check& check)
{
  check.SetContext("boundaries");
  const TimeSteps steps = RepeatGrid(MakeAllGridTypes({ 3, 3, 3 }, 4).front().Data, Times);
  AddRandomTimeField(steps, 12, "g");
  AddRandomTimeField(steps, 11, "f");
  const TimeVaryingExtraction found = Extract(steps, { { { 0.2, 0.8 } } }, { { "g", 0.3, 0.7 } });
  vtkDataArray* values = found.Boundaries->GetPointData()->GetArray("g");
  for (const int kind : { 8, 9 })
  {
    const auto cells = BoundaryCellsOf<4>(found.Boundaries, 0, kind);
    check.That(cells.size() > 50, "there are surfaces of kind " + std::to_string(kind));
    for (const auto& cell : cells)
    {
      if (!check.That(
            std::all_of(cell.begin(), cell.end(),
              [&](vtkIdType id) { return values->GetComponent(id, 0) == (kind == 8 ? 0.3 : 0.7); }),
            "the criterion equals its bound"))
      {
        break;
      }
    }
  }
  TimeVaryingSettings settings;
  settings.Intervals = { { { 0.2, 0.8 } } };
  settings.Boundaries = settings.Tetrahedra = settings.Simplices = false;
  settings.Criteria = { { "g", 0.3, 0.7 } };
  const TimeVaryingPipeline pipeline(steps, settings);
  pipeline.Filter->GenerateBoundaryOn(Filter::LOWER_SURFACE_IN_TIME);
  pipeline.Filter->Update();
  auto* alone = vtkUnstructuredGrid::SafeDownCast(pipeline.Filter->GetOutputDataObject(1));
  check.Equal(static_cast<long long>(BoundaryCellsOf<4>(alone, 0, 8).size()),
    static_cast<long long>(BoundaryCellsOf<4>(found.Boundaries, 0, 8).size()),
    "lower surfaces without other outputs");
  check.Equal(static_cast<long long>(BoundaryCellsOf<4>(alone, 0, 9).size()), 0, "upper surfaces");
}

/// A cell array is averaged at the points.
void CheckCellArray(Check& check)
{
  check.SetContext("cell array");
  const TimeSteps steps = RepeatGrid(MakeAllGridTypes({ 4, 3, 3 }, 4).front().Data, Times);
  for (const TimeStep& step : steps)
  {
    vtkNew<vtkDoubleArray> side;
    side->SetName("side");
    vtkDataSet* data = GetDataSet(step);
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      double box[6];
      data->GetCellBounds(cell, box);
      side->InsertNextValue(box[0] + box[1] > data->GetBounds()[0] + data->GetBounds()[1] ? 1 : 0);
    }
    data->GetCellData()->AddArray(side);
  }
  AddRandomTimeField(steps, 11, "f");
  const TimeVaryingExtraction found =
    Extract(steps, { { { 0.0, 1.0 } } }, { { "side", 0.5, 1.0 } });
  double box[6];
  GetDataSet(steps.front())->GetBounds(box);
  const double domain = 3.0 * (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
  check.Near(Measure(found), 0.5 * domain, 1e-12, "half of the domain", domain);
  check.Near(Measure(Extract(steps, { { { 2.0, 3.0 } } }, { { "side", 0.5, 1.0 } }, Filter::UNION)),
    0.5 * domain, 1e-12, "half of the domain in a union", domain);
}

/// A union keeps the field data of the input, also if the intervals have no output.
void CheckFieldData(Check& check)
{
  check.SetContext("field data");
  const TimeSteps steps = RepeatGrid(MakeAllGridTypes({ 2, 2, 2 }, 3).front().Data, Times);
  AddRandomTimeField(steps, 2, "g");
  AddRandomTimeField(steps, 1, "f");
  for (const TimeStep& step : steps)
  {
    vtkNew<vtkDoubleArray> field;
    field->SetName("field");
    field->InsertNextValue(7.0);
    GetDataSet(step)->GetFieldData()->AddArray(field);
  }
  for (const Interval& interval : { Interval{ { 0.2, 0.8 } }, Interval{ { 2.0, 3.0 } } })
  {
    const TimeVaryingExtraction found =
      Extract(steps, { interval }, { { "g", 0.3, 0.7 } }, Filter::UNION);
    for (vtkUnstructuredGrid* output : { found.Tetrahedra, found.Boundaries, found.Simplices })
    {
      check.That(output->GetNumberOfCells() > 0 && output->GetFieldData()->GetArray("field"),
        "a field array from " + std::to_string(interval[0]));
    }
  }
}

void CheckMessages(Check& check)
{
  const TimeSteps steps = RepeatGrid(MakeAllGridTypes({ 2, 2, 2 }, 3).front().Data, { 0, 1 });
  AddRandomTimeField(steps, 2, "g");
  AddRandomTimeField(steps, 1, "f");
  const auto expect = [&](const std::string& name, const Criterion& criterion, int operation,
                        const std::string& message, unsigned long event,
                        const Interval& interval = { { 0.2, 0.8 } })
  {
    check.SetContext("message, " + name);
    TimeVaryingSettings settings;
    settings.Intervals = { interval };
    settings.Criteria = { criterion };
    settings.CriteriaOperation = operation;
    const TimeVaryingPipeline pipeline(steps, settings);
    vtkNew<vtkTest::ErrorObserver> observer;
    pipeline.Filter->AddObserver(vtkCommand::ErrorEvent, observer);
    pipeline.Filter->AddObserver(vtkCommand::WarningEvent, observer);
    pipeline.Filter->Update();
    check.Contains(
      event == vtkCommand::ErrorEvent ? observer->GetErrorMessage() : observer->GetWarningMessage(),
      message);
    check.Equal(pipeline.Filter->GetOutput()->GetNumberOfCells(), 0, "the output is empty");
  };
  expect("empty union", { "g", 7.0, 8.0 }, Filter::UNION,
    "the interval [2, 3] or satisfies a criterion at any time", vtkCommand::WarningEvent,
    { { 2.0, 3.0 } });
  expect("reserved name", { "Time", 0.2, 0.4 }, Filter::INTERSECTION, "\"Time\" of a criterion",
    vtkCommand::ErrorEvent);
  expect("missing", { "q", 0.2, 0.4 }, Filter::INTERSECTION, "\"q\"", vtkCommand::ErrorEvent);
  expect("order", { "g", 0.4, 0.2 }, Filter::INTERSECTION, "The criterion on \"g\"",
    vtkCommand::ErrorEvent);
  expect("nothing left", { "g", 7.0, 8.0 }, Filter::INTERSECTION,
    "the criterion on \"g\" from 7 to 8 excludes all cells", vtkCommand::WarningEvent);
}

}

int TestTimeVaryingCriteria(int, char*[])
{
  Check check;
  for (const NamedGrid& grid : MakeAllGridTypes({ 3, 2, 2 }, 6))
  {
    CheckLinear(grid, check);
    CheckSlices(grid, check);
    CheckRandom(grid, check);
  }
  CheckBoundaries(check);
  CheckCellArray(check);
  CheckNotFinite(check);
  CheckFieldData(check);
  CheckMessages(check);
  return check.Result();
}
