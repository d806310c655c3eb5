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
 * A field of space and time in a box whose region between two values is known at every time from
 * MovingField::FirstTime to LastTime.
 */
struct MovingField
{
  static constexpr double FirstTime = 0.0;
  static constexpr double LastTime = 2.0;

  std::string Name;
  /// In double precision; steps are set by who uses it.
  vtkSmartPointer<vtkAnalyticFieldSource> Source;
  double Lower;
  double Upper;
  /// The volume of the region at a time.
  std::function<double(double time)> Volume;

  /// How far a point is from the surface of a bound at a time, along the gradient.
  double GetDistance(const double point[3], double bound, double time) const;
};

/**
 * - `wave`: WAVE in (-2, 2) x (-1, 1) x (-1, 1), -0.15 <= f <= 0.15, whose volume is always 2.4;
 * - `ball`: BALL of radius 0.3 + 0.025 t around (-0.5 + 0.5 t, 0, 0), -0.1 <= f <= 0.1: a shell;
 * - `linear`: LINEAR, 0.5 x + 0.3 y + z + 0.05 (t - 1), -0.1 <= f <= 0.1, whose volume is always
 * 0.8. The last two are in (-1, 1)^3.
 */
std::vector<MovingField> MakeMovingFields(const BenchOptions& options);
}

#endif
