// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowReference_h
#define FlowReference_h

#include "Benchmarks/Flow/FlowCases.h"
#include "Benchmarks/Flow/FlowMethods.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>

namespace flow
{
/// How far an answer is from the reference.
struct Difference
{
  /// Mean and median distance of the ends from the streamlines: the error of (u,v), world units.
  double Mean = 0.0;
  double Median = 0.0;
  /// Mean difference of the time at which a streamline is where it ends: the error of t.
  double Time = 0.0;
  /// The share of the answers that are no further than an error times their time from where the
  /// field carries the seed in that time.
  double Within = 0.0;
};

/**
 * Where streamlines really are, by a formula or by integration that is not this project's.
 */
class Reference
{
public:
  using VelocityFunction = std::function<void(const double x[3], double v[3])>;
  /// Moves x along the field for a time of any sign.
  using FollowFunction = std::function<void(double x[3], double time)>;

  Reference(vtkPolyData* seeds, const VelocityFunction& velocity, const FollowFunction& follow);

  /**
   * That of the field as VTK interpolates it: TrilinearFlow on images. On other grids by Boost's
   * method of Runge, Kutta and Fehlberg, order 7(8), in steps of at most a tenth of a cell through
   * VTK's interpolation, which is good to some 1e-8.
   */
  static Reference OfInterpolation(const Case& what);

  /// Over every \a stride-th seed with an answer. \a error: that of Difference::Within, world units
  /// per unit of time. Throws std::runtime_error where a reference is no number.
  Difference Compare(const Answer& answer, vtkIdType stride, double error = 0.0) const;

private:
  vtkSmartPointer<vtkPolyData> Seeds;
  VelocityFunction GetVelocity;
  FollowFunction Follow;
};
}

#endif
