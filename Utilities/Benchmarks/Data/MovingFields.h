// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovingFields_h
#define MovingFields_h

#include "Benchmarks/Suites/BenchOptions.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace interval4d
{
/**
 * A time-dependent field in a box. The volume of the region between the values Lower and Upper is
 * known from FirstTime to LastTime.
 */
struct MovingField
{
  static constexpr double FirstTime = 0.0;
  static constexpr double LastTime = 2.0;

  std::string Name;
  /// Source of the field, in double precision. Callers set the number of its time steps.
  vtkSmartPointer<vtkAnalyticFieldSource> Source;
  double Lower;
  double Upper;
  /// Returns the volume of the region at a time.
  std::function<double(double time)> Volume;

  /// Returns the distance of a point from the isosurface f = \a bound at a time, measured along the
  /// gradient.
  double GetDistance(const double point[3], double bound, double time) const;
};

/**
 * Returns the fields:
 * - `wave`: WAVE in (-2, 2) x (-1, 1) x (-1, 1), -0.15 <= f <= 0.15, with a constant volume of 2.4;
 * - `ball`: SPHERE_DISTANCE with radius 0.3 + 0.025 t around (-0.5 + 0.5 t, 0, 0), -0.1 <= f <=
 *   0.1, a spherical shell;
 * - `linear`: LINEAR, 0.5 x + 0.3 y + z + 0.05 (t - 1), -0.1 <= f <= 0.1, with a constant volume of
 *   0.8.
 *
 * `ball` and `linear` are defined in (-1, 1)^3.
 */
std::vector<MovingField> MakeMovingFields(const BenchOptions& options);
}

#endif
