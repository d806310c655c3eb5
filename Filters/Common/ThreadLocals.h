// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ThreadLocals_h
#define interlume_ThreadLocals_h

#include <atomic>
#include <cstddef>
#include <iterator>
#include <thread>

namespace interlume
{

/**
 * @class   ThreadLocals
 * @brief   thread-local values, created on first use
 *
 * Each vtkSMPThreadLocal allocates storage for all of its backends and queries the number of
 * processors, which reads a file. This class stores only the values of threads that called Local(),
 * in a linked list. Searching the list takes little time, since it is short and each thread calls
 * Local() only once for many items.
 */
template <typename T>
class ThreadLocals
{
  struct Node
  {
    std::thread::id Thread;
    T Value;
    Node* Next;
  };

public:
  /// Iterator over the values, in no particular order. Do not use it while threads call Local().
  template <typename Value>
  class IteratorOf
  {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Value*;
    using reference = Value&;

    explicit IteratorOf(Node* node)
      : At(node)
    {
    }
    reference operator*() const { return this->At->Value; }
    pointer operator->() const { return &this->At->Value; }
    IteratorOf& operator++()
    {
      this->At = this->At->Next;
      return *this;
    }
    IteratorOf operator++(int)
    {
      const IteratorOf before = *this;
      ++*this;
      return before;
    }
    bool operator==(const IteratorOf& other) const { return this->At == other.At; }
    bool operator!=(const IteratorOf& other) const { return this->At != other.At; }

  private:
    Node* At;
  };
  using Iterator = IteratorOf<T>;
  using ConstIterator = IteratorOf<const T>;

  ThreadLocals() = default;
  ~ThreadLocals()
  {
    for (Node* node = this->First.load(); node;)
    {
      Node* const next = node->Next;
      delete node;
      node = next;
    }
  }
  ThreadLocals(const ThreadLocals&) = delete;
  void operator=(const ThreadLocals&) = delete;

  /// Returns the value of the calling thread. The thread's first call creates it.
  T& Local()
  {
    const std::thread::id self = std::this_thread::get_id();
    Node* const head = this->First.load(std::memory_order_acquire);
    for (Node* node = head; node; node = node->Next)
    {
      if (node->Thread == self)
      {
        return node->Value;
      }
    }
    Node* const added = new Node{ self, T(), head };
    while (!this->First.compare_exchange_weak(
      added->Next, added, std::memory_order_acq_rel, std::memory_order_acquire))
    {
    }
    return added->Value;
  }

  Iterator begin() { return Iterator(this->First.load()); }
  Iterator end() { return Iterator(nullptr); }
  ConstIterator begin() const { return ConstIterator(this->First.load()); }
  ConstIterator end() const { return ConstIterator(nullptr); }

private:
  std::atomic<Node*> First{ nullptr };
};

}

#endif
