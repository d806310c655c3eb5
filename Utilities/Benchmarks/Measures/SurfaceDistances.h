// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceDistances_h
#define SurfaceDistances_h

#include <functional>

/**
 * Distances of a triangulated surface from another one, integrated over its area.
 */
struct SurfaceDistances
{
  double Area = 0.0;
  /// Of the distance: to first order the volume between the two surfaces.
  double Integral = 0.0;
  /// Of the distance's square.
  double SquareIntegral = 0.0;

  /// Adds a triangle by a rule of degree 2, of three points. \a distance is that of a point.
  void AddTriangle(
    const double x[3][3], const std::function<double(const double point[3])>& distance);

  /// 0 without area.
  double GetRootMeanSquare() const;
};

#endif
