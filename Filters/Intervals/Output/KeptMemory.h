// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_KeptMemory_h
#define interlume_KeptMemory_h

#include <cstddef>
#include <memory>

namespace interlume
{

/**
 * @class   KeptMemory
 * @brief   large blocks of memory that are used again once nobody holds them
 *
 * A tenth to a half of the time of an extraction that is made again and again is the system's,
 * which clears the pages of each new block. A block that is kept has its pages. It comes back when
 * the last array that holds it lets go of it, whoever that is, in whatever thread, and is taken
 * again by the next request that it fits. What is in it is left over from before.
 */
class KeptMemory
{
public:
  /// Has the calling thread's blocks come from \a memory, which may be null, for as long as it
  /// lives.
  class Use
  {
  public:
    explicit Use(KeptMemory* memory);
    ~Use();
    Use(const Use&) = delete;
    void operator=(const Use&) = delete;

  private:
    KeptMemory* Before;
  };

  KeptMemory();
  /// Frees what is not in use; the rest is freed as it is let go of.
  ~KeptMemory();
  KeptMemory(const KeptMemory&) = delete;
  void operator=(const KeptMemory&) = delete;

  /// Returns a block for the calling thread, or null where none is kept for it or \a bytes are few.
  static void* Take(std::size_t bytes);

  /// Returns whether a block is one that Take() has given.
  static bool IsKept(void* block);

  /// Lets go of a block. One that Take() has not given, or null, is freed.
  static void Give(void* block);

  /// Begins the counts of an execution anew.
  void BeginExecution();
  /// Frees the blocks that neither this execution nor the one before has used.
  void EndExecution();

  /// Returns the bytes that this execution took from blocks used before.
  std::size_t GetBytesReused() const;
  /// Returns the bytes of the blocks that nobody holds.
  std::size_t GetBytesIdle() const;

private:
  struct Store;
  std::shared_ptr<Store> Kept;
};

}

#endif
