// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Intervals/ReferenceMatching.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceBoundary.h"
#include "Support/Meshes/ReferenceChain.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceSplit.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>

namespace reference
{

namespace
{

using Filter = vtkTimeVaryingIntervalVolume;

/// Tests whether points all lie in the same boundary face of the domain, with a fast path for
/// box-shaped domains.
class BoundaryTest
{
public:
  explicit BoundaryTest(vtkDataSet* data)
    : Tolerance(1e-10 * data->GetLength())
  {
    data->GetBounds(this->Bounds);
    if (!HasBoxDomain(data))
    {
      this->Faces = std::make_unique<DomainBoundary>(data);
    }
  }

  template <size_t N>
  bool IsOnFace(vtkUnstructuredGrid* grid, const std::array<vtkIdType, N>& ids) const
  {
    std::vector<DomainBoundary::Point> points(N);
    for (size_t i = 0; i < N; ++i)
    {
      grid->GetPoint(ids[i], points[i].data());
    }
    if (this->Faces)
    {
      return this->Faces->Find(points) >= 0;
    }
    for (int side = 0; side < 6; ++side)
    {
      if (std::all_of(points.begin(), points.end(),
            [&](const DomainBoundary::Point& x)
            { return std::abs(x[side / 2] - this->Bounds[side]) <= this->Tolerance; }))
      {
        return true;
      }
    }
    return false;
  }

private:
  double Bounds[6];
  double Tolerance;
  std::unique_ptr<DomainBoundary> Faces;
};

template <size_t N>
std::vector<OrientedSimplex<N>> ToOriented(const std::vector<std::array<vtkIdType, N>>& simplices)
{
  return { simplices.begin(), simplices.end() };
}

/// Counts the simplices that occur with both orientations.
template <size_t N>
long long CountOpposite(const std::vector<std::array<vtkIdType, N>>& simplices)
{
  const auto uses = CountUses(ToOriented(simplices));
  return std::count_if(uses.begin(), uses.end(),
    [](const SimplexUse<N>& use) { return use.Plus > 0 && use.Minus > 0; });
}

/// Returns the cells, which are triangles or tetrahedra, as a sorted list of their point
/// coordinates.
template <size_t N>
std::vector<GeometricSimplex> SortedSimplices(
  vtkUnstructuredGrid* grid, const std::vector<std::array<vtkIdType, N>>& cells)
{
  vtkNew<vtkUnstructuredGrid> part;
  part->SetPoints(grid->GetPoints());
  part->Allocate(static_cast<vtkIdType>(cells.size()));
  for (const auto& cell : cells)
  {
    part->InsertNextCell(N == 3 ? VTK_TRIANGLE : VTK_TETRA, N, cell.data());
  }
  std::vector<GeometricSimplex> sorted = GeometricSet(part);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

template <size_t N>
using Net = std::map<std::array<vtkIdType, N>, int>;

/// Adds the sign of each simplex, multiplied by \a sign, to its count in \a net.
template <size_t N>
void AddTo(Net<N>& net, const std::vector<OrientedSimplex<N>>& simplices, int sign = 1)
{
  for (const OrientedSimplex<N>& simplex : simplices)
  {
    net[simplex.Key] += sign * simplex.Sign;
  }
}

template <size_t N>
bool AreAll(vtkDataArray* values, const std::array<vtkIdType, N>& ids, double value)
{
  return std::all_of(ids.begin(), ids.end(),
    [&](vtkIdType id)
    {
      return std::abs(values->GetComponent(id, 0) - value) <=
        1e-13 * std::max(1.0, std::abs(value));
    });
}

bool IsConstant(vtkDataSet* data, vtkIdType cell, double value)
{
  vtkDataArray* values = data->GetPointData()->GetScalars();
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  return std::all_of(
    ids->begin(), ids->end(), [&](vtkIdType id) { return values->GetComponent(id, 0) == value; });
}

bool HasPolyhedra(vtkDataSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (data->GetCellType(cell) == VTK_POLYHEDRON)
    {
      return true;
    }
  }
  return false;
}

/// Returns the volume of the cells whose points all have the given value.
double ConstantVolume(vtkDataSet* data, double value)
{
  long double volume = 0;
  ForEachTetrahedron(data,
    [&](vtkIdType cell, const SplitTetrahedron& tetrahedron)
    {
      if (!IsConstant(data, cell, value))
      {
        return;
      }
      std::array<std::array<long double, 3>, 4> x;
      for (int p = 0; p < 4; ++p)
      {
        for (int a = 0; a < 3; ++a)
        {
          x[p][a] = MeanOf<long double>(
            tetrahedron[p], [&](vtkIdType id) { return data->GetPoint(id)[a]; });
        }
      }
      volume += std::abs(Determinant(x[0], x[1], x[2], x[3])) / 6;
    });
  return static_cast<double>(volume);
}

class MatchingChecker
{
public:
  MatchingChecker(vtkDataSet* data, const std::vector<Interval>& intervals, Check& check,
    const std::vector<MatchingCriterion>& criteria, int operation)
    : Data(data)
    , Intervals(intervals)
    , Test(check)
    , Criteria(criteria)
    , Domain(data)
  {
    this->HasOrigins = criteria.empty();
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(data);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->GenerateBoundariesOn();
    filter->SetGenerateOriginArrays(this->HasOrigins);
    for (size_t i = 0; i < intervals.size(); ++i)
    {
      filter->SetInterval(static_cast<int>(i), intervals[i][0], intervals[i][1]);
    }
    for (const MatchingCriterion& one : criteria)
    {
      filter->AddCriterion(one.Array.c_str(), one.Lower, one.Upper);
    }
    filter->SetCriteriaOperation(operation);
    filter->WarnOnEmptyOutputOff();
    filter->Update();
    this->Volume = filter->GetOutput();
    this->Surface = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
    this->Values = this->Volume->GetPointData()->GetScalars();
  }

