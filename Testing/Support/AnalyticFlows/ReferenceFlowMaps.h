// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowMaps_h
#define ReferenceFlowMaps_h

#include <array>      // for vectors and matrices
#include <functional> // for velocities
#include <string>     // for bytes

class vtkDataSet;
class vtkPolyData;

/**
 * Analytic flow maps, which tests compare with computed flow maps.
 */
namespace reference
{

using FlowVector = std::array<double, 3>;
/// A 3 x 3 matrix in row-major order.
using FlowMatrix = std::array<double, 9>;
using FlowFunction = std::function<FlowVector(const FlowVector&)>;

FlowVector Multiply(const FlowMatrix& matrix, const FlowVector& x);
FlowMatrix Exponential(const FlowMatrix& matrix);
/// Returns the matrix A with A x = cross(a, x).
FlowMatrix CrossMatrix(const FlowVector& a);

///@{
/**
 * Returns the position at time t, which may be negative, of the particle that is at x at time 0.
 * MapLinear() is for the field dx/dt = matrix (x - center), the other functions are for the fields
 * of vtkAnalyticFlowSource. \a axis and \a normal need not be unit vectors, but must not be 0.
 */
FlowVector MapUniform(const FlowVector& x, const FlowVector& velocity, double t);
FlowVector MapRotation(const FlowVector& x, const FlowVector& center, const FlowVector& axis,
  double angularVelocity, double t);
FlowVector MapSaddle(
  const FlowVector& x, const FlowVector& center, const FlowVector& rates, double t);
FlowVector MapNode(const FlowVector& x, const FlowVector& center, const FlowVector& rates,
  const FlowVector& axis, double swirl, double t);
FlowVector MapShear(const FlowVector& x, const FlowVector& center, const FlowVector& normal,
  const FlowVector& velocity, double thickness, double t);
FlowVector MapLinear(
  const FlowVector& x, const FlowVector& center, const FlowMatrix& matrix, double t);
///@}

/// Evaluates a function at the points of a dataset and stores the values in double precision as the
/// active point vectors `Velocity`.
void SetVelocity(vtkDataSet* data, const FlowFunction& function);

/// Returns the bytes of all points, vertex cells, lines and point arrays, for bitwise comparisons.
std::string GetBytes(vtkPolyData* data);

}

#endif
