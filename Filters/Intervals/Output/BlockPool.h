// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BlockPool_h
#define interlume_BlockPool_h

#include <cstddef>
#include <memory>

namespace interlume
{

/**
 * @class   BlockPool
 * @brief   cache of large memory blocks that successive executions reuse
 *
 * The operating system clears every page of a new block, which takes a large part of the time of a
 * repeated extraction. A pooled block keeps its pages. The last array to release a block returns it
 * to the pool; any thread may do so. A later request of a similar size reuses the block, which then
 * holds stale values.
 */
class BlockPool
{
public:
  /// During the lifetime of this object, Acquire() takes the blocks of the calling thread from a
  /// pool. The pool may be null.
  class Use
  {
  public:
    explicit Use(BlockPool* memory);
    ~Use();
    Use(const Use&) = delete;
    void operator=(const Use&) = delete;

  private:
    BlockPool* Previous;
  };

  BlockPool();
  /// Frees the idle blocks. Blocks in use are freed when they are released.
  ~BlockPool();
  BlockPool(const BlockPool&) = delete;
  void operator=(const BlockPool&) = delete;

  /// Returns a block from the pool of the calling thread. Returns null if the thread has no pool or
  /// if \a bytes is below the minimum of 64 KiB.
  static void* Acquire(std::size_t bytes);

  /// Returns true if the block came from Acquire() and has not been released.
  static bool IsPooled(void* block);

  /// Returns a block to its pool. Frees it if it is not pooled or if its pool no longer exists. The
  /// block may be null.
  static void Release(void* block);

  /// Resets the counts at the start of an execution.
  void BeginExecution();
  /// Frees the blocks that neither this execution nor the previous one used.
  void EndExecution();

  /// Returns the number of reused bytes in this execution.
  std::size_t GetBytesReused() const;
  /// Returns the total size of the idle blocks in bytes.
  std::size_t GetBytesIdle() const;

private:
  struct Store;
  std::shared_ptr<Store> TheStore;
};

}

#endif
