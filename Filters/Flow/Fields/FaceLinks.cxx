// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/FaceLinks.h"

#include "Cells/FaceExtent.h"
#include "Common/ParallelFor.h"
#include "Common/Vectors.h"
#include "Fields/FaceRotation.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
using FillBlock = FaceLinks::FillBlock;
using CellPoints = FaceLinks::CellPoints;
using SetLink = FaceLinks::SetLink;

// A face, its rotation relative to the canonical order, and its points in canonical order except
// the first.
template <typename Id>
struct Entry
{
  std::array<Id, 3> Points;
  FaceRotation Rotation;
  vtkIdType Face;
  bool operator<(const Entry& other) const { return this->Points < other.Points; }
};

template <typename Visitor>
void ForEachFace(
  vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill, Visitor&& visit)
{
  vtkSMPTools::For(0, numberOfBlocks,
    [&](vtkIdType first, vtkIdType last)
    {
      FaceLinks::Block block;
      for (vtkIdType number = first; number < last; ++number)
      {
        fill(number, block);
        for (int i = 0; i < facesPerBlock; ++i)
        {
          if (block.Corners[i] > 0)
          {
            visit(number * facesPerBlock + i, block.Points[i], block.Corners[i]);
          }
        }
      }
    });
}

template <typename Id>
void SetLinks(Entry<Id>* begin, Entry<Id>* end, const SetLink& setLink)
{
  std::sort(begin, end);
  for (const Entry<Id>* entry = begin; entry < end;)
  {
    const Entry<Id>* next = entry + 1;
    while (next < end && next->Points == entry->Points)
    {
      ++next;
    }
    if (next == entry + 2)
    {
      const Entry<Id>& other = entry[1];
      setLink(entry->Face, FaceRotation::GetLink(entry->Rotation, other.Rotation, other.Face));
      setLink(other.Face, FaceRotation::GetLink(other.Rotation, entry->Rotation, entry->Face));
    }
    entry = next;
  }
}

// Faces are grouped by their smallest point id and compared within each group.
template <typename Id>
void Match(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  vtkIdType numberOfPoints, const SetLink& setLink)
{
  std::vector<std::atomic<vtkIdType>> ends(numberOfPoints + 1);
  ForEachFace(numberOfBlocks, facesPerBlock, fill,
    [&](vtkIdType, const vtkIdType* points, int corners)
    {
      const vtkIdType smallest = *std::min_element(points, points + corners);
      ends[smallest + 1].fetch_add(1, std::memory_order_relaxed);
    });
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    ends[point + 1] += ends[point];
  }
  // ends[point] is the start of the group of this point before the group is filled, and its end
  // afterward.
  std::vector<Entry<Id>> entries(ends[numberOfPoints]);
  ForEachFace(numberOfBlocks, facesPerBlock, fill,
    [&](vtkIdType face, const vtkIdType* points, int corners)
    {
      Entry<Id> entry;
      vtkIdType ordered[4];
      entry.Rotation = FaceRotation::Order(points, corners, ordered);
      entry.Face = face;
      for (int i = 0; i < 3; ++i)
      {
        entry.Points[i] = i + 1 < corners ? static_cast<Id>(ordered[i + 1]) : Id(-1);
      }
      entries[ends[ordered[0]].fetch_add(1, std::memory_order_relaxed)] = entry;
    });
  ParallelFor(0, numberOfPoints,
    [&](vtkIdType point)
    {
      const vtkIdType begin = point > 0 ? ends[point - 1].load() : 0;
      SetLinks(entries.data() + begin, entries.data() + ends[point], setLink);
    });
}

struct FaceLocation
{
  /// Projection of Center onto a line that is not aligned with typical grids. Sorting by it brings
  /// coincident faces close together.
  double Along;
  double Center[3];
  double Width;
  double Tolerance;
  vtkIdType Face;

  bool operator<(const FaceLocation& other) const
  {
    return this->Along < other.Along || (this->Along == other.Along && this->Face < other.Face);
  }
};

/// Match of a face: another face with the same corners.
struct Partner
{
  vtkIdType Index = -1;
  FaceLinks::Link Link = { -1, 0, false };
  double Gap = 0.0;
};

