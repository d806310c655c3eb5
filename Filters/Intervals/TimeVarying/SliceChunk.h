// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceChunk_h
#define interlume_SliceChunk_h

#include "Static/CrossingLists.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   SliceChunk
 * @brief   the tetrahedra that some 4-simplices have in a slice, before points have their ids
 *
 * Points go by 16 bits, as the places of their nodes in the chunk, and so do the cells: what is
 * kept from the counting to the writing of a slice is less than what is written.
 */
struct SliceChunk
{
  /// The most cells of a chunk: each has at most six points.
  static constexpr vtkIdType Size = 4096;
  static_assert(6 * Size <= 1 << 16, "points of a chunk have numbers of 16 bits");

  struct Tetrahedron
  {
    std::array<std::uint16_t, 4> Points;
    /// The place of the cell, counted from the chunk's first.
    std::uint16_t Cell;
  };

  std::vector<const CrossingLists::Node*> Nodes;
  /// In the order of the cells.
  std::vector<Tetrahedron> Tetrahedra;
};

/**
 * @class   SliceChunkBuilder
 * @brief   what one thread needs to fill chunks: room, and the points that it met last
 *
 * 4-simplices in a row have most of their points in common, so that few of them are looked for in
 * the lists. A point that was forgotten meanwhile has a second place in the chunk, to no effect.
 */
class SliceChunkBuilder
{
public:
  SliceChunkBuilder()
    : Entries(std::size_t(1) << EntryBits)
  {
  }

  void Begin()
  {
    this->Entries.assign(this->Entries.size(), Entry());
    this->Made.Nodes.clear();
    this->Made.Tetrahedra.clear();
  }

  /// Returns the place of a point in the chunk.
  std::uint16_t Find(
    vtkIdType owner, CrossingKey key, CrossingLists& lists, CrossingLists::Arena& arena)
  {
    const std::uint64_t hash = static_cast<std::uint64_t>(owner + key.GetFar() * 0x2c9277b5);
    Entry& entry = this->Entries[(hash * 0x9e3779b97f4a7c15) >> (64 - EntryBits)];
    if (entry.Owner != owner || entry.Key != key)
    {
      entry = { owner, key, static_cast<std::uint16_t>(this->Made.Nodes.size()) };
      this->Made.Nodes.push_back(lists.Enter(owner, key, arena));
    }
    return entry.Place;
  }

  void Add(const SliceChunk::Tetrahedron& tetrahedron)
  {
    this->Made.Tetrahedra.push_back(tetrahedron);
  }
  std::size_t GetNumberOfTetrahedra() const { return this->Made.Tetrahedra.size(); }

  /// Returns the chunk, without the room for more.
  SliceChunk Finish() const { return this->Made; }

private:
  static constexpr int EntryBits = 10;

  struct Entry
  {
    vtkIdType Owner = -1;
    CrossingKey Key;
    std::uint16_t Place = 0;
  };

  std::vector<Entry> Entries;
  SliceChunk Made;
};

}

#endif
