// SPDX-License-Identifier: BSD-3-Clause
#include "Output/KeptMemory.h"

#include "Output/ExtractionMemory.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>
#include <vector>

namespace interlume
{

struct KeptMemory::Store
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

  // Takes the idle block out that fits best: the smallest that has the room and is not much too
  // large, or else the largest that is a little too small. Returns none where there is neither.
  Block Remove(std::size_t bytes)
  {
    auto best = this->Idle.end();
    for (auto block = this->Idle.begin(); block != this->Idle.end(); ++block)
    {
      if (block->Capacity / 2 > bytes || block->Capacity < bytes / 2)
      {
        continue;
      }
      const bool isRoomy = block->Capacity >= bytes;
      const bool isBestRoomy = best != this->Idle.end() && best->Capacity >= bytes;
      if (best == this->Idle.end() || (isRoomy && !isBestRoomy) ||
        (isRoomy == isBestRoomy && (block->Capacity < best->Capacity) == isRoomy))
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
      // Room that is not used has no pages; with it a block still fits that grows a little. The
      // system moves the pages of a large block, it does not copy them.
      const std::size_t capacity = bytes + bytes / 8;
      void* const memory = std::realloc(block.Memory, capacity);
      if (!memory)
      {
        std::free(block.Memory);
        throw std::bad_alloc();
      }
      ExtractionMemory::PreferLargePages(memory, capacity);
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
// Smaller blocks cost no more than the search.
constexpr std::size_t LeastBytes = std::size_t(1) << 16;

thread_local KeptMemory* Current = nullptr;

// Whose the blocks in use are. It is never destroyed: arrays may let go of theirs when the process
// ends.
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

KeptMemory::Use::Use(KeptMemory* memory)
  : Before(Current)
{
  Current = memory;
}

KeptMemory::Use::~Use()
{
  Current = this->Before;
}

KeptMemory::KeptMemory()
  : Kept(std::make_shared<Store>())
{
}

KeptMemory::~KeptMemory() = default;

void* KeptMemory::Take(std::size_t bytes)
{
  if (!Current || bytes < LeastBytes)
  {
    return nullptr;
  }
  auto& inUse = BlocksInUse<Store>::Get();
  const std::lock_guard<std::mutex> lock(inUse.Mutex);
  const Store::Block block = Current->Kept->Take(bytes);
  inUse.Entries[block.Memory] = { block, Current->Kept };
  return block.Memory;
}

bool KeptMemory::IsKept(void* memory)
{
  auto& inUse = BlocksInUse<Store>::Get();
  const std::lock_guard<std::mutex> lock(inUse.Mutex);
  return inUse.Entries.count(memory) > 0;
}

void KeptMemory::Give(void* memory)
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

void KeptMemory::BeginExecution()
{
  const std::lock_guard<std::mutex> lock(BlocksInUse<Store>::Get().Mutex);
  ++this->Kept->Execution;
  this->Kept->Reused = 0;
}

void KeptMemory::EndExecution()
{
  const std::lock_guard<std::mutex> lock(BlocksInUse<Store>::Get().Mutex);
  auto& idle = this->Kept->Idle;
  const auto gone = std::partition(idle.begin(), idle.end(),
    [this](const Store::Block& block) { return block.LastUse >= this->Kept->Execution - 1; });
  std::for_each(gone, idle.end(), [](const Store::Block& block) { std::free(block.Memory); });
  idle.erase(gone, idle.end());
}

std::size_t KeptMemory::GetBytesReused() const
{
  return this->Kept->Reused;
}

std::size_t KeptMemory::GetBytesIdle() const
{
  const std::lock_guard<std::mutex> lock(BlocksInUse<Store>::Get().Mutex);
  std::size_t bytes = 0;
  for (const Store::Block& block : this->Kept->Idle)
  {
    bytes += block.Capacity;
  }
  return bytes;
}

}
