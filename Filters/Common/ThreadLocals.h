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
 * @brief   a value for each thread that asks for one
 *
 * vtkSMPThreadLocal makes room for all of its backends, and asks the system for its processors each
 * time: a file is read, which takes as long as some hundred cells. Here are only the values of the
 * threads that came, in a list that grows at its head; threads are few, and ask once for many
 * items.
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
  /// Visits the values, in no certain order; not while threads ask for theirs.
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

  /// Returns the value of the calling thread, made at its first call.
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
