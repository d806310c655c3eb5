// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/BeyondCorners.h"

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
constexpr int MostCorners = 8;
// The distance, as a share of a cell's diagonal, within which a corner is on the surface.
constexpr double OnSurface = 1e-9;

// Searches one cell at a time, for one thread.
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

  /// Adds the corners of a cell that a surface passes through, and otherwise, if \a pairs is not
  /// null, the pairs of its corners.
  void Search(vtkIdType cell, vtkIdList* ids, std::vector<BeyondCorners::Corner>& found,
    std::vector<BeyondCorners::Pair>* pairs)
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
      if (!this->Arrays.AreAlike(this->Ids[i], this->Ids[0]))
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
    double x[MostCorners][3];
    bool isLeft = false;
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
      isLeft = isLeft || distance != 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        lower[axis] = std::min(lower[axis], x[i][axis]);
        upper[axis] = std::max(upper[axis], x[i][axis]);
      }
    }
    this->Length = Vectors::SafeLength(Vectors::Difference(upper, lower));
    bool isCrossed = isLeft && above + below <= this->Length;
    for (int i = 0; i < this->Number && isCrossed; ++i)
    {
      // A streamline that stagnates on the surface ends for a reason of its own.
      isCrossed = std::abs(this->Distances[i]) > OnSurface * this->Length
        ? surface.Shape->IsBeside(x[i])
        : this->Arrays.GetStatus(this->Ids[i]) != vtkFlowStatus::STAGNATED;
    }
    return isCrossed;
  }

  void AddCorners(int surface, std::vector<BeyondCorners::Corner>& found) const
  {
    for (int i = 0; i < this->Number; ++i)
    {
      BeyondCorners::Corner corner;
      corner.Sample = this->Ids[i];
      corner.Surface = surface;
      corner.Distance = this->Distances[i];
      corner.Length = this->Length;
      for (int j = 0; j < this->Number; ++j)
      {
        // The product of distances may be no number.
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

  /// Returns whether some corners reach a surface, all of them the same one, and some do not.
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

  void AddPair(int first, int second, std::vector<BeyondCorners::Pair>& pairs) const
  {
    pairs.push_back(this->IsReached(first)
        ? BeyondCorners::Pair{ this->Ids[first], this->Ids[second] }
        : BeyondCorners::Pair{ this->Ids[second], this->Ids[first] });
  }

  void AddPairs(int type, std::vector<BeyondCorners::Pair>& pairs) const
  {
    const MultilinearCell::Shapes shape = MultilinearCell::GetShape(type);
    const int* corners = nullptr;
    MultilinearCell::GetCorners(shape, corners);
    std::array<int, MostCorners> ofCube{};
    for (int i = 0; i < this->Number; ++i)
    {
      ofCube[type == VTK_VOXEL ? i : corners[i]] = i;
    }
    const int(*edges)[2] = nullptr;
    const int number = MultilinearCell::GetEdges(shape, edges);
    std::array<bool, MostCorners> hasPair{};
    for (int edge = 0; edge < number; ++edge)
    {
      const int first = ofCube[edges[edge][0]];
      const int second = ofCube[edges[edge][1]];
      if (this->IsReached(first) != this->IsReached(second))
      {
        hasPair[first] = hasPair[second] = true;
        this->AddPair(first, second, pairs);
      }
    }
    for (int i = 0; i < this->Number; ++i)
    {
      if (!hasPair[i])
      {
        this->AddPair(i, this->FindNearestOther(i), pairs);
      }
    }
  }

  int FindNearestOther(int corner) const
  {
    double x[3];
    this->Samples->GetPoint(this->Ids[corner], x);
    int nearest = -1;
    double least = VTK_DOUBLE_MAX;
    for (int i = 0; i < this->Number; ++i)
    {
      double other[3];
      this->Samples->GetPoint(this->Ids[i], other);
      const double distance = Vectors::SafeLength(Vectors::Difference(x, other));
      if (this->IsReached(i) != this->IsReached(corner) && (nearest < 0 || distance < least))
      {
        nearest = i;
        least = distance;
      }
    }
    return nearest;
  }

  vtkDataSet* Samples;
  const ImplicitFlowArrays& Arrays;
  const AdvectionOptions& Options;
  interlume::Blanking Blanking;
  int Number = 0;
  std::array<vtkIdType, MostCorners> Ids{};
  std::array<double, MostCorners> Distances{};
  double Length = 0.0;
};

// Orders corners of one sample by distance, the nearest surface first.
bool IsBefore(const BeyondCorners::Corner& a, const BeyondCorners::Corner& b)
{
  return std::make_tuple(a.Sample, std::abs(a.Distance), a.Surface) <
    std::make_tuple(b.Sample, std::abs(b.Distance), b.Surface);
}

// Sorts pairs, and removes those that are there twice.
void Reduce(std::vector<BeyondCorners::Pair>& pairs)
{
  using Pair = BeyondCorners::Pair;
  const auto get = [](const Pair& pair) { return std::make_pair(pair.Reached, pair.Other); };
  std::sort(
    pairs.begin(), pairs.end(), [&get](const Pair& a, const Pair& b) { return get(a) < get(b); });
  pairs.erase(std::unique(pairs.begin(), pairs.end(),
                [&get](const Pair& a, const Pair& b) { return get(a) == get(b); }),
    pairs.end());
}
}

std::vector<BeyondCorners::Corner> BeyondCorners::Find(vtkDataSet* samples,
  const ImplicitFlowArrays& arrays, const AdvectionOptions& options, std::vector<Pair>* pairs)
{
  const vtkIdType cells = options.Surfaces.empty() && !pairs ? 0 : samples->GetNumberOfCells();
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPThreadLocal<std::vector<Corner>> threads;
  vtkSMPThreadLocal<std::vector<Pair>> pairsOfThreads;
  if (cells > 0)
  {
    // Makes the data that the dataset makes at the first call, before threads need them.
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
    Reduce(*pairs);
  }
  return found;
}

}
