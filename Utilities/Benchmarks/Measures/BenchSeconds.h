// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSeconds_h
#define BenchSeconds_h

#include <array>
#include <vector>

/**
 * A time, and how many runs it is the median of: one run is one run.
 */
struct BenchSeconds
{
  double Value = 0.0;
  int Runs = 0;
  /// When each run began and ended, in seconds of std::chrono::steady_clock.
  std::vector<std::array<double, 2>> Spans = {};
  /// The processor time of all threads, also a median, which excludes other programs.
  double Processor = 0.0;

  /// Returns the processor time as a time.
  BenchSeconds OfProcessor() const { return { this->Processor, this->Runs, this->Spans }; }

  operator double() const { return this->Value; }
};

#endif
