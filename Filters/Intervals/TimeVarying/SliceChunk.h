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
 * @brief   slice tetrahedra of a chunk of 4-simplices, before their points have ids
 *
 * Points and cells are stored as 16-bit indices within the chunk. The data is therefore smaller
 * than the output.
 */
struct SliceChunk
{
  /// Maximum number of cells in a chunk. The slice of a cell has at most six points.
  static constexpr vtkIdType Size = 4096;
  static_assert(6 * Size <= 1 << 16, "point indices within a chunk have 16 bits");

  struct Tetrahedron
  {
    std::array<std::uint16_t, 4> Points;
    /// Index of the cell in the chunk.
    std::uint16_t Cell;
  };

  std::vector<const CrossingLists::Node*> Nodes;
  /// The tetrahedra, in the order of their cells.
  std::vector<Tetrahedron> Tetrahedra;
};

/**
 * @class   SliceChunkBuilder
 * @brief   buffers with which a thread fills chunks, and a cache of recent points
 *
 * Consecutive 4-simplices share most of their points, so the cache avoids most searches in the
 * CrossingLists. A point that was evicted from the cache and is found again gets a second index in
 * the chunk, which is harmless. \a Id is the type of the grid's point ids.
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

  /// Returns the index of a point in the chunk. Adds the point if it is not in the cache.
  std::uint16_t Find(
    vtkIdType owner, CrossingKey key, CrossingLists& lists, CrossingLists::Arena& arena)
  {
    // The far end alone identifies the key: all keys have isovalue index 0, and only the key of the
    // owner itself has far end 0.
    const Id near = static_cast<Id>(owner);
    const Id far = static_cast<Id>(key.GetFar());
    const std::uint64_t hash = static_cast<std::uint64_t>(owner + key.GetFar() * 0x2c9277b5);
    Entry& entry = this->Entries[(hash * 0x9e3779b97f4a7c15) >> (64 - EntryBits)];
    if (entry.Owner != near || entry.Far != far)
    {
      entry = { near, far, static_cast<std::uint16_t>(this->Nodes.size()) };
      this->Nodes.push_back(lists.Enter(owner, key, arena));
    }
    return entry.Index;
  }

  /// Adds a tetrahedron. The slice of a cell has at most three.
  void Add(const SliceChunk::Tetrahedron& tetrahedron)
  {
    this->Tetrahedra[this->NumberOfTetrahedra++] = tetrahedron;
  }
  std::size_t GetNumberOfTetrahedra() const { return this->NumberOfTetrahedra; }

  /// Copies the results to a chunk, without unused capacity.
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
    std::uint16_t Index = 0;
  };

  std::vector<Entry> Entries;
  std::vector<const CrossingLists::Node*> Nodes;
  std::vector<SliceChunk::Tetrahedron> Tetrahedra;
  std::size_t NumberOfTetrahedra = 0;
};

}

#endif
