// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingOptions_h
#define interlume_TimeVaryingOptions_h

#include "vtkIntervalAlgorithm.h"
#include "vtkTimeVaryingSettings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

  std::vector<Criterion> Criteria;
  /// How the criteria change the result. A union has one part for the intervals (Part is 0), and
  /// one for each criterion (Part is its index plus 1): the region that satisfies the criterion,
  /// outside of the intervals and of the criteria before it.
  int Operation = vtkIntervalAlgorithm::INTERSECTION;
  int Part = 0;
  /// Cells where the scalar has one of these values at all points do not belong to the region
  /// outside of the intervals.
  std::vector<double> SkippedConstants;

  bool IsUnion() const { return this->Operation == vtkIntervalAlgorithm::UNION; }
  /// Returns the number of criteria at which the part is cut.
  std::size_t GetNumberOfCuts() const
  {
    return this->IsUnion() ? static_cast<std::size_t>(this->Part) : this->Criteria.size();
  }
  /// Returns whether the region that satisfies a criterion is removed.
  bool IsExcluded(std::size_t criterion) const
  {
    return this->IsUnion() ? static_cast<int>(criterion) + 1 < this->Part
                           : this->Operation == vtkIntervalAlgorithm::DIFFERENCE;
  }
  /// Returns whether a kind of boundary of the intervals is requested.
  bool IsRequested(int kind) const
  {
    // The surfaces where a region outside meets the intervals are inside the union.
    return this->Settings.GenerateBoundary[kind] &&
      (this->Part == 0 || kind >= vtkTimeVaryingSettings::VOLUME_AT_START);
  }

  /// Returns whether any kind of boundary is requested.
  bool HasBoundary() const
  {
    const auto& kinds = this->Settings.GenerateBoundary;
    return std::find(kinds.begin(), kinds.end(), true) != kinds.end();
  }

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
