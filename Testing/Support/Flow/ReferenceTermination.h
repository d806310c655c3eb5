// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTermination_h
#define ReferenceTermination_h

#include "Support/Arrays/ReferenceVector.h" // for arithmetic
#include "Support/Checks/ReferenceCheck.h"  // for the result

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkTerminationSurface;

namespace reference
{

using Vector = std::array<double, 3>;

double GetSurfaceDistance(const vtkTerminationSurface* surface, const Vector& x);

/// Size and position of a surface, and the expected rounding error.
struct SurfaceScale
{
  double Size = 1.0;
  Vector Center = { { 0.0, 0.0, 0.0 } };
  /// Rounding error of positions, as a fraction of Size.
  double Rounding = 1e-12;
};

/// Returns four scales: size 1, very small, very large, and size 1 far from the origin.
std::vector<SurfaceScale> MakeSurfaceScales();

/// Returns random points around a surface.
std::vector<Vector> MakeRandomPointsNear(const SurfaceScale& scale, int number, unsigned seed);

/// Checks that the distances of two points from the surface differ by at most the distance between
/// the points.
void CheckLipschitz(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check);

/// Checks that points computed from random parameters are on the surface, in its bounds, and have
/// these parameters. EvaluatePoint() must find a point for at least \a number of the parameters.
void CheckRoundTrip(const vtkTerminationSurface* surface, const SurfaceScale& scale, int number,
  const std::string& name, Check& check);

/// Checks at points with random parameters that the gradient of the distance is the unit normal,
/// and that a small step along the normal, to either side, changes the distance by the step length.
void CheckNormals(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check);

/// Checks the distance against the formula \a expected.
void CheckDistance(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::function<double(const Vector&)>& expected, const std::string& name, Check& check);

/// Checks that the absolute distance of random points agrees with their distance from the nearest
/// of about samples^2 sample points on each part of the surface. The samples must be dense enough:
/// each point of the surface must be within \a spacing of a sample.
void CheckSamples(const vtkTerminationSurface* surface, const SurfaceScale& scale, int samples,
  double spacing, const std::string& name, Check& check);

}

#endif
