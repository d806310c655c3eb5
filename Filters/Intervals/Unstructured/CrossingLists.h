// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CrossingLists_h
#define interlume_CrossingLists_h

#include "Common/Prefetch.h"
#include "Common/ThreadLocals.h"
#include "Output/CrossingKey.h"
#include "Output/ExtractionBuffer.h"
#include "Pass/ExtractionContext.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace interlume
{

class ExtractionScalars;

/**
 * @class   CrossingLists
 * @brief   lists of output points per owning grid point, without duplicates
 *
 * Of the two ends of a crossed edge, the end with the lower id owns the crossing. A grid point that
 * is itself an output point is the first point in its own list. Any number of threads may enter
 * points. Each list is a linked list that grows only at its head, by compare-and-swap, so no point
 * is entered twice. MakePoints() sorts the lists and numbers all points in the order of their
 * owners. The numbers are therefore independent of the thread schedule.
 */
class CrossingLists
{
public:
  class Arena;

  /// An entered point.
  struct Node
  {
    CrossingKey Key;
    union
    {
      Node* Next;
      /// Id of the point after MakePoints(), if nodes are kept.
      vtkIdType Id;
    };
  };

  /// Creates an empty list for each of \a owners grid points. If \a keepNodes is true, nodes remain
  /// valid as long as the lists exist. Otherwise they are freed when the points are numbered.
  /// GetId() works in both cases.
  CrossingLists(vtkIdType owners, bool keepNodes);
  ~CrossingLists();

  /// Returns the arena that allocates the nodes of the calling thread.
  Arena& GetArena() { return this->Arenas.Local(); }

  /// Enters a point in the list of its owner. The default key represents the owner itself.
  const Node* Enter(vtkIdType owner, CrossingKey key, Arena& arena)
  {
    Node* const head = this->Heads[owner].First.load(std::memory_order_acquire);
    for (const Node* node = head; node; node = node->Next)
    {
      if (node->Key == key)
      {
        return node;
      }
    }
    return this->Add(owner, key, head, arena);
  }

  /// Prefetches the list of an owner that will be needed soon.
  void Prefetch(vtkIdType owner) const { interlume::Prefetch::Read(&this->Heads[owner]); }

  /// Numbers the points and computes their edges and weights. Do not enter points afterward.
  void MakePoints(const ExtractionScalars& scalars, ExtractionBuffer<ExtractionPoint>& points);

  /// Returns the id of an entered point.
  vtkIdType GetId(vtkIdType owner, CrossingKey key) const
  {
    vtkIdType id = this->Heads[owner].FirstId;
    while (this->Keys[id] != key)
    {
      ++id;
    }
    return id;
  }

  /// Returns the key of a numbered point.
  CrossingKey GetKey(vtkIdType id) const { return this->Keys[id]; }

  /// Returns the peak size of the lists in bytes.
  std::size_t GetBytes() const { return this->Bytes; }

private:
  // The linked list of an owner, or the id of its first point once the points are numbered.
  union Head
  {
    std::atomic<Node*> First;
    vtkIdType FirstId;
  };

public:
  class Arena
  {
  public:
    Node* New()
    {
      if (this->Used == BlockSize)
      {
        this->Blocks.emplace_back(BlockSize);
        this->Used = 0;
      }
      return &this->Blocks.back()[this->Used++];
    }
    void ReleaseLast() { --this->Used; }
    std::size_t GetBytes() const { return this->Blocks.size() * BlockSize * sizeof(Node); }
    void Free() { std::vector<std::vector<Node>>().swap(this->Blocks); }

  private:
    static constexpr std::size_t BlockSize = 2048;
    std::vector<std::vector<Node>> Blocks;
    std::size_t Used = BlockSize;
  };

private:
  const Node* Add(vtkIdType owner, CrossingKey key, Node* head, Arena& arena);
  // Finds the owners in a block, in ascending order. Returns their number.
  int FindOwners(vtkIdType block, vtkIdType* found) const;
  // Numbers the points of an owner, starting with \a id. Returns the next free id.
  vtkIdType NumberList(vtkIdType owner, vtkIdType id, ExtractionBuffer<ExtractionPoint>& points);

  bool KeepNodes;
  ExtractionBuffer<Head> Heads;
  // One bit per grid point, set if the grid point owns a point.
  std::vector<std::atomic<std::uint64_t>> Owners;
  // Number of points owned by the grid points of each block.
  std::vector<std::atomic<vtkIdType>> Counts;
  ExtractionBuffer<CrossingKey> Keys;
  ThreadLocals<Arena> Arenas;
  std::size_t Bytes = 0;
};

}

#endif