  void Run()
  {
    if (this->Volume->GetNumberOfCells() == 0)
    {
      this->Test.Equal(this->Surface->GetNumberOfCells(), 0, "triangles of an empty volume");
      return;
    }
    std::vector<bool> isUsed(this->Volume->GetNumberOfPoints(), false);
    for (int i = -1; i < static_cast<int>(this->Intervals.size()); ++i)
    {
      this->CheckInterval(i);
      for (const Tetrahedron& t : TetrahedraOf(this->Volume, i))
      {
        std::for_each(t.begin(), t.end(), [&](vtkIdType id) { isUsed[id] = true; });
      }
    }
    this->Test.Equal(
      std::count(isUsed.begin(), isUsed.end(), false), 0, "points that no tetrahedron uses");
  }

  double GetVolume() const { return static_cast<double>(MeasureTetrahedra(this->Volume).Sum); }

private:
  void CheckInterval(int i)
  {
    const std::string name = "interval " + std::to_string(i) + ": ";
    const std::vector<Tetrahedron> tetrahedra = TetrahedraOf(this->Volume, i);
    this->Test.Equal(
      CountOpposite(tetrahedra), 0, name + "tetrahedra that occur with both orientations");
    Net<3> faces;
    AddTo(faces, FacesOf(tetrahedra));
    Net<3> remaining = faces;
    long long invalid = 0;
    std::vector<Triangle> all;
    for (int side = 0; side < 2 + 2 * static_cast<int>(this->Criteria.size()); ++side)
    {
      for (const Triangle& triangle : BoundaryOf(this->Surface, i, side))
      {
        const OrientedSimplex<3> oriented(triangle);
        const auto face = faces.find(oriented.Key);
        invalid += face == faces.end() || face->second * oriented.Sign <= 0 ||
          !this->IsAtBound(triangle, i, side);
        all.push_back(triangle);
      }
    }
    this->Test.Equal(
      invalid, 0, name + "triangles that are not faces of tetrahedra with the value of the bound");
    const auto uses = CountUses(ToOriented(all));
    this->Test.Equal(static_cast<long long>(all.size() - uses.size()), 0,
      name + "triangles that occur more than once");
    AddTo(remaining, ToOriented(all), -1);
    const long long cracks = std::count_if(remaining.begin(), remaining.end(),
      [&](const auto& face)
      {
        return face.second != 0 && !this->Domain.IsOnFace(this->Volume, face.first) &&
          !(i < 0 && this->IsCut(face.first));
      });
    this->Test.Equal(cracks, 0, name + "interior faces that do not cancel");
    if (this->HasOrigins)
    {
      this->CheckCells(i, name);
    }
    if (i >= 0 && this->Intervals[i][0] == this->Intervals[i][1] && this->Criteria.empty())
    {
      this->CheckPointInterval(i, this->Intervals[i][0], name);
    }
  }

