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
 * @brief   the points of an extraction, each once, in lists of the grid points that own them
 *
 * A crossed edge belongs to the lower of its two points; a grid point that is itself in the output
 * is its own first. Any number of threads may enter points; each list is a chain that only grows,
 * at its head, by a compare-and-swap, so that no point is ever in it twice. MakePoints sorts the
 * lists and numbers all points in the order of their owners: the numbers do not depend on who
 * entered what when.
 */
class CrossingLists
{
public:
  class Arena;

  /// A point that was entered.
  struct Node
  {
    CrossingKey Key;
    union
    {
      Node* Next;
      /// The number of the point, after MakePoints, where nodes are kept.
      vtkIdType Id;
    };
  };

  /// Begins with an empty list for each of \a owners grid points. Nodes are kept for as long as the
  /// lists, or until they are numbered: then GetId still finds them.
  CrossingLists(vtkIdType owners, bool keepNodes);
  ~CrossingLists();

  /// Returns the memory in which the calling thread keeps what it enters.
  Arena& GetArena() { return this->Arenas.Local(); }

  /// Enters a point; the key of a grid point's own is the default one.
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

  /// Prefetches a list that will be asked for soon.
  void Prefetch(vtkIdType owner) const { interlume::Prefetch::Read(&this->Heads[owner]); }

  /// Numbers the points and tells what they are made of. Nothing may be entered afterwards.
  void MakePoints(const ExtractionScalars& scalars, ExtractionBuffer<ExtractionPoint>& points);

  /// Returns the number of a point that was entered.
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

  /// Returns how many bytes the lists held at most.
  std::size_t GetBytes() const { return this->Bytes; }

private:
  // The chain of an owner; once points are numbered, the number of its first point.
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
    void GiveBackLast() { --this->Used; }
    std::size_t GetBytes() const { return this->Blocks.size() * BlockSize * sizeof(Node); }
    void Free() { std::vector<std::vector<Node>>().swap(this->Blocks); }

  private:
    static constexpr std::size_t BlockSize = 2048;
    std::vector<std::vector<Node>> Blocks;
    std::size_t Used = BlockSize;
  };

private:
  const Node* Add(vtkIdType owner, CrossingKey key, Node* head, Arena& arena);
  // Finds the owners of a block, in ascending order; returns their number.
  int FindOwners(vtkIdType block, vtkIdType* found) const;
  // Numbers the points of an owner from id on, and returns the next number.
  vtkIdType NumberList(vtkIdType owner, vtkIdType id, ExtractionBuffer<ExtractionPoint>& points);

  bool KeepNodes;
  ExtractionBuffer<Head> Heads;
  // A bit for each grid point, set where it owns any point.
  std::vector<std::atomic<std::uint64_t>> Owners;
  // The number of points that the owners of a block have.
  std::vector<std::atomic<vtkIdType>> Counts;
  ExtractionBuffer<CrossingKey> Keys;
  ThreadLocals<Arena> Arenas;
  std::size_t Bytes = 0;
};

}

#endif
