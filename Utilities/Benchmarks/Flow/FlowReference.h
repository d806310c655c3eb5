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
/// Difference between a MethodResult and the reference.
struct Difference
{
  /// Mean and median distance of the endpoints from the exact streamlines, in world units: the
  /// error of (u,v).
  double Mean = 0.0;
  double Median = 0.0;
  /// Mean absolute difference between the time at an endpoint and the exact time: the error of t.
  double Time = 0.0;
  /// Fraction of the endpoints whose distance from the exact position after the same integration
  /// time is at most the error bound multiplied by this time.
  double Within = 0.0;
};

/**
 * Exact streamlines, from a formula or from an integrator that is not part of this project.
 */
class Reference
{
public:
  using VelocityFunction = std::function<void(const double x[3], double v[3])>;
  /// Moves x along the field for a positive or negative time.
  using FollowFunction = std::function<void(double x[3], double time)>;

  Reference(vtkPolyData* seeds, const VelocityFunction& velocity, const FollowFunction& follow);

  /**
   * Returns the reference of the field as VTK interpolates it. Images use TrilinearFlow. Other
   * grids use Boost's Runge-Kutta-Fehlberg 7(8) in steps of at most a tenth of a cell with VTK's
   * interpolation, with an accuracy of about 1e-8.
   */
  static Reference FromInterpolatedField(const Case& what);

  /// Compares the result of every \a stride-th seed, if it reached the box. \a error is the error
  /// bound of Difference::Within in world units per unit of time. Throws std::runtime_error if a
  /// reference position is not finite.
  Difference Compare(const MethodResult& result, vtkIdType stride, double error = 0.0) const;

private:
  vtkSmartPointer<vtkPolyData> Seeds;
  VelocityFunction GetVelocity;
  FollowFunction Follow;
};
}

#endif
