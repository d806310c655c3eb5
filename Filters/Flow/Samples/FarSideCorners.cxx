// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/FarSideCorners.h"

#include "Cells/MultilinearCell.h"
#include "Common/Blanking.h"
#include "Common/Vectors.h"
#include "Samples/ImplicitFlowArrays.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkTerminationSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace interlume
{

namespace
{
constexpr int MaximumCorners = 8;
// Maximum distance of a corner that counts as on the surface, as a fraction of the cell's diagonal.
constexpr double OnSurface = 1e-9;

// Finds the corners and pairs of one cell at a time. Each thread has its own object.
class CellSearch
{
public:
  CellSearch(vtkDataSet* samples, const ImplicitFlowArrays& arrays, const AdvectionOptions& options)
    : Samples(samples)
    , Arrays(arrays)
    , Options(options)
  {
    this->Blanking.SetBlanking(samples);
  }

  /// If surfaces cross the cell, adds its corners to \a found. Otherwise, if \a pairs is not null,
  /// adds pairs of its corners to \a pairs.
  void Search(vtkIdType cell, vtkIdList* ids, std::vector<FarSideCorners::Corner>& found,
    std::vector<FarSideCorners::Pair>* pairs)
  {
    if (!this->Load(cell, ids) || !this->IsMixed())
    {
      return;
    }
    bool isCrossed = false;
    for (std::size_t s = 0; s < this->Options.Surfaces.size(); ++s)
    {
      if (this->IsReachedHere(this->Options.Surfaces[s]) && this->IsCrossedBy(s))
      {
        isCrossed = true;
        this->AddCorners(static_cast<int>(s), found);
      }
    }
    if (pairs && !isCrossed && this->HasOneId())
    {
      this->AddPairs(this->Samples->GetCellType(cell), *pairs);
    }
  }

private:
  bool Load(vtkIdType cell, vtkIdList* ids)
  {
    switch (this->Samples->GetCellType(cell))
    {
      case VTK_TETRA:
      case VTK_VOXEL:
      case VTK_HEXAHEDRON:
      case VTK_WEDGE:
      case VTK_PYRAMID:
        break;
      default:
        return false;
    }
    this->Samples->GetCellPoints(cell, ids);
    this->Number = static_cast<int>(ids->GetNumberOfIds());
    std::copy(ids->begin(), ids->end(), this->Ids.begin());
    return !this->Blanking.IsCellHidden(cell) &&
      std::none_of(
        ids->begin(), ids->end(), [this](vtkIdType p) { return this->Blanking.IsPointBlanked(p); });
  }

  bool IsMixed() const
  {
    for (int i = 1; i < this->Number; ++i)
    {
      if (!this->Arrays.HaveSameEnd(this->Ids[i], this->Ids[0]))
      {
        return true;
      }
    }
    return this->Arrays.IsReached(this->Ids[0]) && this->Arrays.HasSides() &&
      this->Arrays.IsAcrossSurface(this->Ids.data(), this->Number);
  }

  static bool HasId(const AdvectionOptions::Surface& surface, int id)
  {
    return id >= surface.Id && id < surface.Id + surface.Shape->GetNumberOfParts();
  }
  bool IsReachedHere(const AdvectionOptions::Surface& surface) const
  {
    return std::any_of(this->Ids.begin(), this->Ids.begin() + this->Number,
      [&](vtkIdType p)
      { return this->Arrays.IsReached(p) && HasId(surface, this->Arrays.GetId(p)); });
  }

  bool IsCrossedBy(std::size_t s)
  {
    const AdvectionOptions::Surface& surface = this->Options.Surfaces[s];
    double above = VTK_DOUBLE_MAX;
    double below = VTK_DOUBLE_MAX;
    double lower[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
    double upper[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
    double x[MaximumCorners][3];
    bool isOff = false;
    for (int i = 0; i < this->Number; ++i)
    {
      const vtkIdType id = this->Ids[i];
      this->Samples->GetPoint(id, x[i]);
      const bool isOn = this->Arrays.IsReached(id) && HasId(surface, this->Arrays.GetId(id)) &&
        this->Arrays.GetTime(id) == 0.0;
      const double distance = isOn ? 0.0 : surface.Shape->EvaluateDistance(x[i]);
      this->Distances[i] = distance;
      above = distance >= 0.0 ? std::min(above, distance) : above;
      below = distance <= 0.0 ? std::min(below, -distance) : below;
      isOff = isOff || distance != 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        lower[axis] = std::min(lower[axis], x[i][axis]);
        upper[axis] = std::max(upper[axis], x[i][axis]);
      }
    }
    this->Length = Vectors::SafeLength(Vectors::Difference(upper, lower));
    bool isCrossed = isOff && above + below <= this->Length;
    for (int i = 0; i < this->Number && isCrossed; ++i)
    {
      // A sample on the surface with the status STAGNATED has not reached the surface.
      isCrossed = std::abs(this->Distances[i]) > OnSurface * this->Length
        ? surface.Shape->ProjectsOntoSurface(x[i])
        : this->Arrays.GetStatus(this->Ids[i]) != vtkFlowStatus::STAGNATED;
    }
    return isCrossed;
  }

  void AddCorners(int surface, std::vector<FarSideCorners::Corner>& found) const
  {
    for (int i = 0; i < this->Number; ++i)
    {
      FarSideCorners::Corner corner;
      corner.Sample = this->Ids[i];
      corner.Surface = surface;
      corner.Distance = this->Distances[i];
      corner.Length = this->Length;
      for (int j = 0; j < this->Number; ++j)
      {
        // Compare signs, because the product of the distances may overflow or underflow.
        const double other = this->Distances[j];
        const bool isAcross = (this->Distances[i] <= 0.0 && other >= 0.0) ||
          (this->Distances[i] >= 0.0 && other <= 0.0);
        corner.IsOtherReached =
          corner.IsOtherReached || (isAcross && j != i && this->Arrays.IsReached(this->Ids[j]));
      }
      found.push_back(corner);
    }
  }

  bool IsReached(int corner) const { return this->Arrays.IsReached(this->Ids[corner]); }

  /// Returns true if some corners reach the same surface and the others reach none.
  bool HasOneId() const
  {
    int id = -1;
    bool isOne = true;
    bool isOtherThere = false;
    for (int i = 0; i < this->Number; ++i)
    {
      const int own = this->IsReached(i) ? this->Arrays.GetId(this->Ids[i]) : -1;
      isOtherThere = isOtherThere || own < 0;
      isOne = isOne && (own < 0 || id < 0 || own == id);
      id = std::max(id, own);
    }
    return isOne && isOtherThere && id >= 0;
  }

  void AddPair(int first, int second, bool isEdge, std::vector<FarSideCorners::Pair>& pairs) const
  {
    const bool isReached = this->IsReached(first);
    pairs.push_back(
      { this->Ids[isReached ? first : second], this->Ids[isReached ? second : first], isEdge });
  }

  void AddPairs(int type, std::vector<FarSideCorners::Pair>& pairs) const
  {
    const MultilinearCell::Shapes shape = MultilinearCell::GetShape(type);
    const int* corners = nullptr;
    MultilinearCell::GetCorners(shape, corners);
    std::array<int, MaximumCorners> ofCube{};
    for (int i = 0; i < this->Number; ++i)
    {
      ofCube[type == VTK_VOXEL ? i : corners[i]] = i;
    }
    const int(*edges)[2] = nullptr;
    const int number = MultilinearCell::GetEdges(shape, edges);
    std::array<bool, MaximumCorners> hasPair{};
    for (int edge = 0; edge < number; ++edge)
    {
      const int first = ofCube[edges[edge][0]];
      const int second = ofCube[edges[edge][1]];
      if (this->IsReached(first) != this->IsReached(second))
      {
        hasPair[first] = hasPair[second] = true;
        this->AddPair(first, second, true, pairs);
      }
    }
    for (int i = 0; i < this->Number; ++i)
    {
      if (!hasPair[i])
      {
        this->AddPair(i, this->FindNearestOther(i), false, pairs);
      }
    }
  }

  int FindNearestOther(int corner) const
  {
    double x[3];
    this->Samples->GetPoint(this->Ids[corner], x);
    int nearest = -1;
    double smallest = VTK_DOUBLE_MAX;
    for (int i = 0; i < this->Number; ++i)
    {
      double other[3];
      this->Samples->GetPoint(this->Ids[i], other);
      const double distance = Vectors::SafeLength(Vectors::Difference(x, other));
      if (this->IsReached(i) != this->IsReached(corner) && (nearest < 0 || distance < smallest))
      {
        nearest = i;
        smallest = distance;
      }
    }
    return nearest;
  }

  vtkDataSet* Samples;
  const ImplicitFlowArrays& Arrays;
  const AdvectionOptions& Options;
  interlume::Blanking Blanking;
  int Number = 0;
  std::array<vtkIdType, MaximumCorners> Ids{};
  std::array<double, MaximumCorners> Distances{};
  double Length = 0.0;
};

// Orders corners by sample, and the corners of one sample by the distance to their surface.
bool IsBefore(const FarSideCorners::Corner& a, const FarSideCorners::Corner& b)
{
  return std::make_tuple(a.Sample, std::abs(a.Distance), a.Surface) <
    std::make_tuple(b.Sample, std::abs(b.Distance), b.Surface);
}

// Sorts pairs and removes duplicates. An edge precedes an equal pair that is not one.
void RemoveDuplicates(std::vector<FarSideCorners::Pair>& pairs)
{
  using Pair = FarSideCorners::Pair;
  std::sort(pairs.begin(), pairs.end(),
    [](const Pair& a, const Pair& b)
    { return std::tie(a.Reached, a.Other, b.IsEdge) < std::tie(b.Reached, b.Other, a.IsEdge); });
  pairs.erase(
    std::unique(pairs.begin(), pairs.end(),
      [](const Pair& a, const Pair& b) { return a.Reached == b.Reached && a.Other == b.Other; }),
    pairs.end());
}
}

void FarSideCorners::RemoveRedundant(std::vector<Pair>& pairs)
{
  std::vector<vtkIdType> ends;
  for (const Pair& pair : pairs)
  {
    if (pair.IsEdge)
    {
      ends.insert(ends.end(), { pair.Reached, pair.Other });
    }
  }
  std::sort(ends.begin(), ends.end());
  const auto isEnd = [&ends](vtkIdType sample)
  { return std::binary_search(ends.begin(), ends.end(), sample); };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                [&isEnd](const Pair& pair)
                { return !pair.IsEdge && isEnd(pair.Reached) && isEnd(pair.Other); }),
    pairs.end());
}