  /// Returns whether all values of a face equal the bound of an interval or criterion with the
  /// given BoundarySide.
  bool IsAtBound(const Triangle& face, int interval, int side) const
  {
    if (side < 2)
    {
      return interval >= 0 && AreAll(this->Values, face, this->Intervals[interval][side]);
    }
    const MatchingCriterion& one = this->Criteria[side / 2 - 1];
    return AreAll(this->Volume->GetPointData()->GetArray(one.Array.c_str()), face,
      side % 2 == 0 ? one.Lower : one.Upper);
  }

  /// Returns whether all values of a face equal any bound.
  bool IsCut(const Triangle& face) const
  {
    bool isCut = false;
    for (int side = 0; side < 2 + 2 * static_cast<int>(this->Criteria.size()); ++side)
    {
      for (size_t i = 0; i < (side < 2 ? this->Intervals.size() : 1); ++i)
      {
        isCut |= this->IsAtBound(face, static_cast<int>(i), side);
      }
    }
    return isCut;
  }

  /// Checks that each triangle has the same origin cell as a tetrahedron of which it is a face.
  void CheckCells(int i, const std::string& name)
  {
    vtkDataArray* ids = this->Volume->GetCellData()->GetArray("IntervalId");
    vtkDataArray* cells = this->Volume->GetCellData()->GetArray("OriginCell");
    std::map<Triangle, std::vector<vtkIdType>> cellsOf;
    const auto forEach = [i](vtkUnstructuredGrid* grid, vtkDataArray* items, auto&& visit)
    {
      vtkNew<vtkIdList> points;
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        if (items->GetComponent(cell, 0) == i)
        {
          grid->GetCellPoints(cell, points);
          visit(cell, points->GetPointer(0));
        }
      }
    };
    forEach(this->Volume, ids,
      [&](vtkIdType cell, const vtkIdType* p)
      {
        for (const auto& face : FacesOf({ Tetrahedron{ { p[0], p[1], p[2], p[3] } } }))
        {
          cellsOf[face.Key].push_back(static_cast<vtkIdType>(cells->GetComponent(cell, 0)));
        }
      });
    long long errors = 0;
    vtkDataArray* origins = this->Surface->GetCellData()->GetArray("OriginCell");
    forEach(this->Surface, this->Surface->GetCellData()->GetArray("IntervalId"),
      [&](vtkIdType cell, const vtkIdType* p)
      {
        const auto& known = cellsOf[OrientedSimplex<3>(Triangle{ { p[0], p[1], p[2] } }).Key];
        errors += std::count(known.begin(), known.end(), origins->GetComponent(cell, 0)) == 0;
      });
    this->Test.Equal(
      errors, 0, name + "triangles whose origin cell differs from their tetrahedron's");
  }

  void CheckPointInterval(int i, double value, const std::string& name)
  {
    const std::vector<Tetrahedron> tetrahedra = TetrahedraOf(this->Volume, i);
    vtkDataArray* ids = this->Volume->GetCellData()->GetArray("IntervalId");
    vtkDataArray* cells = this->Volume->GetCellData()->GetArray("OriginCell");
    if (HasPolyhedra(this->Data))
    {
      // The filter splits a polyhedron into convex pieces and tests each piece separately, so these
      // checks do not apply.
      return;
    }
    long long errors = 0;
    for (vtkIdType cell = 0; cell < this->Volume->GetNumberOfCells(); ++cell)
    {
      errors += ids->GetComponent(cell, 0) == i &&
        !IsConstant(this->Data, static_cast<vtkIdType>(cells->GetComponent(cell, 0)), value);
    }
    this->Test.Equal(
      errors, 0, name + "tetrahedra of cells whose values do not all equal the bound");
    this->Test.Near(static_cast<double>(MeasureInterval(this->Volume, i).Sum),
      ConstantVolume(this->Data, value), 1e-12,
      name + "volume of the cells whose values all equal the bound", 1.0);
  }

