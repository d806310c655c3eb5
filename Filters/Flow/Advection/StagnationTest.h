// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StagnationTest_h
#define interlume_StagnationTest_h

#include "Common/Vectors.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   StagnationTest
 * @brief   detects streamlines that no longer make progress, for example near an attracting node
 *
 * An explicit method does not converge to such a node. It moves around the node within the error
 * tolerance. A streamline stagnates if, in four consecutive windows of steps, its displacement is
 * at most the permitted error for the duration of the window and at most a twentieth of the path
 * length. The windows have different numbers of steps, so that no closed orbit returns to its start
 * at the end of every window.
 */
class StagnationTest
{
public:
  void Begin(const double x[3])
  {
    *this = StagnationTest();
    std::copy(x, x + 3, this->Start);
  }

  /// Records an accepted step.
  void Add(double pathLength)
  {
    this->PathLength += pathLength;
    ++this->Steps;
  }

  /// Records several accepted steps. \a pathLength is the total path length in the window.
  void Restore(double pathLength, int steps)
  {
    this->PathLength = pathLength;
    this->Steps += steps;
  }
  double GetPathLength() const { return this->PathLength; }
  /// Returns the number of steps left in the window.
  int GetStepsLeft() const { return Windows[this->Window] - this->Steps; }

  /// Returns true if a window is complete and CompleteWindow must be called.
  bool IsDue() const { return this->Steps >= Windows[this->Window]; }

  /// Completes a window. Returns true if the streamline has stagnated.
  bool CompleteWindow(const double x[3], double time, double largestError)
  {
    const double displacement[3] = { x[0] - this->Start[0], x[1] - this->Start[1],
      x[2] - this->Start[2] };
    const double distance = Vectors::SafeLength(glm::make_vec3(displacement));
    const bool isAtRest =
      distance <= largestError * (time - this->StartTime) && distance <= 0.05 * this->PathLength;
    this->Window = isAtRest ? this->Window + 1 : 0;
    std::copy(x, x + 3, this->Start);
    this->StartTime = time;
    this->PathLength = 0.0;
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
  double PathLength = 0.0;
  int Steps = 0;
  int Window = 0;
};

}

#endif