std::vector<FarSideCorners::Corner> FarSideCorners::Find(vtkDataSet* samples,
  const ImplicitFlowArrays& arrays, const AdvectionOptions& options, std::vector<Pair>* pairs)
{
  const vtkIdType cells = options.Surfaces.empty() && !pairs ? 0 : samples->GetNumberOfCells();
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPThreadLocal<std::vector<Corner>> threads;
  vtkSMPThreadLocal<std::vector<Pair>> pairsOfThreads;
  if (cells > 0)
  {
    // The first calls build caches in the dataset. Make them before threads start.
    samples->GetCellPoints(0, lists.Local());
    samples->GetCellType(0);
  }
  vtkSMPTools::For(0, cells,
    [&](vtkIdType first, vtkIdType last)
    {
      CellSearch search(samples, arrays, options);
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        search.Search(
          cell, lists.Local(), threads.Local(), pairs ? &pairsOfThreads.Local() : nullptr);
      }
    });
  std::vector<Corner> all;
  for (const std::vector<Corner>& own : threads)
  {
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end(), IsBefore);
  std::vector<Corner> found;
  for (const Corner& corner : all)
  {
    if (found.empty() || found.back().Sample != corner.Sample)
    {
      found.push_back(corner);
    }
    else if (found.back().Surface == corner.Surface)
    {
      found.back().Length = std::max(found.back().Length, corner.Length);
      found.back().IsOtherReached = found.back().IsOtherReached || corner.IsOtherReached;
    }
  }
  if (pairs)
  {
    pairs->clear();
    for (const std::vector<Pair>& own : pairsOfThreads)
    {
      pairs->insert(pairs->end(), own.begin(), own.end());
    }
    RemoveDuplicates(*pairs);
  }
  return found;
}

}
