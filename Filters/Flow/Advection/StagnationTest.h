// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StagnationTest_h
#define interlume_StagnationTest_h

#include "Common/Vectors.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   StagnationTest
 * @brief   whether a streamline goes on and on without getting anywhere, as at a node
 *
 * An explicit method does not come to rest at a node: it goes to and fro around it by about the
 * error that it may make. Here a streamline has stagnated when in each of four windows of steps it
 * has got no further than the error of the window's time, and no twentieth of the way it made. The
 * windows are of different numbers of steps, so that no orbit closes in all of them.
 */
class StagnationTest
{
public:
  void Begin(const double x[3])
  {
    *this = StagnationTest();
    std::copy(x, x + 3, this->Start);
  }

  /// Notes an accepted step.
  void Add(double way)
  {
    this->Way += way;
    ++this->Steps;
  }

  /// Notes several accepted steps by the way that all steps of the window have made.
  void Restore(double way, int steps)
  {
    this->Way = way;
    this->Steps += steps;
  }
  double GetWay() const { return this->Way; }
  /// Returns the number of steps that the window still has.
  int GetStepsLeft() const { return Windows[this->Window] - this->Steps; }

  /// Returns whether a window has ended, and Look is to be called.
  bool IsDue() const { return this->Steps >= Windows[this->Window]; }

  /// Ends a window. Returns true where the streamline has stagnated.
  bool Look(const double x[3], double time, double largestError)
  {
    const double apart[3] = { x[0] - this->Start[0], x[1] - this->Start[1], x[2] - this->Start[2] };
    const double distance = Vectors::SafeLength(glm::make_vec3(apart));
    const bool isAtRest =
      distance <= largestError * (time - this->StartTime) && distance <= 0.05 * this->Way;
    this->Window = isAtRest ? this->Window + 1 : 0;
    std::copy(x, x + 3, this->Start);
    this->StartTime = time;
    this->Way = 0.0;
    this->Steps = 0;
    if (this->Window == NumberOfWindows)
    {
      this->Window = 0;
      return true;
    }
    return false;
  }

private:
  static constexpr int NumberOfWindows = 4;
  static constexpr int Windows[NumberOfWindows] = { 64, 67, 71, 79 };

  double Start[3] = {};
  double StartTime = 0.0;
  double Way = 0.0;
  int Steps = 0;
  int Window = 0;
};

}

#endif