/// Matches faces by the coordinates of their corners.
class CoordinateMatch
{
public:
  CoordinateMatch(
    vtkIdType number, const FillBlock& fill, const CellPoints& cells, const ArrayRows& positions)
    : Fill(fill)
    , Cells(cells)
    , Positions(positions)
    , Locations(number)
  {
    ParallelFor(0, number, [this](vtkIdType face) { this->SetLocation(face); });
    vtkSMPTools::Sort(this->Locations.begin(), this->Locations.end());
  }

  FaceLinks::MatchGaps SetLinks(const SetLink& setLink) const
  {
    const auto number = static_cast<vtkIdType>(this->Locations.size());
    std::vector<Partner> partners(number);
    ParallelFor(0, number, [&](vtkIdType i) { partners[i] = this->FindPartner(i); });
    FaceLinks::MatchGaps gaps;
    for (vtkIdType i = 0; i < number; ++i)
    {
      const Partner& partner = partners[i];
      if (partner.Index >= 0 && partners[partner.Index].Index == i)
      {
        FaceLinks::Link link = partner.Link;
        if (partner.Gap > 0.0)
        {
          link.Gap =
            partner.Gap / std::min(this->Locations[i].Width, this->Locations[partner.Index].Width);
          gaps.Number += partner.Index > i ? 1 : 0;
          gaps.LargestGap = std::max(gaps.LargestGap, link.Gap);
        }
        setLink(this->Locations[i].Face, link);
      }
    }
    return gaps;
  }

private:
  int GetCorners(vtkIdType face, double (*corners)[3]) const
  {
    FaceLinks::Block block;
    this->Fill(face, block);
    for (int i = 0; i < block.Corners[0]; ++i)
    {
      this->Positions.Get<3>(block.Points[0][i], corners[i]);
    }
    return block.Corners[0];
  }

  void SetLocation(vtkIdType face)
  {
    constexpr double line[3] = { 0.5345224838248488, 0.6480740698407860, 0.5424859237103562 };
    double corners[4][3];
    const int number = this->GetCorners(face, corners);
    FaceLocation& location = this->Locations[face];
    location.Face = face;
    location.Along = 0.0;
    vtkIdType points[8];
    double cell[8][3];
    const int size = this->Cells(face, points);
    for (int i = 0; i < size; ++i)
    {
      this->Positions.Get<3>(points[i], cell[i]);
    }
    location.Width = FaceExtent::Of(corners, number, cell, size).Width;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      double lower = corners[0][axis];
      double upper = lower;
      for (int i = 1; i < number; ++i)
      {
        lower = std::min(lower, corners[i][axis]);
        upper = std::max(upper, corners[i][axis]);
      }
      largest = std::max({ largest, -lower, upper });
      // The midpoint of the bounds does not depend on the order of the corners.
      location.Center[axis] = 0.5 * lower + 0.5 * upper;
      location.Along += line[axis] * location.Center[axis];
    }
    location.Tolerance =
      FaceLinks::GetTolerance(location.Width, largest, this->Positions.GetRoundingError(largest));
  }

  /// Finds the other face with the same corners, if there is exactly one.
  Partner FindPartner(vtkIdType i) const
  {
    double own[4][3];
    const int number = this->GetCorners(this->Locations[i].Face, own);
    Partner found;
    bool isOnly = true;
    const auto compare = [&](vtkIdType j)
    {
      const FaceLocation& location = this->Locations[i];
      const FaceLocation& other = this->Locations[j];
      const double tolerance = std::min(location.Tolerance, other.Tolerance);
      for (int axis = 0; axis < 3; ++axis)
      {
        if (std::abs(location.Center[axis] - other.Center[axis]) > tolerance)
        {
          return;
        }
      }
      double corners[4][3];
      Partner candidate;
      candidate.Index = j;
      if (this->GetCorners(other.Face, corners) == number)
      {
        candidate.Gap = std::numeric_limits<double>::infinity();
        // Faces of adjacent cells have opposite corner orders unless a cell is inverted.
        for (const bool isReversed : { true, false })
        {
          for (int start = 0; start < number; ++start)
          {
            const double gap = GetGap(own, corners, number, start, isReversed);
            if (gap < candidate.Gap)
            {
              candidate.Gap = gap;
              candidate.Link = { other.Face, start, isReversed };
            }
          }
        }
        if (candidate.Gap <= tolerance)
        {
          isOnly = found.Index < 0;
          found = candidate;
        }
      }
    };
    const auto last = static_cast<vtkIdType>(this->Locations.size());
    const double reach = 2.0 * this->Locations[i].Tolerance;
    for (vtkIdType j = i + 1;
         j < last && this->Locations[j].Along - this->Locations[i].Along <= reach; ++j)
    {
      compare(j);
    }
    for (vtkIdType j = i - 1;
         j >= 0 && this->Locations[i].Along - this->Locations[j].Along <= reach; --j)
    {
      compare(j);
    }
    return isOnly ? found : Partner();
  }

  static double GetGap(
    const double (*own)[3], const double (*other)[3], int number, int start, bool isReversed)
  {
    double gap = 0.0;
    for (int i = 0; i < number; ++i)
    {
      const int corner = (start + (isReversed ? number - i : i)) % number;
      gap = std::max(gap, Vectors::SafeLength(Vectors::Difference(other[i], own[corner])));
    }
    return gap;
  }

  const FillBlock& Fill;
  const CellPoints& Cells;
  const ArrayRows& Positions;
  std::vector<FaceLocation> Locations;
};

}