  vtkDataSet* Data;
  const std::vector<Interval>& Intervals;
  Check& Test;
  const std::vector<MatchingCriterion>& Criteria;
  BoundaryTest Domain;
  bool HasOrigins;
  vtkSmartPointer<vtkUnstructuredGrid> Volume;
  vtkSmartPointer<vtkUnstructuredGrid> Surface;
  vtkDataArray* Values = nullptr;
};

class TimeChecker
{
public:
  TimeChecker(const TimeSteps& steps, const std::vector<Interval>& intervals, Check& check)
    : Steps(steps)
    , Intervals(intervals)
    , Test(check)
    , Walls(GetDataSet(steps.front()))
    , Found(ExtractTimeVarying(steps, { intervals }))
  {
  }

  void Run()
  {
    if (this->Found.Simplices->GetNumberOfCells() == 0)
    {
      return;
    }
    this->Times = this->Found.Simplices->GetPointData()->GetArray("Time");
    this->CheckAtStep();
    for (int i = 0; i < static_cast<int>(this->Intervals.size()); ++i)
    {
      this->CheckInterval(i);
    }
    for (size_t step = 0; step < this->Steps.size(); ++step)
    {
      this->CheckStep(step);
    }
  }

private:
  void CheckInterval(int i)
  {
    const std::string name = "interval in time " + std::to_string(i) + ": ";
    const std::vector<FourSimplex> simplices = FourSimplicesOf(this->Found.Simplices, i);
    this->Test.Equal(
      CountOpposite(simplices), 0, name + "4-simplices that occur with both orientations");
    Net<4> faces;
    AddTo(faces, FacesOf(simplices));
    Net<4> remaining = faces;
    std::vector<Tetrahedron> inTime;
    for (int kind : { Filter::LOWER_SURFACE_IN_TIME, Filter::UPPER_SURFACE_IN_TIME })
    {
      const auto part = BoundaryCellsOf<4>(this->Found.Boundaries, i, kind);
      inTime.insert(inTime.end(), part.begin(), part.end());
    }
    const auto uses = CountUses(ToOriented(inTime));
    this->Test.Equal(static_cast<long long>(inTime.size() - uses.size()), 0,
      name + "surface cells in time that occur more than once");
    const long long invalid = std::count_if(inTime.begin(), inTime.end(),
      [&](const Tetrahedron& cell)
      {
        const OrientedSimplex<4> oriented(cell);
        const auto face = faces.find(oriented.Key);
        return face == faces.end() || face->second * oriented.Sign <= 0;
      });
    this->Test.Equal(invalid, 0, name + "surface cells in time that are not faces of 4-simplices");
    AddTo(remaining, ToOriented(inTime), -1);
    const double ends[2] = { this->Steps.front().Time, this->Steps.back().Time };
    const long long cracks = std::count_if(remaining.begin(), remaining.end(),
      [&](const auto& face)
      {
        return face.second != 0 && !this->IsAt(face.first, ends[0]) &&
          !this->IsAt(face.first, ends[1]) &&
          !this->Walls.IsOnFace(this->Found.Simplices, face.first);
      });
    this->Test.Equal(cracks, 0, name + "interior faces that do not cancel");
  }

  template <size_t N>
  bool IsAt(const std::array<vtkIdType, N>& ids, double time) const
  {
    return std::all_of(ids.begin(), ids.end(),
      [&](vtkIdType id) { return this->Times->GetComponent(id, 0) == time; });
  }

  bool IsAtOneTime(const FourSimplex& simplex) const
  {
    return this->IsAt(simplex, this->Times->GetComponent(simplex[0], 0));
  }

