// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/CriterionCut.h"

#include "Output/ExtractionPoint.h"
#include "Output/OppositePairs.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interlume
{

namespace
{
template <typename T>
void Gather(ExtractionBuffer<T>& values, const std::vector<vtkIdType>& from)
{
  if (values.GetSize() == 0)
  {
    return;
  }
  ExtractionBuffer<T> gathered;
  gathered.Allocate(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    gathered[i] = values[from[i]];
  }
  values = std::move(gathered);
}

template <std::size_t Size>
bool AreDistinct(std::array<vtkIdType, Size> ids)
{
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) == ids.end();
}
}

// The parts of a simplex with k points in a half and m points outside of it. For each j < k, the
// points 0 to j and the cut edges along a path from (j, 0) to (k - 1, m - 1) form a part, where
// (i, o) is the edge between point i inside and point o outside. Each step of a path increments i
// or o. This is the staircase triangulation of a product of simplices.
template <std::size_t Size>
struct CriterionCut::Clip
{
  using Ids = std::array<vtkIdType, Size>;

  Ids Inside;
  Ids Outside;
  int NumberInside = 0;
  int NumberOutside = 0;
  bool IsOdd = false;
  Ids Part;

  // Sorts the points, and notes whether this changes the orientation.
  template <typename IsInside>
  Clip(Ids ids, IsInside&& isInside)
  {
    this->IsOdd = OppositePairs::Sort(ids.data(), static_cast<int>(Size));
    for (const vtkIdType id : ids)
    {
      if (isInside(id))
      {
        this->IsOdd ^= this->NumberOutside % 2 == 1;
        this->Inside[this->NumberInside++] = id;
      }
      else
      {
        this->Outside[this->NumberOutside++] = id;
      }
    }
  }

  // Visits the paths from edge (i, o), where \a next is the number of points of the part so far.
  template <typename GetPoint, typename Visitor>
  void Walk(int i, int o, std::size_t next, bool isOdd, GetPoint&& getPoint, Visitor&& visit)
  {
    this->Part[next++] = getPoint(this->Inside[i], this->Outside[o]);
    if (next == Size)
    {
      visit(isOdd);
    }
    if (i + 1 < this->NumberInside)
    {
      this->Walk(i + 1, o, next, isOdd != (o % 2 == 0), getPoint, visit);
    }
    if (o + 1 < this->NumberOutside)
    {
      this->Walk(i, o + 1, next, isOdd, getPoint, visit);
    }
  }
};

CriterionCut::CriterionCut(TimeVaryingMesh& mesh, const std::string& key)
  : Mesh(mesh)
  , Array(mesh.GetArrays()->GetArray(key.c_str()))
{
}

vtkIdType CriterionCut::GetPoint(vtkIdType inside, vtkIdType outside, const Half& half)
{
  if (this->Values[inside] == half.Bound)
  {
    return inside;
  }
  const auto number = static_cast<std::uint64_t>(this->Values.size());
  const auto ends = std::minmax(inside, outside);
  // Two halves have separate points, since their parts are separate.
  const bool isSecond = &half != this->Halves.data();
  const std::uint64_t key =
    2 * (static_cast<std::uint64_t>(ends.first) * number + ends.second) + isSecond;
  const auto found =
    this->Ids.emplace(key, static_cast<vtkIdType>(this->Values.size() + this->Points.size()));
  if (found.second)
  {
    ExtractionPoint point{ ends.first, ends.second, 0.0 };
    const auto weigh = [this, &half](const ExtractionPoint& on)
    {
      const double near = this->Values[on.Near];
      return (half.Bound - near) / (this->Values[on.Far] - near);
    };
    point.Weight = weigh(point);
    if (point.Weight > 0.5)
    {
      std::swap(point.Near, point.Far);
      point.Weight = weigh(point);
    }
    this->Points.push_back(point);
    this->Bounds.push_back(half.Bound);
  }
  return found.first->second;
}

