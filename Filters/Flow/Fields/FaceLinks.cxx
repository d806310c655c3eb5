// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/FaceLinks.h"

#include "Cells/FaceExtent.h"
#include "Common/Vectors.h"
#include "Fields/FaceTurn.h"

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

// The entry of a face at its least point: the points after it, which all that are the same face
// have in the same order, the face, and how its own order is to that order.
template <typename Id>
struct Entry
{
  std::array<Id, 3> Points;
  FaceTurn Turn;
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
      setLink(entry->Face, FaceTurn::GetLink(entry->Turn, other.Turn, other.Face));
      setLink(other.Face, FaceTurn::GetLink(other.Turn, entry->Turn, entry->Face));
    }
    entry = next;
  }
}

// Faces are gathered at the least of their points, and compared there.
template <typename Id>
void Match(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  vtkIdType numberOfPoints, const SetLink& setLink)
{
  std::vector<std::atomic<vtkIdType>> ends(numberOfPoints + 1);
  ForEachFace(numberOfBlocks, facesPerBlock, fill,
    [&](vtkIdType, const vtkIdType* points, int corners)
    {
      const vtkIdType least = *std::min_element(points, points + corners);
      ends[least + 1].fetch_add(1, std::memory_order_relaxed);
    });
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    ends[point + 1] += ends[point];
  }
  // Filling moves each point's begin to its end.
  std::vector<Entry<Id>> entries(ends[numberOfPoints]);
  ForEachFace(numberOfBlocks, facesPerBlock, fill,
    [&](vtkIdType face, const vtkIdType* points, int corners)
    {
      Entry<Id> entry;
      vtkIdType ordered[4];
      entry.Turn = FaceTurn::Order(points, corners, ordered);
      entry.Face = face;
      for (int i = 0; i < 3; ++i)
      {
        entry.Points[i] = i + 1 < corners ? static_cast<Id>(ordered[i + 1]) : Id(-1);
      }
      entries[ends[ordered[0]].fetch_add(1, std::memory_order_relaxed)] = entry;
    });
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        const vtkIdType begin = point > 0 ? ends[point - 1].load() : 0;
        SetLinks(entries.data() + begin, entries.data() + ends[point], setLink);
      }
    });
}

/// The place of a face, by its coordinates.
struct Place
{
  /// The position along a line that is askew to grids, on which faces in the same place are beside
  /// each other.
  double Along;
  double Middle[3];
  double Width;
  double Tolerance;
  vtkIdType Face;

  bool operator<(const Place& other) const
  {
    return this->Along < other.Along || (this->Along == other.Along && this->Face < other.Face);
  }
};

/// Another face with the same corners.
struct Partner
{
  vtkIdType Place = -1;
  FaceLinks::Link Link = { -1, 0, false };
  double Gap = 0.0;
};

/// Matches faces, one to a block, by the coordinates of their corners.
class CoordinateMatch
{
public:
  CoordinateMatch(
    vtkIdType number, const FillBlock& fill, const CellPoints& cells, const ArrayRows& positions)
    : Fill(fill)
    , Cells(cells)
    , Positions(positions)
    , Places(number)
  {
    vtkSMPTools::For(0, number,
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType face = first; face < last; ++face)
        {
          this->SetPlace(face);
        }
      });
    vtkSMPTools::Sort(this->Places.begin(), this->Places.end());
  }

  FaceLinks::Joins SetLinks(const SetLink& setLink) const
  {
    const auto number = static_cast<vtkIdType>(this->Places.size());
    std::vector<Partner> partners(number);
    vtkSMPTools::For(0, number,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          partners[i] = this->FindPartner(i);
        }
      });
    FaceLinks::Joins joins;
    for (vtkIdType i = 0; i < number; ++i)
    {
      const Partner& partner = partners[i];
      if (partner.Place >= 0 && partners[partner.Place].Place == i)
      {
        FaceLinks::Link link = partner.Link;
        if (partner.Gap > 0.0)
        {
          link.Gap =
            partner.Gap / std::min(this->Places[i].Width, this->Places[partner.Place].Width);
          joins.Number += partner.Place > i ? 1 : 0;
          joins.LargestGap = std::max(joins.LargestGap, link.Gap);
        }
        setLink(this->Places[i].Face, link);
      }
    }
    return joins;
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

  void SetPlace(vtkIdType face)
  {
    constexpr double line[3] = { 0.5345224838248488, 0.6480740698407860, 0.5424859237103562 };
    double corners[4][3];
    const int number = this->GetCorners(face, corners);
    Place& place = this->Places[face];
    place.Face = face;
    place.Along = 0.0;
    vtkIdType points[8];
    double cell[8][3];
    const int size = this->Cells(face, points);
    for (int i = 0; i < size; ++i)
    {
      this->Positions.Get<3>(points[i], cell[i]);
    }
    place.Width = FaceExtent::Of(corners, number, cell, size).Width;
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
      // The middle is the same for the same corners in any order.
      place.Middle[axis] = 0.5 * lower + 0.5 * upper;
      place.Along += line[axis] * place.Middle[axis];
    }
    place.Tolerance =
      FaceLinks::GetTolerance(place.Width, largest, this->Positions.GetRounding(largest));
  }

  /// Finds the only other face with the same corners.
  Partner FindPartner(vtkIdType i) const
  {
    double own[4][3];
    const int number = this->GetCorners(this->Places[i].Face, own);
    Partner found;
    bool isOnly = true;
    const auto look = [&](vtkIdType j)
    {
      const Place& place = this->Places[i];
      const Place& other = this->Places[j];
      const double tolerance = std::min(place.Tolerance, other.Tolerance);
      for (int axis = 0; axis < 3; ++axis)
      {
        if (std::abs(place.Middle[axis] - other.Middle[axis]) > tolerance)
        {
          return;
        }
      }
      double corners[4][3];
      Partner candidate;
      candidate.Place = j;
      if (this->GetCorners(other.Face, corners) == number)
      {
        candidate.Gap = std::numeric_limits<double>::infinity();
        // Neighbors have their corners in opposite order, but for cells turned inside out.
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
          isOnly = found.Place < 0;
          found = candidate;
        }
      }
    };
    const auto last = static_cast<vtkIdType>(this->Places.size());
    const double reach = 2.0 * this->Places[i].Tolerance;
    for (vtkIdType j = i + 1; j < last && this->Places[j].Along - this->Places[i].Along <= reach;
         ++j)
    {
      look(j);
    }
    for (vtkIdType j = i - 1; j >= 0 && this->Places[i].Along - this->Places[j].Along <= reach; --j)
    {
      look(j);
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
  std::vector<Place> Places;
};

}

void FaceLinks::FindByPoints(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  vtkIdType numberOfPoints, const SetLink& setLink)
{
  constexpr vtkIdType most = 0x7fffffff;
  auto* match = numberOfPoints < most ? &Match<unsigned int> : &Match<vtkIdType>;
  match(numberOfBlocks, facesPerBlock, fill, numberOfPoints, setLink);
}

FaceLinks::Joins FaceLinks::Find(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  const CellPoints& cells, const ArrayRows& positions, const SetLink& setLink)
{
  std::vector<unsigned char> isLinked(numberOfBlocks * facesPerBlock, 0);
  FindByPoints(numberOfBlocks, facesPerBlock, fill, positions.GetNumber(),
    [&](vtkIdType face, const Link& link)
    {
      isLinked[face] = 1;
      setLink(face, link);
    });
  // By parts, so that the faces come in their order.
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
