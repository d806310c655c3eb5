// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stopwatch_h
#define Stopwatch_h

#include <chrono>

namespace gallery
{
/**
 * Measures the wall-clock time since construction.
 */
class Stopwatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

#endif