template <std::size_t Size, typename Add, typename AddFace>
void CriterionCut::Cut(
  const std::array<vtkIdType, Size>& ids, const Half& half, Add&& add, AddFace&& addFace)
{
  Clip<Size> clip(ids,
    [this, &half](vtkIdType id)
    { return half.IsAbove ? this->Values[id] >= half.Bound : this->Values[id] <= half.Bound; });
  if (half.IsOpen && this->HasBound(clip.Inside.data(), clip.NumberInside, half))
  {
    return;
  }
  if (clip.NumberOutside == 0)
  {
    add(ids);
    if (half.IsOpen && half.Kind >= 0)
    {
      TimeVaryingMesh::ForEachFace(ids,
        [&](const auto& face)
        {
          if (this->HasBound(face.data(), static_cast<int>(face.size()), half))
          {
            addFace(face, true);
          }
        });
    }
    return;
  }
  const auto getPoint = [this, &half](vtkIdType inside, vtkIdType outside)
  { return this->GetPoint(inside, outside, half); };
  for (int j = 0; j < clip.NumberInside; ++j)
  {
    std::copy_n(clip.Inside.begin(), j + 1, clip.Part.begin());
    clip.Walk(j, 0, j + 1, clip.IsOdd, getPoint,
      [&](bool isOdd)
      {
        std::array<vtkIdType, Size> part = clip.Part;
        std::array<vtkIdType, Size - 1> face;
        std::copy(part.begin() + 1, part.end(), face.begin());
        if (isOdd)
        {
          std::swap(part[0], part[1]);
          std::swap(face[0], face[1]);
        }
        if (AreDistinct(part))
        {
          add(part);
        }
        if (j == 0 && half.Kind >= 0 && AreDistinct(face))
        {
          // If all points are points of the simplex, the face may also be a face of another one.
          addFace(face,
            std::all_of(face.begin(), face.end(),
              [this](vtkIdType id) { return id < static_cast<vtkIdType>(this->Values.size()); }));
        }
      });
  }
}

bool CriterionCut::HasBound(const vtkIdType* ids, int number, const Half& half) const
{
  return std::all_of(
    ids, ids + number, [this, &half](vtkIdType id) { return this->Values[id] == half.Bound; });
}

bool CriterionCut::IsFinite(const vtkIdType* ids, std::size_t number) const
{
  return std::all_of(
    ids, ids + number, [this](vtkIdType id) { return std::isfinite(this->Values[id]); });
}

