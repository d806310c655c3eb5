#include "vtkSpaceTimeMesh.h"

#include "vtkCrossingLists.h"
#include "vtkExtractionArrays.h"
#include "vtkSpaceTimeStep.h"

#include <algorithm>
#include <utility>

namespace
{
using Kinds = vtkTimeVaryingIntervalVolume::BoundaryKinds;
using PointList = vtkExtractionBuffer<vtkExtractionPoint>;

vtkIdType GetOwner(const vtkExtractionPoint& point)
{
  return std::min(point.Near, point.Far);
}

// Points of two steps as points of the first, where all stay in place.
PointList Fold(const PointList& points, vtkIdType split)
{
  const auto fold = [split](vtkIdType id) { return id < split ? id : id - split; };
  PointList folded;
  folded.Allocate(points.GetSize());
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.GetSize()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType p = first; p < last; ++p)
      {
        folded[p] = { fold(points[p].Near), fold(points[p].Far), points[p].Weight };
      }
    });
  return folded;
}

// The places of points that move.
void InterpolatePoints(
  vtkDataSet* first, vtkDataSet* second, const PointList& points, vtkPoints* places)
{
  const vtkIdType split = first->GetNumberOfPoints();
  const auto getPoint = [&](vtkIdType id, double x[3])
  { id < split ? first->GetPoint(id, x) : second->GetPoint(id - split, x); };
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.GetSize()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType p = begin; p < end; ++p)
      {
        double near[3];
        double far[3];
        getPoint(points[p].Near, near);
        getPoint(points[p].Far, far);
        for (int axis = 0; axis < 3; ++axis)
        {
          near[axis] += points[p].Weight * (far[axis] - near[axis]);
        }
        places->SetPoint(p, near);
      }
    });
}

vtkSmartPointer<vtkPoints> MakePoints(const vtkSpaceTimeStep& first, const vtkSpaceTimeStep& second,
  const PointList& points, int precision, bool isStatic)
{
  if (isStatic)
  {
    return vtkExtractionArrays::MakePoints(
      first.GetGrid(), Fold(points, first.GetNumberOfPoints()), precision);
  }
  // Empty, but of the type that is asked for.
  vtkSmartPointer<vtkPoints> made =
    vtkExtractionArrays::MakePoints(first.GetGrid(), PointList(), precision);
  made->SetNumberOfPoints(static_cast<vtkIdType>(points.GetSize()));
  InterpolatePoints(first.GetGrid(), second.GetGrid(), points, made);
  return made;
}

vtkSmartPointer<vtkDoubleArray> MakeTimes(
  const vtkSpaceTimeStep& first, const vtkSpaceTimeStep& second, const PointList& points)
{
  const vtkIdType split = first.GetNumberOfPoints();
  const double begin = first.GetTime();
  const double end = second.GetTime();
  auto times = vtkSmartPointer<vtkDoubleArray>::New();
  times->SetName("Time");
  times->SetNumberOfValues(static_cast<vtkIdType>(points.GetSize()));
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.GetSize()),
    [&](vtkIdType firstPoint, vtkIdType lastPoint)
    {
      for (vtkIdType p = firstPoint; p < lastPoint; ++p)
      {
        const double near = points[p].Near < split ? begin : end;
        const double far = points[p].Far < split ? begin : end;
        times->SetValue(p, near + points[p].Weight * (far - near));
      }
    });
  return times;
}

// The ids of a cell in ascending order, and whether that took an odd number of exchanges.
std::pair<std::array<vtkIdType, 4>, bool> Sort(std::array<vtkIdType, 4> ids)
{
  const int number = ids[3] < 0 ? 3 : 4;
  bool isOdd = false;
  for (int end = number; end > 1; --end)
  {
    for (int i = 1; i < end; ++i)
    {
      if (ids[i] < ids[i - 1])
      {
        std::swap(ids[i], ids[i - 1]);
        isOdd = !isOdd;
      }
    }
  }
  return { ids, isOdd };
}
}

