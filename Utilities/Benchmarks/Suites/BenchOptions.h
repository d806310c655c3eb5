// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchOptions_h
#define BenchOptions_h

#include <string>
#include <vector>

/**
 * What the command line asked of every suite.
 */
struct BenchOptions
{
  enum Sizes
  {
    /// The cases as published.
    FULL,
    /// Smaller cases and fewer repetitions: a suite stays under 45 s on two cores.
    QUICK,
    /// The smallest cases that give every kind of row, for the tests of this program.
    TINY
  };

  Sizes Size = FULL;
  /// The number of threads that "all" stands for.
  int Threads = 1;
  /// Seed of every pseudo-random number.
  unsigned int Seed = 1;
  /// This program, to start it again where a fresh process is to be measured.
  std::string Program;

  /// Timed runs of each method: 5, or 3 when not FULL.
  int GetRepeats() const;
  /// `full`, `quick` or `tiny`.
  std::string GetSizeName() const;
  /// 1 and Threads, or 1 alone where they are the same.
  std::vector<int> GetThreadCounts() const;
  /// The one of the three that belongs to Size.
  template <typename T>
  T Pick(const T& full, const T& quick, const T& tiny) const
  {
    return this->Size == FULL ? full : this->Size == QUICK ? quick : tiny;
  }
};

#endif
