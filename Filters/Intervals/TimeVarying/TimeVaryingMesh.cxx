// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingMesh.h"

#include "Arrays/ExtractionArrays.h"
#include "Arrays/PointArrays.h"
#include "Common/ArrayMatch.h"
#include "Common/ParallelFor.h"
#include "Output/RetainedIdRanges.h"
#include "Output/TiedFaces.h"
#include "TimeVarying/TimeStep.h"
#include "Unstructured/CrossingLists.h"

#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace interlume
{

namespace
{
using Kinds = vtkTimeVaryingSettings::BoundaryKinds;
using PointList = ExtractionBuffer<ExtractionPoint>;

vtkIdType GetOwner(const ExtractionPoint& point)
{
  return std::min(point.Near, point.Far);
}

// Replaces the ids of grid points at the second step with the ids of the same points at the first
// step. Valid only if the grid points do not move.
PointList Fold(const PointList& points, vtkIdType split)
{
  const auto fold = [split](vtkIdType id) { return id < split ? id : id - split; };
  PointList folded;
  folded.Allocate(points.GetSize());
  ParallelFor(0, static_cast<vtkIdType>(points.GetSize()),
    [&](vtkIdType p) {
      folded[p] = { fold(points[p].Near), fold(points[p].Far), points[p].Weight };
    });
  return folded;
}

// Interpolates the positions of moving points.
void InterpolatePoints(
  vtkDataSet* first, vtkDataSet* second, const PointList& points, vtkPoints* positions)
{
  const vtkIdType split = first->GetNumberOfPoints();
  const auto getPoint = [&](vtkIdType id, double x[3])
  { id < split ? first->GetPoint(id, x) : second->GetPoint(id - split, x); };
  ParallelFor(0, static_cast<vtkIdType>(points.GetSize()),
    [&](vtkIdType p)
    {
      double near[3];
      double far[3];
      getPoint(points[p].Near, near);
      getPoint(points[p].Far, far);
      for (int axis = 0; axis < 3; ++axis)
      {
        near[axis] += points[p].Weight * (far[axis] - near[axis]);
      }
      positions->SetPoint(p, near);
    });
}

vtkSmartPointer<vtkPoints> MakePoints(const TimeStep& first, const TimeStep& second,
  const PointList& points, int precision, bool isStatic)
{
  if (isStatic)
  {
    return PointArrays::MakePoints(
      first.GetGrid(), Fold(points, first.GetNumberOfPoints()), precision);
  }
  const auto made = vtkSmartPointer<vtkPoints>::Take(
    vtkPoints::New(ExtractionArrays::ChoosePointType(first.GetGrid(), precision)));
  made->SetNumberOfPoints(static_cast<vtkIdType>(points.GetSize()));
  InterpolatePoints(first.GetGrid(), second.GetGrid(), points, made);
  return made;
}

bool IsSurfaceAtStep(int kind)
{
  return kind < Kinds::LOWER_SURFACE_IN_TIME;
}

// Returns a unique number for each combination of an interval and a step (the first or the last).
vtkIdType GetGroup(int item, int kind)
{
  const bool isAtEnd = kind == Kinds::VOLUME_AT_END || kind == Kinds::LOWER_SURFACE_AT_END ||
    kind == Kinds::UPPER_SURFACE_AT_END;
  return 2 * static_cast<vtkIdType>(item) + isAtEnd;
}

void AppendCells(const std::vector<TimeVaryingMesh::BoundaryCell>& cells, int slab,
  std::vector<TimeVaryingMesh::BoundaryCell>& all)
{
  for (TimeVaryingMesh::BoundaryCell cell : cells)
  {
    cell.Slab = slab;
    all.push_back(cell);
  }
}

using Entry = OppositePairs::Entry<vtkIdType, 6>;

// Returns the OppositePairs entry of 4-simplex \a s. Only 4-simplices of the same interval match.
Entry MakeEntry(const TimeVaryingMesh::Slab& slab, std::size_t s, std::size_t index)
{
  Entry entry{ { { slab.GetItem(static_cast<vtkIdType>(s)) } }, false, index };
  std::copy(slab.Simplices[s].begin(), slab.Simplices[s].end(), entry.Key.begin() + 1);
  entry.IsOdd = OppositePairs::Sort(entry.Key.data() + 1, 5);
  return entry;
}

// Removes the marked 4-simplices and returns their number.
vtkIdType RemoveMarked(TimeVaryingMesh::Slab& slab, const std::vector<bool>& isRemoved)
{
  const vtkIdType number = static_cast<vtkIdType>(slab.Simplices.GetSize());
  std::vector<vtkIdType> removed;
  for (vtkIdType s = 0; s < number; ++s)
  {
    if (isRemoved[s])
    {
      removed.push_back(s);
    }
  }
  const RetainedIdRanges retained(removed, number);
  const auto keep = [&retained](auto& values)
  {
    if (values.GetSize() > 0)
    {
      retained.Compact(values.GetData(), 1);
      values.Truncate(static_cast<std::size_t>(retained.GetNumber()));
    }
  };
  keep(slab.Simplices);
  keep(slab.Items);
  keep(slab.Flats);
  keep(slab.Ties);
  keep(slab.Duplicates);
  return static_cast<vtkIdType>(removed.size());
}

vtkSmartPointer<vtkDoubleArray> MakeTimes(
  const TimeStep& first, const TimeStep& second, const PointList& points)
{
  const vtkIdType split = first.GetNumberOfPoints();
  const double begin = first.GetTime();
  const double end = second.GetTime();
  auto times = vtkSmartPointer<vtkDoubleArray>::New();
  times->SetName("Time");
  times->SetNumberOfValues(static_cast<vtkIdType>(points.GetSize()));
  ParallelFor(0, static_cast<vtkIdType>(points.GetSize()),
    [&](vtkIdType p)
    {
      const double near = points[p].Near < split ? begin : end;
      const double far = points[p].Far < split ? begin : end;
      times->SetValue(p, near + points[p].Weight * (far - near));
    });
  return times;
}
}

void TimeVaryingMesh::BeginSlab(int number, bool isFirst, bool isLast, bool isJoined, bool hasTies)
{
  this->IsLast = isLast;
  for (int kind = 0; kind < Kinds::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    this->RequiredKinds[kind] = this->Options.IsRequested(kind);
  }
  this->HasTies = this->HasTies || hasTies;
  // The volume at a step is needed to decide which surfaces at the step bound a volume.
  this->RequiredKinds[Kinds::VOLUME_AT_START] |= hasTies &&
    (this->RequiredKinds[Kinds::LOWER_SURFACE_AT_START] ||
      this->RequiredKinds[Kinds::UPPER_SURFACE_AT_START]);
  this->RequiredKinds[Kinds::VOLUME_AT_END] |= hasTies &&
    (this->RequiredKinds[Kinds::LOWER_SURFACE_AT_END] ||
      this->RequiredKinds[Kinds::UPPER_SURFACE_AT_END]);
  for (const int kind :
    { Kinds::LOWER_SURFACE_AT_START, Kinds::UPPER_SURFACE_AT_START, Kinds::VOLUME_AT_START })
  {
    this->RequiredKinds[kind] = this->RequiredKinds[kind] && isFirst;
  }
  for (const int kind :
    { Kinds::LOWER_SURFACE_AT_END, Kinds::UPPER_SURFACE_AT_END, Kinds::VOLUME_AT_END })
  {
    this->RequiredKinds[kind] = this->RequiredKinds[kind] && isLast;
  }
  this->Slabs.emplace_back();
  this->Slabs.back().Number = number;
  if (!isJoined)
  {
    this->EndPoints.clear();
  }
}

bool TimeVaryingMesh::HasRequiredKinds() const
{
  return std::find(this->RequiredKinds.begin(), this->RequiredKinds.end(), true) !=
    this->RequiredKinds.end();
}

ExtractionBuffer<vtkIdType> TimeVaryingMesh::AddPoints(const TimeStep& first,
  const TimeStep& second, const PointList& points, const CrossingLists& lists, bool isStatic)
{
  const vtkIdType split = first.GetNumberOfPoints();
  const vtkIdType number = static_cast<vtkIdType>(points.GetSize());
  const vtkIdType before = this->Points ? this->Points->GetNumberOfPoints() : 0;
  ExtractionBuffer<vtkIdType> ids;
  ids.Allocate(number);
  PointList added;
  added.Allocate(number);
  // Both lists are sorted by owner and key, so merging them finds the points shared with the
  // previous slab. All points after the last shared one are new.
  vtkIdType unshared = 0;
  vtkIdType numberShared = 0;
  auto shared = this->EndPoints.begin();
  for (; unshared < number && shared != this->EndPoints.end(); ++unshared)
  {
    const SharedPoint point{ GetOwner(points[unshared]), lists.GetKey(unshared), 0 };
    shared = std::find_if(shared, this->EndPoints.end(),
      [&point](const SharedPoint& other) { return !other.IsBefore(point); });
    if (shared != this->EndPoints.end() && !point.IsBefore(*shared))
    {
      ids[unshared] = shared->Id;
      ++numberShared;
    }
    else
    {
      const vtkIdType index = unshared - numberShared;
      ids[unshared] = before + index;
      added[index] = points[unshared];
    }
  }
  ParallelFor(unshared, number,
    [&](vtkIdType p)
    {
      ids[p] = before + p - numberShared;
      added[p - numberShared] = points[p];
    });
  added.Truncate(number - numberShared);
  this->StoreEndPoints(points, lists, split, ids);
  this->AppendPoints(first, second, added, isStatic);
  return ids;
}

void TimeVaryingMesh::StoreEndPoints(const PointList& points, const CrossingLists& lists,
  vtkIdType split, const ExtractionBuffer<vtkIdType>& ids)
{
  this->EndPoints.clear();
  if (this->IsLast)
  {
    return;
  }
  const ExtractionPoint* const end = points.GetData() + points.GetSize();
  const ExtractionPoint* const begin = std::partition_point(points.GetData(), end,
    [split](const ExtractionPoint& point) { return GetOwner(point) < split; });
  this->EndPoints.reserve(end - begin);
  for (const ExtractionPoint* point = begin; point != end; ++point)
  {
    // Use the key that the point will have in the next slab.
    const vtkIdType p = point - points.GetData();
    const CrossingKey key = lists.GetKey(p);
    const bool isGridPoint = key == CrossingKey();
    this->EndPoints.push_back({ GetOwner(*point) - split,
      isGridPoint ? key : CrossingKey(key.GetFar() - split, key.GetValue()), ids[p] });
  }
}

void TimeVaryingMesh::AppendPoints(
  const TimeStep& first, const TimeStep& second, const PointList& points, bool isStatic)
{
  const vtkSmartPointer<vtkPoints> positions =
    MakePoints(first, second, points, this->Options.Precision, isStatic);
  const vtkSmartPointer<vtkDoubleArray> times = MakeTimes(first, second, points);
  vtkNew<vtkPointData> arrays;
  vtkPointData* from = first.GetGrid()->GetPointData();
  vtkPointData* to = second.GetGrid()->GetPointData();
  PointArrays interpolated(from, to, first.GetNumberOfPoints());
  interpolated.Fill(points);
  interpolated.AddTo(arrays);
  for (const char* own : { "Time", "DeltaT" })
  {
    arrays->RemoveArray(own);
  }
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    const std::string key = ArrayMatch::GetKey(from, array);
    if (ExtractionArrays::IsCarried(from, array) && !arrays->HasArray(key.c_str()))
    {
      this->SkippedArrays.push_back(key);
    }
  }
  if (!this->Points)
  {
    this->Points = positions;
    this->Times = times;
    this->Arrays->ShallowCopy(arrays);
    this->UpdateCoordinatePointers();
    return;
  }
  this->Append(positions, times, arrays);
}

