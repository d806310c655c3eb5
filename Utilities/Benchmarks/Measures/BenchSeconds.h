// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSeconds_h
#define BenchSeconds_h

#include <array>
#include <vector>

/**
 * The median time of several runs.
 */
struct BenchSeconds
{
  double Value = 0.0;
  int Runs = 0;
  /// Start and end of each run in seconds of std::chrono::steady_clock.
  std::vector<std::array<double, 2>> Spans = {};
  /// Median processor time, summed over all threads. Other programs do not affect it.
  double Processor = 0.0;

  /// Returns a copy whose Value is the processor time.
  BenchSeconds GetProcessorTime() const { return { this->Processor, this->Runs, this->Spans }; }

  operator double() const { return this->Value; }
};

#endif
