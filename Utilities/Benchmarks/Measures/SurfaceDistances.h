// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceDistances_h
#define SurfaceDistances_h

#include <functional>

/**
 * Distances of a triangulated surface from another surface, integrated over the triangles.
 */
struct SurfaceDistances
{
  double Area = 0.0;
  /// Integral of the distance. To first order, it is the volume between the two surfaces.
  double Integral = 0.0;
  /// Integral of the squared distance.
  double SquareIntegral = 0.0;

  /// Adds the integrals over a triangle, with a three-point rule that is exact for quadratic
  /// polynomials. \a distance returns the distance of a point from the other surface.
  void AddTriangle(
    const double x[3][3], const std::function<double(const double point[3])>& distance);

  /// Returns the root mean square distance, or 0 if the total area is 0.
  double GetRootMeanSquare() const;
};

#endif
