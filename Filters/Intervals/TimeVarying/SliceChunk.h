// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceChunk_h
#define interlume_SliceChunk_h

#include "Unstructured/CrossingLists.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstddef>
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
 * the lists. A point that was forgotten meanwhile has a second place in the chunk, to no effect. \a
 * Id is the type of the grid's point ids.
 */
template <typename Id>
class SliceChunkBuilder
{
public:
  SliceChunkBuilder()
    : Entries(std::size_t(1) << EntryBits)
    , Tetrahedra(MaximumNumberOfTetrahedra)
  {
  }

  void Begin()
  {
    std::fill(this->Entries.begin(), this->Entries.end(), Entry());
    this->Nodes.clear();
    this->NumberOfTetrahedra = 0;
  }

  /// Returns the place of a point in the chunk.
  std::uint16_t Find(
    vtkIdType owner, CrossingKey key, CrossingLists& lists, CrossingLists::Arena& arena)
  {
    // No edge goes to point 0, which is its own owner: the far end tells one key from another.
    const Id near = static_cast<Id>(owner);
    const Id far = static_cast<Id>(key.GetFar());
    const std::uint64_t hash = static_cast<std::uint64_t>(owner + key.GetFar() * 0x2c9277b5);
    Entry& entry = this->Entries[(hash * 0x9e3779b97f4a7c15) >> (64 - EntryBits)];
    if (entry.Owner != near || entry.Far != far)
    {
      entry = { near, far, static_cast<std::uint16_t>(this->Nodes.size()) };
      this->Nodes.push_back(lists.Enter(owner, key, arena));
    }
    return entry.Place;
  }

  /// Adds a tetrahedron; a cell has at most three.
  void Add(const SliceChunk::Tetrahedron& tetrahedron)
  {
    this->Tetrahedra[this->NumberOfTetrahedra++] = tetrahedron;
  }
  std::size_t GetNumberOfTetrahedra() const { return this->NumberOfTetrahedra; }

  /// Gives a chunk what was made, without the room for more.
  void Finish(SliceChunk& chunk) const
  {
    const auto begin = this->Tetrahedra.begin();
    chunk.Nodes = this->Nodes;
    chunk.Tetrahedra.assign(begin, begin + static_cast<std::ptrdiff_t>(this->NumberOfTetrahedra));
  }

private:
  static constexpr int EntryBits = 10;
  static constexpr std::size_t MaximumNumberOfTetrahedra = 3 * SliceChunk::Size;

  struct Entry
  {
    Id Owner = -1;
    Id Far = 0;
    std::uint16_t Place = 0;
  };

  std::vector<Entry> Entries;
  std::vector<const CrossingLists::Node*> Nodes;
  std::vector<SliceChunk::Tetrahedron> Tetrahedra;
  std::size_t NumberOfTetrahedra = 0;
};

}

#endif
