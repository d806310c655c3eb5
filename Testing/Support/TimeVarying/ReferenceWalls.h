// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceWalls_h
#define ReferenceWalls_h

#include "Support/Meshes/ReferenceBoundary.h"       // for domains other than boxes
#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <array>  // for boxes
#include <memory> // for the boundary
#include <vector> // for points

namespace reference
{

/**
 * @class   DomainWalls
 * @brief   side walls of a domain at all times between the first and the last step
 *
 * The domain must be static, or a box whose sides move linearly between steps.
 */
class DomainWalls
{
public:
  explicit DomainWalls(const TimeSteps& steps);

  struct Event
  {
    DomainBoundary::Point X;
    double Time;
  };

  /// Returns whether one side of the box, or one boundary face of a domain that is not a box,
  /// contains all points. The tolerance is 1e-10 times the length of the domain's diagonal.
  bool Hold(const std::vector<Event>& events) const;

private:
  using Box = std::array<double, 6>;

  Box BoxAt(double time) const;

  std::vector<double> Times;
  std::vector<Box> Boxes;
  double Tolerance;
  std::unique_ptr<DomainBoundary> Faces; ///< set only if the domain is not a box
};

}

#endif
