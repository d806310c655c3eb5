// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowMaps_h
#define ReferenceFlowMaps_h

#include <array>      // for vectors and matrices
#include <functional> // for velocities
#include <string>     // for bytes

class vtkDataSet;
class vtkPolyData;

/**
 * Velocity fields and where they carry a point in a time: answers known by formulas.
 */
namespace reference
{

using FlowVector = std::array<double, 3>;
/// Row by row.
using FlowMatrix = std::array<double, 9>;
using FlowFunction = std::function<FlowVector(const FlowVector&)>;

FlowVector Multiply(const FlowMatrix& matrix, const FlowVector& x);
/// The matrix exponential.
FlowMatrix Exponential(const FlowMatrix& matrix);
/// Of the linear map x -> a x x.
FlowMatrix CrossMatrix(const FlowVector& a);

///@{
/**
 * The place at time t (of any sign) of what is at x at time 0 in the fields of
 * vtkAnalyticFlowSource. \a axis and \a normal may have any length but 0. Linear: dx/dt = matrix (x
 * - center).
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

/// Gives a dataset active vectors of double, `Velocity`: a function at its points.
void SetVelocity(vtkDataSet* data, const FlowFunction& function);

/// The bytes of points, cells and point arrays.
std::string GetBytes(vtkPolyData* data);

}

#endif