void TimeVaryingMesh::AddEdgePoints(const std::vector<ExtractionPoint>& points)
{
  if (points.empty())
  {
    return;
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(this->Points);
  grid->GetPointData()->ShallowCopy(this->Arrays);
  grid->GetPointData()->AddArray(this->Times);
  PointList list;
  list.Allocate(points.size());
  std::copy(points.begin(), points.end(), list.GetData());
  PointArrays made(grid, this->Options.Precision);
  made.Fill(list);
  vtkNew<vtkPointData> arrays;
  made.AddTo(arrays);
  const vtkSmartPointer<vtkDoubleArray> times =
    vtkDoubleArray::SafeDownCast(arrays->GetArray("Time"));
  arrays->RemoveArray("Time");
  this->Append(made.GetPoints(), times, arrays);
}

void TimeVaryingMesh::Append(vtkPoints* positions, vtkDoubleArray* times, vtkPointData* arrays)
{
  const vtkIdType before = this->Points->GetNumberOfPoints();
  const vtkIdType number = positions->GetNumberOfPoints();
  this->Points->GetData()->InsertTuples(before, number, 0, positions->GetData());
  this->Points->Modified();
  this->UpdateCoordinatePointers();
  this->Times->InsertTuples(before, number, 0, times);
  this->AppendArrays(arrays);
}

void TimeVaryingMesh::AppendArrays(vtkPointData* more)
{
  const vtkIdType before = this->Points->GetNumberOfPoints() - more->GetNumberOfTuples();
  for (int a = this->Arrays->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    vtkAbstractArray* array = this->Arrays->GetAbstractArray(a);
    vtkAbstractArray* added = more->GetAbstractArray(array->GetName());
    if (ExtractionArrays::AreCompatible(array, added))
    {
      array->InsertTuples(before, added->GetNumberOfTuples(), 0, added);
    }
    else
    {
      this->SkippedArrays.emplace_back(array->GetName());
      this->Arrays->RemoveArray(a);
    }
  }
}

void TimeVaryingMesh::AddBoundary(const std::vector<BoundaryCell>& cells)
{
  AppendCells(cells, this->Slabs.back().Number, this->Boundary);
}

void TimeVaryingMesh::AddStepVolume(const std::vector<BoundaryCell>& cells)
{
  AppendCells(cells, this->Slabs.back().Number, this->StepVolume);
}

vtkIdType TimeVaryingMesh::RemoveOppositeSimplices(const std::vector<vtkIdType>& tied)
{
  Slab& slab = this->Slabs.back();
  std::vector<Entry> entries;
  for (const vtkIdType s : tied)
  {
    entries.push_back(MakeEntry(slab, s, s));
  }
  std::vector<bool> isRemoved(slab.Simplices.GetSize(), false);
  bool isAny = false;
  OppositePairs::Find(entries, [&](std::size_t index) { isAny = isRemoved[index] = true; });
  return isAny ? RemoveMarked(slab, isRemoved) : 0;
}

vtkIdType TimeVaryingMesh::RemoveOppositeSimplicesAtSteps()
{
  std::vector<Entry> entries;
  std::size_t first = 0;
  for (const Slab& slab : this->Slabs)
  {
    for (std::size_t s = 0; s < slab.Ties.GetSize(); ++s)
    {
      if (slab.Ties[s] && this->IsAtOneTime(slab.Simplices[s]))
      {
        entries.push_back(MakeEntry(slab, s, first + s));
      }
    }
    first += slab.Simplices.GetSize();
  }
  std::vector<bool> isRemoved;
  OppositePairs::Find(entries,
    [&](std::size_t index)
    {
      isRemoved.resize(first, false);
      isRemoved[index] = true;
    });
  vtkIdType removed = 0;
  auto begin = isRemoved.begin();
  for (std::size_t k = 0; k < this->Slabs.size() && !isRemoved.empty(); ++k)
  {
    const auto end = begin + static_cast<std::ptrdiff_t>(this->Slabs[k].Simplices.GetSize());
    removed += RemoveMarked(this->Slabs[k], { begin, end });
    begin = end;
  }
  return removed;
}

bool TimeVaryingMesh::IsAtOneTime(const Simplex& simplex) const
{
  const double time = this->Times->GetValue(simplex[0]);
  return std::all_of(simplex.begin(), simplex.end(),
    [this, time](vtkIdType id) { return this->Times->GetValue(id) == time; });
}

void TimeVaryingMesh::ResolveTiedBoundary()
{
  if (!this->HasTies || !this->Points)
  {
    return;
  }
  const std::size_t points = static_cast<std::size_t>(this->Points->GetNumberOfPoints());
  std::vector<bool> isRemoved(this->Boundary.size(), false);
  const auto remove = [&isRemoved](std::size_t index) { isRemoved[index] = true; };
  const auto settle = [&isRemoved](std::size_t index, bool isFace, vtkIdType)
  { isRemoved[index] = !isFace; };
  TiedFaces<4> inTime(points);
  TiedFaces<4> volumes(points);
  TiedFaces<3> surfaces(points);
  for (std::size_t c = 0; c < this->Boundary.size(); ++c)
  {
    const BoundaryCell& cell = this->Boundary[c];
    if (!cell.IsTied)
    {
      continue;
    }
    if (IsVolume(cell.Kind))
    {
      volumes.Add(GetGroup(cell.Item, cell.Kind), cell.Ids.data(), c);
    }
    else if (IsSurfaceAtStep(cell.Kind))
    {
      surfaces.Add(GetGroup(cell.Item, cell.Kind), cell.Ids.data(), c);
    }
    else
    {
      inTime.Add(cell.Item, cell.Ids.data(), c);
    }
  }
  volumes.Cancel(remove);
  surfaces.Cancel(remove);
  inTime.Cancel(remove);
  for (std::size_t c = 0; c < this->Boundary.size() && !surfaces.IsEmpty(); ++c)
  {
    const BoundaryCell& cell = this->Boundary[c];
    if (IsVolume(cell.Kind) && !isRemoved[c] && surfaces.IsNear(cell.Ids.data(), 4))
    {
      ForEachFace(cell.Ids,
        [&](const std::array<vtkIdType, 3>& face)
        { surfaces.Count(GetGroup(cell.Item, cell.Kind), face.data(), 0); });
    }
  }
  surfaces.Visit(settle);
  for (const Slab& slab : this->Slabs)
  {
    ParallelFor(0, inTime.IsEmpty() ? 0 : static_cast<vtkIdType>(slab.Simplices.GetSize()),
      [&](vtkIdType s)
      {
        const Simplex& simplex = slab.Simplices[s];
        if (inTime.IsNear(simplex.data(), 5))
        {
          const int item = slab.GetItem(s);
          ForEachFace(simplex,
            [&](const std::array<vtkIdType, 4>& face) { inTime.Count(item, face.data(), 0); });
        }
      });
  }
  inTime.Visit(settle);
  if (this->Options.GetNumberOfCuts() > 0)
  {
    this->MarkRepeatedSurfaces(isRemoved);
  }
  std::size_t retained = 0;
  for (std::size_t c = 0; c < this->Boundary.size(); ++c)
  {
    const int kind = this->Boundary[c].Kind;
    if (!isRemoved[c] &&
      (kind >= Kinds::NUMBER_OF_BOUNDARY_KINDS || this->Options.IsRequested(kind)))
    {
      this->Boundary[retained++] = this->Boundary[c];
    }
  }
  this->Boundary.resize(retained);
}

void TimeVaryingMesh::MarkRepeatedSurfaces(std::vector<bool>& isRemoved) const
{
  std::set<std::array<vtkIdType, 5>> found;
  for (std::size_t c = 0; c < this->Boundary.size(); ++c)
  {
    const BoundaryCell& cell = this->Boundary[c];
    if (!isRemoved[c] && !IsVolume(cell.Kind) && !IsSurfaceAtStep(cell.Kind))
    {
      std::array<vtkIdType, 5> key{ { cell.Item } };
      std::copy(cell.Ids.begin(), cell.Ids.end(), key.begin() + 1);
      std::sort(key.begin() + 1, key.end());
      isRemoved[c] = !found.insert(key).second;
    }
  }
}

void TimeVaryingMesh::UpdateCoordinatePointers()
{
  vtkFloatArray* floats = vtkFloatArray::SafeDownCast(this->Points->GetData());
  vtkDoubleArray* doubles = vtkDoubleArray::SafeDownCast(this->Points->GetData());
  this->Floats = floats ? floats->GetPointer(0) : nullptr;
  this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
}

void TimeVaryingMesh::CleanStepVolume()
{
  using TetrahedronEntry = OppositePairs::Entry<vtkIdType, 5>;
  std::vector<TetrahedronEntry> entries(this->StepVolume.size());
  for (std::size_t c = 0; c < entries.size(); ++c)
  {
    TetrahedronEntry& entry = entries[c];
    entry.Key[0] = this->StepVolume[c].Item;
    std::copy_n(this->StepVolume[c].Ids.begin(), 4, entry.Key.begin() + 1);
    entry.IsOdd = OppositePairs::Sort(entry.Key.data() + 1, 4);
    entry.Index = c;
  }
  vtkSMPTools::Sort(entries.begin(), entries.end());
  std::vector<bool> isRetained(entries.size(), false);
  for (auto first = entries.begin(); first != entries.end();)
  {
    const auto last = std::find_if(first, entries.end(),
      [first](const TetrahedronEntry& entry) { return entry.Key != first->Key; });
    isRetained[first->Index] = std::all_of(
      first, last, [first](const TetrahedronEntry& entry) { return entry.IsOdd == first->IsOdd; });
    first = last;
  }
  std::size_t retained = 0;
  for (std::size_t c = 0; c < isRetained.size(); ++c)
  {
    if (isRetained[c])
    {
      this->StepVolume[retained++] = this->StepVolume[c];
    }
  }
  this->StepVolume.resize(retained);
}

vtkIdType TimeVaryingMesh::RemoveDuplicates()
{
  vtkIdType removed = 0;
  bool hasChanged = false;
  for (Slab& slab : this->Slabs)
  {
    if (slab.Duplicates.GetSize() > 0)
    {
      const std::uint8_t* marks = slab.Duplicates.GetData();
      const std::vector<bool> isRemoved(marks, marks + slab.Duplicates.GetSize());
      removed += RemoveMarked(slab, isRemoved);
      hasChanged = true;
    }
  }
  for (std::vector<BoundaryCell>* cells : { &this->Boundary, &this->StepVolume })
  {
    const auto retained = std::remove_if(
      cells->begin(), cells->end(), [](const BoundaryCell& cell) { return cell.IsDuplicate; });
    hasChanged |= retained != cells->end();
    cells->erase(retained, cells->end());
  }
  if (hasChanged)
  {
    this->RemoveUnusedPoints();
  }
  return removed;
}

void TimeVaryingMesh::RemoveUnusedPoints()
{
  const vtkIdType number = this->Points->GetNumberOfPoints();
  std::vector<bool> isUsed(static_cast<std::size_t>(number), false);
  const auto forEachId = [this](auto&& visit)
  {
    for (Slab& slab : this->Slabs)
    {
      for (std::size_t s = 0; s < slab.Simplices.GetSize(); ++s)
      {
        std::for_each(slab.Simplices[s].begin(), slab.Simplices[s].end(), visit);
      }
    }
    for (std::vector<BoundaryCell>* cells : { &this->Boundary, &this->StepVolume })
    {
      for (BoundaryCell& cell : *cells)
      {
        std::for_each(cell.Ids.begin(), cell.Ids.end() - (cell.Ids[3] < 0 ? 1 : 0), visit);
      }
    }
  };
  forEachId([&isUsed](vtkIdType id) { isUsed[id] = true; });
  vtkNew<vtkIdList> retained;
  std::vector<vtkIdType> newIds(isUsed.size());
  for (vtkIdType id = 0; id < number; ++id)
  {
    newIds[id] = retained->GetNumberOfIds();
    if (isUsed[id])
    {
      retained->InsertNextId(id);
    }
  }
  forEachId([&newIds](vtkIdType& id) { id = newIds[id]; });
  const auto extract = [&retained](auto* array)
  {
    const auto extracted = vtk::TakeSmartPointer(array->NewInstance());
    extracted->SetName(array->GetName());
    extracted->SetNumberOfComponents(array->GetNumberOfComponents());
    extracted->SetNumberOfTuples(retained->GetNumberOfIds());
    array->GetTuples(retained, extracted);
    return extracted;
  };
  vtkNew<vtkPoints> points;
  points->SetData(extract(this->Points->GetData()));
  this->Points = points;
  this->Times = extract(this->Times.GetPointer());
  vtkNew<vtkPointData> arrays;
  for (int a = 0; a < this->Arrays->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = this->Arrays->GetAbstractArray(a);
    ExtractionArrays::AddArrayLike(this->Arrays, array, arrays, extract(array));
  }
  this->Arrays->ShallowCopy(arrays);
  this->UpdateCoordinatePointers();
}

vtkIdType TimeVaryingMesh::GetNumberOfSimplices() const
{
  return std::accumulate(this->Slabs.begin(), this->Slabs.end(), vtkIdType(0),
    [](vtkIdType sum, const Slab& slab)
    { return sum + static_cast<vtkIdType>(slab.Simplices.GetSize()); });
}

std::size_t TimeVaryingMesh::GetBytesPerPoint() const
{
  if (!this->Points)
  {
    return 0;
  }
  std::size_t bytes = 3 * this->Points->GetData()->GetDataTypeSize() + sizeof(double);
  for (int a = 0; a < this->Arrays->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = this->Arrays->GetAbstractArray(a);
    bytes += static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
  }
  return bytes;
}

std::size_t TimeVaryingMesh::GetBytes() const
{
  std::size_t bytes = this->EndPoints.capacity() * sizeof(SharedPoint) +
    (this->Boundary.capacity() + this->StepVolume.capacity()) * sizeof(BoundaryCell);
  for (const Slab& slab : this->Slabs)
  {
    bytes += slab.Simplices.GetBytes() + slab.Items.GetBytes() + slab.Flats.GetBytes() +
      slab.Ties.GetBytes() + slab.Duplicates.GetBytes();
  }
  return bytes;
}

}
