// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSeconds_h
#define BenchSeconds_h

/**
 * A time, and how many runs it is the median of: one run is one run.
 */
struct BenchSeconds
{
  double Value = 0.0;
  int Runs = 0;

  operator double() const { return this->Value; }
};

#endif
