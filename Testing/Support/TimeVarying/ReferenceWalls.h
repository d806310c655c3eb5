// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceWalls_h
#define ReferenceWalls_h

#include "Support/Meshes/ReferenceBoundary.h"       // for domains that are no box
#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <array>  // for boxes
#include <memory> // for the boundary
#include <vector> // for points

namespace reference
{

/**
 * @class   DomainWalls
 * @brief   the boundary of a domain, at all times between the first and the last step
 *
 * The domain is a box whose sides move linearly from step to step, or any that does not move.
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

  /// Whether one side of the box, or one face of a cell, holds all points, within 1e-10 of the
  /// size.
  bool Hold(const std::vector<Event>& events) const;

private:
  using Box = std::array<double, 6>;

  Box BoxAt(double time) const;

  std::vector<double> Times;
  std::vector<Box> Boxes;
  double Tolerance;
  std::unique_ptr<DomainBoundary> Faces; ///< where the domain is no box
};

}

#endif