std::array<vtkIdType, 4> CriterionCut::MakeKey(std::array<vtkIdType, 4> ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

void CriterionCut::FindDroppedFaces()
{
  this->Dropped.clear();
  for (const TimeVaryingMesh::Slab& slab : this->Mesh.Slabs)
  {
    for (std::size_t s = 0; s < slab.Simplices.GetSize(); ++s)
    {
      const TimeVaryingMesh::Simplex& simplex = slab.Simplices[s];
      if (this->IsFinite(simplex.data(), simplex.size()))
      {
        continue;
      }
      TimeVaryingMesh::ForEachFace(simplex,
        [this](const std::array<vtkIdType, 4>& face)
        {
          this->Dropped.insert(MakeKey(face));
          TimeVaryingMesh::ForEachFace(face,
            [this](const std::array<vtkIdType, 3>& triangle) {
              this->Dropped.insert(MakeKey({ { triangle[0], triangle[1], triangle[2], -1 } }));
            });
        });
    }
  }
}

void CriterionCut::CutSlab(TimeVaryingMesh::Slab& slab, std::vector<BoundaryCell>& boundary)
{
  std::vector<TimeVaryingMesh::Simplex> parts;
  std::vector<vtkIdType> origins;
  std::vector<vtkIdType> cut;
  for (vtkIdType s = 0; s < static_cast<vtkIdType>(slab.Simplices.GetSize()); ++s)
  {
    const TimeVaryingMesh::Simplex& simplex = slab.Simplices[s];
    if (!this->IsFinite(simplex.data(), simplex.size()))
    {
      continue;
    }
    for (const Half& half : this->Halves)
    {
      this->Cut(
        simplex, half,
        [&](const TimeVaryingMesh::Simplex& part)
        {
          if (part != simplex)
          {
            cut.push_back(static_cast<vtkIdType>(parts.size()));
          }
          parts.push_back(part);
          origins.push_back(s);
        },
        [&](const std::array<vtkIdType, 4>& face, bool isTied)
        {
          this->Mesh.HasTies |= isTied;
          boundary.push_back({ face, half.Kind, slab.GetItem(s), slab.Number, isTied,
            slab.Duplicates.GetSize() > 0 && slab.Duplicates[s] != 0 });
        });
    }
  }
  Gather(slab.Items, origins);
  Gather(slab.Flats, origins);
  Gather(slab.Ties, origins);
  Gather(slab.Duplicates, origins);
  slab.Simplices.Allocate(parts.size());
  std::copy(parts.begin(), parts.end(), slab.Simplices.GetData());
  for (std::size_t i = 0; i < cut.size() && slab.Flats.GetSize() > 0; ++i)
  {
    slab.Flats[cut[i]] = 0;
  }
}

void CriterionCut::CutCells(std::vector<BoundaryCell>& cells)
{
  std::vector<BoundaryCell> parts;
  const auto ignoreFace = [](const auto&, bool) {};
  for (const BoundaryCell& cell : cells)
  {
    const std::size_t size = cell.Ids[3] < 0 ? 3 : 4;
    if (!this->IsFinite(cell.Ids.data(), size) ||
      (!this->Dropped.empty() && this->Dropped.count(MakeKey(cell.Ids)) > 0))
    {
      continue;
    }
    const bool isInTime = size == 4 && !TimeVaryingMesh::IsVolume(cell.Kind);
    const auto add = [&](const auto& ids)
    {
      parts.push_back(cell);
      std::copy(ids.begin(), ids.end(), parts.back().Ids.begin());
    };
    for (const Half& half : this->Halves)
    {
      if (isInTime && this->HasBound(cell.Ids.data(), 4, half))
      {
        // The 4-simplex of this face may be on either side of the bound.
        parts.push_back(cell);
        parts.back().IsTied = true;
        this->Mesh.HasTies = true;
        continue;
      }
      if (size == 3)
      {
        this->Cut(std::array<vtkIdType, 3>{ { cell.Ids[0], cell.Ids[1], cell.Ids[2] } }, half, add,
          ignoreFace);
      }
      else
      {
        this->Cut(cell.Ids, half, add, ignoreFace);
      }
    }
  }
  cells.swap(parts);
}

void CriterionCut::Execute(const std::vector<Half>& halves)
{
  this->Halves = halves;
  this->Points.clear();
  this->Bounds.clear();
  this->Ids.clear();
  const vtkIdType before = this->Array->GetNumberOfTuples();
  this->Values.resize(static_cast<std::size_t>(before));
  for (vtkIdType p = 0; p < before; ++p)
  {
    this->Values[p] = this->Array->GetComponent(p, 0);
  }
  this->FindDroppedFaces();
  this->CutCells(this->Mesh.Boundary);
  this->CutCells(this->Mesh.StepVolume);
  for (TimeVaryingMesh::Slab& slab : this->Mesh.Slabs)
  {
    this->CutSlab(slab, this->Mesh.Boundary);
  }
  this->Mesh.AddEdgePoints(this->Points);
  for (std::size_t p = 0; p < this->Bounds.size(); ++p)
  {
    // Without rounding errors of the interpolation, so that another cut of a double array at the
    // same bound has no slivers.
    this->Array->SetComponent(before + static_cast<vtkIdType>(p), 0, this->Bounds[p]);
  }
}

}
