// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchOptions_h
#define BenchOptions_h

#include <string>
#include <vector>

/**
 * Command-line options that are common to all suites.
 */
struct BenchOptions
{
  enum Sizes
  {
    /// The cases of the published measurements.
    FULL,
    /// Smaller cases and fewer repetitions, which take less than 45 s per suite on two cores.
    QUICK,
    /// The smallest cases that produce every kind of row, used to test this program.
    TINY
  };

  Sizes Size = FULL;
  /// Number of threads for rows that are measured with all threads.
  int Threads = 1;
  /// Seed of all pseudo-random numbers.
  unsigned int Seed = 1;
  /// Path of this program, used to start a new process for measurements that require one.
  std::string Program;

  /// Returns the number of timed runs of each method: 5 if Size is FULL, 3 otherwise.
  int GetRepeats() const;
  /// Returns `full`, `quick` or `tiny`.
  std::string GetSizeName() const;
  /// Returns 1 and Threads, or only 1 if they are equal.
  std::vector<int> GetThreadCounts() const;
  /// Returns the argument that corresponds to Size.
  template <typename T>
  T Pick(const T& full, const T& quick, const T& tiny) const
  {
    return this->Size == FULL ? full : this->Size == QUICK ? quick : tiny;
  }
};

#endif
