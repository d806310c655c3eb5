// SPDX-License-Identifier: BSD-3-Clause
#include "Output/BlockPool.h"

#include "Output/OutputAllocation.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>
#include <vector>

namespace interlume
{

struct BlockPool::Store
{
  struct Block
  {
    void* Memory = nullptr;
    std::size_t Capacity = 0;
    int LastUse = 0;
  };

  ~Store()
  {
    for (const Block& block : this->Idle)
    {
      std::free(block.Memory);
    }
  }

  // Removes and returns the idle block that fits best: the smallest one of at least \a bytes and at
  // most twice as much, otherwise the largest one of at least half as much. Returns an empty block
  // if there is no such block.
  Block Remove(std::size_t bytes)
  {
    auto best = this->Idle.end();
    for (auto block = this->Idle.begin(); block != this->Idle.end(); ++block)
    {
      if (block->Capacity / 2 > bytes || block->Capacity < bytes / 2)
      {
        continue;
      }
      const bool isLargeEnough = block->Capacity >= bytes;
      const bool isBestLargeEnough = best != this->Idle.end() && best->Capacity >= bytes;
      if (best == this->Idle.end() || (isLargeEnough && !isBestLargeEnough) ||
        (isLargeEnough == isBestLargeEnough && (block->Capacity < best->Capacity) == isLargeEnough))
      {
        best = block;
      }
    }
    Block removed;
    if (best != this->Idle.end())
    {
      removed = *best;
      this->Idle.erase(best);
    }
    return removed;
  }

  Block Take(std::size_t bytes)
  {
    Block block = this->Remove(bytes);
    this->Reused += std::min(bytes, block.Capacity);
    if (block.Capacity < bytes)
    {
      // The margin lets the block serve slightly larger requests later. It occupies no memory until
      // it is used. For a large block, realloc() remaps the pages without copying them.
      const std::size_t capacity = bytes + bytes / 8;
      void* const memory = std::realloc(block.Memory, capacity);
      if (!memory)
      {
        std::free(block.Memory);
        throw std::bad_alloc();
      }
      OutputAllocation::PreferLargePages(memory, capacity);
      block.Memory = memory;
      block.Capacity = capacity;
    }
    block.LastUse = this->Execution;
    return block;
  }

  std::vector<Block> Idle;
  int Execution = 0;
  std::size_t Reused = 0;
};

namespace
{
// Smaller blocks are not pooled, since allocating them is as fast as searching the pool.
constexpr std::size_t MinimumBytes = std::size_t(1) << 16;

thread_local BlockPool* Current = nullptr;

// The owners of the blocks in use. This object is never destroyed because arrays may release their
// blocks during process exit.
template <typename Store>
struct BlocksInUse
{
  struct Entry
  {
    typename Store::Block Block;
    std::weak_ptr<Store> Owner;
  };

  std::mutex Mutex;
  std::unordered_map<void*, Entry> Entries;

  static BlocksInUse& Get()
  {
    static BlocksInUse* const all = new BlocksInUse;
    return *all;
  }
};
}

BlockPool::Use::Use(BlockPool* memory)
  : Previous(Current)
{
  Current = memory;
}

BlockPool::Use::~Use()
{
  Current = this->Previous;
}

BlockPool::BlockPool()
  : TheStore(std::make_shared<Store>())
{
}

BlockPool::~BlockPool() = default;

void* BlockPool::Acquire(std::size_t bytes)
{
  if (!Current || bytes < MinimumBytes)
  {
    return nullptr;
  }
  auto& inUse = BlocksInUse<Store>::Get();
  const std::lock_guard<std::mutex> lock(inUse.Mutex);
  const Store::Block block = Current->TheStore->Take(bytes);
  inUse.Entries[block.Memory] = { block, Current->TheStore };
  return block.Memory;
}

bool BlockPool::IsPooled(void* memory)
{
  auto& inUse = BlocksInUse<Store>::Get();
  const std::lock_guard<std::mutex> lock(inUse.Mutex);
  return inUse.Entries.count(memory) > 0;
}

void BlockPool::Release(void* memory)
{
  auto& inUse = BlocksInUse<Store>::Get();
  const std::lock_guard<std::mutex> lock(inUse.Mutex);
  const auto found = inUse.Entries.find(memory);
  std::shared_ptr<Store> owner;
  if (found != inUse.Entries.end())
  {
    owner = found->second.Owner.lock();
    if (owner)
    {
      owner->Idle.push_back(found->second.Block);
    }
    inUse.Entries.erase(found);
  }
  if (!owner)
  {
    std::free(memory);
  }
}

void BlockPool::BeginExecution()
{
  const std::lock_guard<std::mutex> lock(BlocksInUse<Store>::Get().Mutex);
  ++this->TheStore->Execution;
  this->TheStore->Reused = 0;
}

void BlockPool::EndExecution()
{
  const std::lock_guard<std::mutex> lock(BlocksInUse<Store>::Get().Mutex);
  auto& idle = this->TheStore->Idle;
  const auto unused = std::partition(idle.begin(), idle.end(),
    [this](const Store::Block& block) { return block.LastUse >= this->TheStore->Execution - 1; });
  std::for_each(unused, idle.end(), [](const Store::Block& block) { std::free(block.Memory); });
  idle.erase(unused, idle.end());
}

std::size_t BlockPool::GetBytesReused() const
{
  return this->TheStore->Reused;
}

std::size_t BlockPool::GetBytesIdle() const
{
  const std::lock_guard<std::mutex> lock(BlocksInUse<Store>::Get().Mutex);
  std::size_t bytes = 0;
  for (const Store::Block& block : this->TheStore->Idle)
  {
    bytes += block.Capacity;
  }
  return bytes;
}

}