  /// Checks that AtStep is not FACES_AT_STEP for cells whose points are all at one time, and that
  /// it is TETRAHEDRON_AT_STEP for cells that repeat their last point, and only for these.
  void CheckAtStep()
  {
    vtkUnstructuredGrid* grid = this->Found.Simplices;
    vtkDataArray* atStep = grid->GetCellData()->GetArray("AtStep");
    long long errors = 0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      grid->GetCellPoints(cell, ids);
      const vtkIdType* p = ids->GetPointer(0);
      const bool isWithinStep = this->IsAtOneTime({ { p[0], p[1], p[2], p[3], p[4] } });
      const double part = atStep->GetComponent(cell, 0);
      errors += (isWithinStep && part == Filter::FACES_AT_STEP) ||
        (p[3] == p[4]) != (part == Filter::TETRAHEDRON_AT_STEP);
    }
    this->Test.Equal(errors, 0, "cells within one step with a wrong value of AtStep");
  }

  void CheckStep(size_t step)
  {
    const double time = this->Steps[step].Time;
    const std::string name = "at time " + std::to_string(time) + ": ";
    const Extraction expected = ExtractIntervals(GetDataSet(this->Steps[step]), this->Intervals);
    std::vector<GeometricSimplex> volume = GeometricSet(expected.Volume, { "IntervalId" });
    std::vector<GeometricSimplex> slice =
      GeometricSet(SliceAt(this->Found.Simplices, time), { "IntervalId" });
    std::sort(volume.begin(), volume.end());
    std::sort(slice.begin(), slice.end());
    const auto countMissing = [](const auto& all, const auto& some)
    {
      std::vector<GeometricSimplex> missing;
      std::set_difference(
        all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(missing));
      return static_cast<long long>(missing.size());
    };
    this->Test.Equal(countMissing(slice, volume), 0,
      name + "tetrahedra of the slice that are not in the interval volume");
    this->Test.Equal(countMissing(volume, slice), 0,
      name + "tetrahedra of the interval volume that are not in the slice");
    const bool isStart = step == 0;
    if (isStart || step + 1 == this->Steps.size())
    {
      const int end = isStart ? 0 : 1;
      for (int i = 0; i < static_cast<int>(this->Intervals.size()); ++i)
      {
        this->CheckEnd(expected, i, end, name + "interval " + std::to_string(i) + ", ");
      }
    }
  }

  /// Checks that the cells of the given kind on port 1 equal \a cells of \a expected, the output of
  /// vtkIntervalVolume.
  template <size_t N>
  void CheckSame(vtkUnstructuredGrid* expected, const std::vector<std::array<vtkIdType, N>>& cells,
    int i, int kind, const std::string& name)
  {
    this->Test.That(SortedSimplices(expected, cells) ==
        SortedSimplices(
          this->Found.Boundaries, BoundaryCellsOf<N>(this->Found.Boundaries, i, kind)),
      name + "kind " + std::to_string(kind) + " equals the output of vtkIntervalVolume");
  }

  void CheckEnd(const Extraction& expected, int i, int end, const std::string& name)
  {
    this->CheckSame(
      expected.Volume, TetrahedraOf(expected.Volume, i), i, Filter::VOLUME_AT_START + end, name);
    for (int side = 0; side < 2; ++side)
    {
      this->CheckSame(expected.Surface, BoundaryOf(expected.Surface, i, side), i,
        Filter::LOWER_SURFACE_AT_START + 2 * end + side, name);
    }
  }

  const TimeSteps& Steps;
  const std::vector<Interval>& Intervals;
  Check& Test;
  BoundaryTest Walls;
  TimeVaryingExtraction Found;
  vtkDataArray* Times = nullptr;
};

}

const std::vector<std::string>& GetTiedVolumeFileNames()
{
  static const std::vector<std::string> files = { "bonsai.vti", "brainsmall.vti", "ironProt.vtk",
    "neghip.vti", "tooth.vti" };
  return files;
}

