// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingOptions_h
#define interlume_TimeVaryingOptions_h

#include "vtkTimeVaryingSettings.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace interlume
{

/**
 * @class   TimeVaryingOptions
 * @brief   settings of one execution, and the projection derived from them
 */
class TimeVaryingOptions
{
public:
  /// The region where a point array is between two bounds.
  struct Criterion
  {
    std::string ArrayName;
    double Lower;
    double Upper;
    /// A description for messages.
    std::string Words;
  };

  TimeVaryingOptions(const vtkTimeVaryingSettings& settings, int precision, bool copiesSteps)
    : Settings(settings)
    , Precision(precision)
    , CopiesSteps(copiesSteps)
  {
    const double* direction = settings.ProjectionDirection;
    double length = 0.0;
    for (int axis = 0; axis < 4; ++axis)
    {
      length = std::hypot(length, direction[axis]);
    }
    // The sign of the direction is irrelevant. Make the time component nonnegative.
    length = direction[3] < 0.0 ? -length : length;
    for (int axis = 0; axis < 4; ++axis)
    {
      this->Direction[axis] = direction[axis] / length;
    }
  }

  /// The settings. The projection direction must not be zero.
  const vtkTimeVaryingSettings Settings;
  const int Precision;
  /// If true, steps are copied because the input writes each one over the previous one.
  const bool CopiesSteps;

  /// Criteria, all of which the output satisfies, or none if ExcludesCriteria is true.
  std::vector<Criterion> Criteria;
  bool ExcludesCriteria = false;

  bool IsAlongTime() const { return this->Direction[3] == 1.0; }

  /**
   * Transforms a point from (x,y,z,t) to projection coordinates. Their axes are x, y, z, t rotated
   * by the smallest rotation that takes t to the projection direction.
   */
  void Project(double x[4]) const
  {
    double along = 0.0;
    for (int axis = 0; axis < 4; ++axis)
    {
      along += x[axis] * this->Direction[axis];
    }
    const double shift = (x[3] + along) / (1.0 + this->Direction[3]);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] -= this->Direction[axis] * shift;
    }
    x[3] = along;
  }

private:
  std::array<double, 4> Direction{ { 0.0, 0.0, 0.0, 1.0 } };
};

}

#endif
