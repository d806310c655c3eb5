#include "vtkFaceLinks.h"

#include "vtkFaceTurn.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace
{
using FillBlock = vtkFaceLinks::FillBlock;
using SetLink = vtkFaceLinks::SetLink;

// What else a face has than its least point: the points after it, which all that are the same face
// have in the same order, the face, and how its own order is to that.
template <typename Id>
struct Entry
{
  std::array<Id, 3> Points;
  vtkFaceTurn Turn;
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
      vtkFaceLinks::Block block;
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
      setLink(entry->Face, vtkFaceTurn::GetLink(entry->Turn, other.Turn, other.Face));
      setLink(other.Face, vtkFaceTurn::GetLink(other.Turn, entry->Turn, entry->Face));
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
      entry.Turn = vtkFaceTurn::Order(points, corners, ordered);
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

void MatchAny(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  vtkIdType numberOfPoints, const SetLink& setLink)
{
  constexpr vtkIdType most = 0x7fffffff;
  auto* match = numberOfPoints < most ? &Match<unsigned int> : &Match<vtkIdType>;
  match(numberOfBlocks, facesPerBlock, fill, numberOfPoints, setLink);
}

// Each point's first one at its coordinates, of the points of these blocks of one face.
bool FindCoincident(vtkIdType number, const FillBlock& fill, const vtkFlowValues& positions,
  std::vector<vtkIdType>& firsts)
{
  std::vector<vtkIdType> ids;
  vtkFaceLinks::Block block;
  for (vtkIdType i = 0; i < number; ++i)
  {
    fill(i, block);
    ids.insert(ids.end(), block.Points[0], block.Points[0] + block.Corners[0]);
  }
  vtkSMPTools::Sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  using Place = std::pair<std::array<double, 3>, vtkIdType>;
  std::vector<Place> places(ids.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        positions.Get<3>(ids[i], places[i].first.data());
        places[i].second = ids[i];
      }
    });
  vtkSMPTools::Sort(places.begin(), places.end());
  const auto isSame = [](const Place& a, const Place& b) { return a.first == b.first; };
  if (std::adjacent_find(places.begin(), places.end(), isSame) == places.end())
  {
    return false;
  }
  firsts.resize(positions.GetNumber());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const bool isRepeated = i > 0 && isSame(places[i - 1], places[i]);
    firsts[places[i].second] = isRepeated ? firsts[places[i - 1].second] : places[i].second;
  }
  return true;
}

}

//------------------------------------------------------------------------------
void vtkFaceLinks::Find(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
  const vtkFlowValues& positions, const SetLink& setLink)
{
  std::vector<unsigned char> isLinked(numberOfBlocks * facesPerBlock, 0);
  MatchAny(numberOfBlocks, facesPerBlock, fill, positions.GetNumber(),
    [&](vtkIdType face, const Link& link)
    {
      isLinked[face] = 1;
      setLink(face, link);
    });
  std::vector<vtkIdType> single;
  Block block;
  for (vtkIdType number = 0; number < numberOfBlocks; ++number)
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
        single.push_back(number * facesPerBlock + i);
      }
    }
  }
  const auto fillSingle = [&](vtkIdType i, Block& one)
  {
    Block all;
    fill(single[i] / facesPerBlock, all);
    const vtkIdType face = single[i] % facesPerBlock;
    one.Corners[0] = all.Corners[face];
    std::copy(all.Points[face], all.Points[face] + 4, one.Points[0]);
  };
  const auto number = static_cast<vtkIdType>(single.size());
  std::vector<vtkIdType> firsts;
  if (!FindCoincident(number, fillSingle, positions, firsts))
  {
    return;
  }
  MatchAny(
    number, 1,
    [&](vtkIdType i, Block& one)
    {
      fillSingle(i, one);
      std::transform(one.Points[0], one.Points[0] + one.Corners[0], one.Points[0],
        [&](vtkIdType id) { return firsts[id]; });
    },
    positions.GetNumber(),
    [&](vtkIdType i, const Link& link) {
      setLink(single[i], { single[link.Face], link.Start, link.IsReversed });
    });
}