vtkSmartPointer<vtkImageData> CropVolume(vtkDataSet& volume, int points, int shift)
{
  vtkImageData* image = vtkImageData::SafeDownCast(&volume);
  vtkDataArray* from = image->GetPointData()->GetArray(0);
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = (extent[2 * axis] + extent[2 * axis + 1] + 1 - points) / 2;
  }
  extent[0] += shift;
  auto crop = vtkSmartPointer<vtkImageData>::New();
  crop->SetDimensions(points, points, points);
  vtkSmartPointer<vtkDataArray> to;
  to.TakeReference(from->NewInstance());
  to->SetName("f");
  to->SetNumberOfTuples(crop->GetNumberOfPoints());
  for (vtkIdType p = 0; p < crop->GetNumberOfPoints(); ++p)
  {
    int at[3] = { extent[0] + static_cast<int>(p % points),
      extent[2] + static_cast<int>(p / points % points),
      extent[4] + static_cast<int>(p / points / points) };
    to->SetTuple(p, image->ComputePointId(at), from);
  }
  crop->GetPointData()->SetScalars(to);
  return crop;
}

std::vector<double> GetQuantiles(vtkDataSet& data)
{
  vtkDataArray* array = data.GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType p = 0; p < array->GetNumberOfTuples(); ++p)
  {
    values.push_back(array->GetComponent(p, 0));
  }
  std::sort(values.begin(), values.end());
  std::vector<double> bounds;
  for (const double fraction : { 0.0, 0.3, 0.5, 0.8, 1.0 })
  {
    const double value =
      values[static_cast<size_t>(fraction * static_cast<double>(values.size() - 1))];
    if (bounds.empty() || value > bounds.back())
    {
      bounds.push_back(value);
    }
  }
  if (bounds.size() < 2)
  {
    bounds.push_back(bounds.front() + 1);
  }
  return bounds;
}

void CheckMatching(vtkDataSet* data, const std::vector<Interval>& intervals, Check& check,
  const std::vector<MatchingCriterion>& criteria, int operation)
{
  MatchingChecker(data, intervals, check, criteria, operation).Run();
}

void CheckMatchingTiling(vtkDataSet* data, const std::vector<double>& bounds, Check& check)
{
  std::vector<Interval> intervals;
  for (size_t i = 0; i + 1 < bounds.size(); ++i)
  {
    intervals.push_back({ bounds[i], bounds[i + 1] });
  }
  MatchingChecker checker(data, intervals, check, {}, vtkIntervalVolume::INTERSECTION);
  checker.Run();
  const double domain = static_cast<double>(MeshVolume(data));
  check.Near(checker.GetVolume(), domain, 1e-12, "sum of the signed volumes");
}

void CheckMatchingContour(vtkDataSet* data, double value, Check& check)
{
  const std::string name = "contour of " + std::to_string(value) + ": ";
  const BoundaryTest domain(data);
  const auto inside = [&domain](vtkUnstructuredGrid* grid, std::vector<Triangle> triangles)
  {
    const auto end = std::remove_if(triangles.begin(), triangles.end(),
      [&](const Triangle& triangle) { return domain.IsOnFace(grid, triangle); });
    triangles.erase(end, triangles.end());
    return SortedSimplices(grid, triangles);
  };
  const auto contour = ExtractContours(data, { value }).Surface;
  const std::vector<Triangle> triangles = TrianglesOf(contour);
  const auto uses = CountUses(ToOrientedSimplices(triangles));
  check.Equal(static_cast<long long>(triangles.size() - uses.size()), 0,
    name + "triangles that occur more than once");
  const auto edges = CountUses(EdgesOf(triangles));
  check.Equal(
    std::count_if(edges.begin(), edges.end(),
      [&](const EdgeUse& edge) { return edge.Net() != 0 && !domain.IsOnFace(contour, edge.Key); }),
    0, name + "interior edges that do not cancel");
  const double maximum = data->GetPointData()->GetScalars()->GetRange()[1];
  const auto above = ExtractIntervals(data, { { value, maximum + 1 } }).Surface;
  check.That(inside(contour, triangles) == inside(above, BoundaryOf(above, 0, 0)),
    name + "the contour equals the lower boundary of the interval above");
}

void CheckMatchingInTime(
  const TimeSteps& steps, const std::vector<Interval>& intervals, Check& check)
{
  TimeChecker(steps, intervals, check).Run();
}

}