void vtkSpaceTimeMesh::BeginSlab(int number, bool isFirst, bool isLast, bool isJoined)
{
  this->IsLast = isLast;
  this->WantedKinds = this->Options.Boundaries;
  for (const int kind :
    { Kinds::LOWER_SURFACE_AT_START, Kinds::UPPER_SURFACE_AT_START, Kinds::VOLUME_AT_START })
  {
    this->WantedKinds[kind] = this->WantedKinds[kind] && isFirst;
  }
  for (const int kind :
    { Kinds::LOWER_SURFACE_AT_END, Kinds::UPPER_SURFACE_AT_END, Kinds::VOLUME_AT_END })
  {
    this->WantedKinds[kind] = this->WantedKinds[kind] && isLast;
  }
  this->Slabs.emplace_back();
  this->Slabs.back().Number = number;
  this->BoundaryBegin = this->Boundary.size();
  if (!isJoined)
  {
    this->EndPoints.clear();
  }
}

bool vtkSpaceTimeMesh::HasWantedKinds() const
{
  return std::find(this->WantedKinds.begin(), this->WantedKinds.end(), true) !=
    this->WantedKinds.end();
}

vtkExtractionBuffer<vtkIdType> vtkSpaceTimeMesh::AddPoints(const vtkSpaceTimeStep& first,
  const vtkSpaceTimeStep& second, const PointList& points, const vtkCrossingLists& lists,
  bool isStatic)
{
  const vtkIdType split = first.GetNumberOfPoints();
  const vtkIdType number = static_cast<vtkIdType>(points.GetSize());
  const vtkIdType before = this->Points ? this->Points->GetNumberOfPoints() : 0;
  vtkExtractionBuffer<vtkIdType> ids;
  ids.Allocate(number);
  PointList added;
  added.Allocate(number);
  // Points are sorted by owner: those that the slab before may have come first.
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
      const vtkIdType place = unshared - numberShared;
      ids[unshared] = before + place;
      added[place] = points[unshared];
    }
  }
  vtkSMPTools::For(unshared, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType p = begin; p < end; ++p)
      {
        ids[p] = before + p - numberShared;
        added[p - numberShared] = points[p];
      }
    });
  added.Truncate(number - numberShared);
  this->FindEndPoints(points, lists, split, ids);
  this->AppendPoints(first, second, added, isStatic);
  return ids;
}

void vtkSpaceTimeMesh::FindEndPoints(const PointList& points, const vtkCrossingLists& lists,
  vtkIdType split, const vtkExtractionBuffer<vtkIdType>& ids)
{
  this->EndPoints.clear();
  if (this->IsLast)
  {
    return;
  }
  const vtkExtractionPoint* const end = points.GetData() + points.GetSize();
  const vtkExtractionPoint* const begin = std::partition_point(points.GetData(), end,
    [split](const vtkExtractionPoint& point) { return GetOwner(point) < split; });
  this->EndPoints.reserve(end - begin);
  for (const vtkExtractionPoint* point = begin; point != end; ++point)
  {
    // As the next slab will name it.
    const vtkIdType p = point - points.GetData();
    const vtkCrossingKey key = lists.GetKey(p);
    const bool isGridPoint = key == vtkCrossingKey();
    this->EndPoints.push_back({ GetOwner(*point) - split,
      isGridPoint ? key : vtkCrossingKey(key.GetFar() - split, key.GetValue()), ids[p] });
  }
}

void vtkSpaceTimeMesh::AppendPoints(const vtkSpaceTimeStep& first, const vtkSpaceTimeStep& second,
  const PointList& points, bool isStatic)
{
  const vtkSmartPointer<vtkPoints> places =
    MakePoints(first, second, points, this->Options.Precision, isStatic);
  const vtkSmartPointer<vtkDoubleArray> times = MakeTimes(first, second, points);
  vtkNew<vtkPointData> arrays;
  vtkPointData* from = first.GetGrid()->GetPointData();
  vtkPointData* to = second.GetGrid()->GetPointData();
  vtkExtractionArrays::InterpolatePointData(from, to, first.GetNumberOfPoints(), points, arrays);
  for (const char* own : { "Time", "DeltaT" })
  {
    arrays->RemoveArray(own);
  }
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array->GetName() && vtkExtractionArrays::IsCarried(from, array) &&
      !arrays->HasArray(array->GetName()))
    {
      this->ArraysLeftOut.emplace_back(array->GetName());
    }
  }
  if (!this->Points)
  {
    this->Points = places;
    this->Times = times;
    this->Arrays->ShallowCopy(arrays);
    this->FindCoordinates();
    return;
  }
  const vtkIdType before = this->Points->GetNumberOfPoints();
  const vtkIdType number = places->GetNumberOfPoints();
  this->Points->GetData()->InsertTuples(before, number, 0, places->GetData());
  this->Points->Modified();
  this->FindCoordinates();
  this->Times->InsertTuples(before, number, 0, times);
  this->AppendArrays(arrays);
}