void FaceLinks::FindByPoints(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  vtkIdType numberOfPoints, const SetLink& setLink)
{
  constexpr vtkIdType maximumNumber = 0x7fffffff;
  auto* match = numberOfPoints < maximumNumber ? &Match<unsigned int> : &Match<vtkIdType>;
  match(numberOfBlocks, facesPerBlock, fill, numberOfPoints, setLink);
}

FaceLinks::MatchGaps FaceLinks::Find(vtkIdType numberOfBlocks, int facesPerBlock,
  const FillBlock& fill, const CellPoints& cells, const ArrayRows& positions,
  const SetLink& setLink)
{
  std::vector<unsigned char> isLinked(numberOfBlocks * facesPerBlock, 0);
  FindByPoints(numberOfBlocks, facesPerBlock, fill, positions.GetNumber(),
    [&](vtkIdType face, const Link& link)
    {
      isLinked[face] = 1;
      setLink(face, link);
    });
  // Collects the unmatched faces separately for each part, to preserve their order.
  constexpr vtkIdType part = 4096;
  std::vector<std::vector<vtkIdType>> singles((numberOfBlocks + part - 1) / part);
  vtkSMPTools::For(0, static_cast<vtkIdType>(singles.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      Block block;
      for (vtkIdType number = first * part; number < std::min(last * part, numberOfBlocks);
           ++number)
      {
        const unsigned char* known = isLinked.data() + number * facesPerBlock;
        if (std::find(known, known + facesPerBlock, 0) == known + facesPerBlock)
        {
          continue;
        }
        fill(number, block);
        for (int i = 0; i < facesPerBlock; ++i)
        {
          if (!known[i] && block.Corners[i] > 0)
          {
            singles[number / part].push_back(number * facesPerBlock + i);
          }
        }
      }
    });
  std::vector<vtkIdType> single;
  for (const std::vector<vtkIdType>& some : singles)
  {
    single.insert(single.end(), some.begin(), some.end());
  }
  const auto fillSingle = [&](vtkIdType i, Block& one)
  {
    Block all;
    fill(single[i] / facesPerBlock, all);
    const vtkIdType face = single[i] % facesPerBlock;
    one.Corners[0] = all.Corners[face];
    std::copy(all.Points[face], all.Points[face] + 4, one.Points[0]);
  };
  const FillBlock fillOne = fillSingle;
  const CellPoints cellsOfOne = [&](vtkIdType i, vtkIdType* points)
  { return cells(single[i], points); };
  const CoordinateMatch match(
    static_cast<vtkIdType>(single.size()), fillOne, cellsOfOne, positions);
  return match.SetLinks(
    [&](vtkIdType i, const Link& link) {
      setLink(single[i], { single[link.Face], link.Start, link.IsReversed, link.Gap });
    });
}

}
