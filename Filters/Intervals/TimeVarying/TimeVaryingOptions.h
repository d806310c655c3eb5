// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingOptions_h
#define interlume_TimeVaryingOptions_h

#include "vtkTimeVaryingSettings.h"

#include <array>
#include <cmath>

namespace interlume
{

/**
 * @class   TimeVaryingOptions
 * @brief   the settings of one execution, and the projection that they stand for
 */
class TimeVaryingOptions
{
public:
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
    // The line stays the same, and never points away from time.
    length = direction[3] < 0.0 ? -length : length;
    for (int axis = 0; axis < 4; ++axis)
    {
      this->Direction[axis] = direction[axis] / length;
    }
  }

  /// Their direction of projection is not zero.
  const vtkTimeVaryingSettings Settings;
  const int Precision;
  /// Whether steps are copied, since the input writes each over the one before.
  const bool CopiesSteps;

  bool IsAlongTime() const { return this->Direction[3] == 1.0; }

  /**
   * Turns a place in space and time into the axes of the projection, of which the last is along it:
   * those of x, y, z, t turned by the smallest rotation that takes t to the direction.
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