void vtkSpaceTimeMesh::AppendArrays(vtkPointData* more)
{
  const vtkIdType before = this->Points->GetNumberOfPoints() - more->GetNumberOfTuples();
  for (int a = this->Arrays->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    vtkAbstractArray* array = this->Arrays->GetAbstractArray(a);
    vtkAbstractArray* added = more->GetAbstractArray(array->GetName());
    if (vtkExtractionArrays::IsAlike(array, added))
    {
      array->InsertTuples(before, added->GetNumberOfTuples(), 0, added);
    }
    else
    {
      this->ArraysLeftOut.emplace_back(array->GetName() ? array->GetName() : "");
      this->Arrays->RemoveArray(a);
    }
  }
}

void vtkSpaceTimeMesh::AddBoundary(const std::vector<BoundaryCell>& cells)
{
  for (BoundaryCell cell : cells)
  {
    cell.Slab = this->Slabs.back().Number;
    this->Boundary.push_back(cell);
  }
}

void vtkSpaceTimeMesh::RemoveOppositeBoundaryCells()
{
  struct Entry
  {
    std::array<vtkIdType, 6> Key;
    bool IsOdd;
    std::size_t Place;
  };
  std::vector<Entry> entries;
  for (std::size_t c = this->BoundaryBegin; c < this->Boundary.size(); ++c)
  {
    const BoundaryCell& cell = this->Boundary[c];
    const auto sorted = Sort(cell.Ids);
    entries.push_back({ { { cell.Kind, cell.Item, sorted.first[0], sorted.first[1], sorted.first[2],
                          sorted.first[3] } },
      sorted.second, c });
  }
  std::sort(entries.begin(), entries.end(),
    [](const Entry& a, const Entry& b)
    { return a.Key != b.Key ? a.Key < b.Key : a.Place < b.Place; });
  std::vector<bool> isRemoved(this->Boundary.size() - this->BoundaryBegin, false);
  for (std::size_t e = 0; e + 1 < entries.size(); ++e)
  {
    if (entries[e].Key == entries[e + 1].Key && entries[e].IsOdd != entries[e + 1].IsOdd)
    {
      isRemoved[entries[e].Place - this->BoundaryBegin] = true;
      isRemoved[entries[e + 1].Place - this->BoundaryBegin] = true;
      ++e;
    }
  }
  std::size_t kept = this->BoundaryBegin;
  for (std::size_t c = this->BoundaryBegin; c < this->Boundary.size(); ++c)
  {
    if (!isRemoved[c - this->BoundaryBegin])
    {
      this->Boundary[kept++] = this->Boundary[c];
    }
  }
  this->Boundary.resize(kept);
}

void vtkSpaceTimeMesh::FindCoordinates()
{
  vtkFloatArray* floats = vtkFloatArray::SafeDownCast(this->Points->GetData());
  vtkDoubleArray* doubles = vtkDoubleArray::SafeDownCast(this->Points->GetData());
  this->Floats = floats ? floats->GetPointer(0) : nullptr;
  this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
}

std::size_t vtkSpaceTimeMesh::GetBytes() const
{
  std::size_t bytes = this->EndPoints.capacity() * sizeof(SharedPoint) +
    this->Boundary.capacity() * sizeof(BoundaryCell);
  for (const Slab& slab : this->Slabs)
  {
    bytes += slab.Simplices.GetBytes() + slab.Items.GetBytes() + slab.Flats.GetBytes();
  }
  return bytes;
}
