// SPDX-License-Identifier: BSD-3-Clause
#include "Unstructured/CrossingLists.h"

#include "Common/ParallelFor.h"
#include "Common/Prefetch.h"
#include "Scalars/ExtractionScalars.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Number of grid points per block. A thread numbers the points of one block at a time, so that they
// remain in its cache.
constexpr vtkIdType OwnersInBlock = 2048;
constexpr vtkIdType OwnersInWord = 64;
constexpr int OwnersAhead = 8;
}

CrossingLists::CrossingLists(vtkIdType owners, bool keepNodes)
  : KeepNodes(keepNodes)
  , Owners((owners + OwnersInWord - 1) / OwnersInWord)
  , Counts((owners + OwnersInBlock - 1) / OwnersInBlock)
{
  this->Heads.AllocateZeros(owners);
}

CrossingLists::~CrossingLists() = default;

const CrossingLists::Node* CrossingLists::Add(
  vtkIdType owner, CrossingKey key, Node* head, Arena& arena)
{
  Node* const added = arena.New();
  added->Key = key;
  added->Next = head;
  std::atomic<Node*>& first = this->Heads[owner].First;
  while (!first.compare_exchange_weak(
    added->Next, added, std::memory_order_acq_rel, std::memory_order_acquire))
  {
    // Search the nodes that other threads added since the last search.
    for (const Node* node = added->Next; node != head; node = node->Next)
    {
      if (node->Key == key)
      {
        arena.ReleaseLast();
        return node;
      }
    }
    head = added->Next;
  }
  if (!added->Next)
  {
    this->Owners[owner / OwnersInWord].fetch_or(
      std::uint64_t(1) << (owner % OwnersInWord), std::memory_order_relaxed);
  }
  this->Counts[owner / OwnersInBlock].fetch_add(1, std::memory_order_relaxed);
  return added;
}

void CrossingLists::MakePoints(
  const ExtractionScalars& scalars, ExtractionBuffer<ExtractionPoint>& points)
{
  const vtkIdType blocks = static_cast<vtkIdType>(this->Counts.size());
  std::vector<vtkIdType> firstIds(blocks + 1, 0);
  for (vtkIdType block = 0; block < blocks; ++block)
  {
    firstIds[block + 1] = firstIds[block] + this->Counts[block].load(std::memory_order_relaxed);
  }
  this->Keys.Allocate(firstIds[blocks]);
  points.Allocate(firstIds[blocks]);
  ParallelFor(0, blocks,
    [&](vtkIdType block)
    {
      vtkIdType id = firstIds[block];
      const vtkIdType number = firstIds[block + 1] - id;
      vtkIdType found[OwnersInBlock];
      const int numberFound = number > 0 ? this->FindOwners(block, found) : 0;
      for (int i = 0; i < numberFound; ++i)
      {
        this->Prefetch(found[std::min(i + 2 * OwnersAhead, numberFound - 1)]);
        const Head& ahead = this->Heads[found[std::min(i + OwnersAhead, numberFound - 1)]];
        interlume::Prefetch::Read(ahead.First.load(std::memory_order_relaxed));
        id = this->NumberList(found[i], id, points);
      }
      scalars.Place(points.GetData() + id - number, number);
    });
  this->Bytes =
    this->Heads.GetBytes() + this->Owners.size() * sizeof(this->Owners[0]) + this->Keys.GetBytes();
  for (Arena& arena : this->Arenas)
  {
    this->Bytes += arena.GetBytes();
    if (!this->KeepNodes)
    {
      arena.Free();
    }
  }
}

int CrossingLists::FindOwners(vtkIdType block, vtkIdType* found) const
{
  constexpr vtkIdType words = OwnersInBlock / OwnersInWord;
  const vtkIdType end = std::min((block + 1) * words, static_cast<vtkIdType>(this->Owners.size()));
  int number = 0;
  for (vtkIdType word = block * words; word < end; ++word)
  {
    std::uint64_t bits = this->Owners[word].load(std::memory_order_relaxed);
    for (vtkIdType owner = word * OwnersInWord; bits != 0; ++owner, bits >>= 1)
    {
      found[number] = owner;
      number += static_cast<int>(bits & 1);
    }
  }
  return number;
}

vtkIdType CrossingLists::NumberList(
  vtkIdType owner, vtkIdType id, ExtractionBuffer<ExtractionPoint>& points)
{
  Head& head = this->Heads[owner];
  Node* const first = head.First.load(std::memory_order_relaxed);
  head.FirstId = id;
  CrossingKey* const begin = &this->Keys[id];
  CrossingKey* end = begin;
  for (const Node* node = first; node; node = node->Next)
  {
    *end++ = node->Key;
  }
  if (end - begin > 1)
  {
    std::sort(begin, end);
  }
  for (Node* node = first; this->KeepNodes && node;)
  {
    Node* const next = node->Next;
    node->Id = id + (std::lower_bound(begin, end, node->Key) - begin);
    node = next;
  }
  for (const CrossingKey* key = begin; key != end; ++key, ++id)
  {
    points[id] = *key == CrossingKey()
      ? ExtractionPoint{ owner, owner, 0.0 }
      : ExtractionPoint{ owner, key->GetFar(), static_cast<double>(key->GetValue()) };
  }
  return id;
}

}
