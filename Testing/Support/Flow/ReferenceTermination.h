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

double DistanceOf(const vtkTerminationSurface* surface, const Vector& x);

/// How large a surface is, where, and how far rounding may lead.
struct SurfaceScale
{
  double Size = 1.0;
  Vector Center = { { 0.0, 0.0, 0.0 } };
  /// Of positions, in parts of Size.
  double Rounding = 1e-12;
};

/// Of size 1, very small, very large, and far from the origin.
std::vector<SurfaceScale> MakeSurfaceScales();

/// Places around a surface.
std::vector<Vector> PointsAround(const SurfaceScale& scale, int number, unsigned seed);

/// The distance between two places changes by no more than their own distance.
void CheckLipschitz(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check);

/// Points of random parameters of every part are on the surface, in its bounds, and have these
/// parameters. At least \a number of them are there.
void CheckRoundTrip(const vtkTerminationSurface* surface, const SurfaceScale& scale, int number,
  const std::string& name, Check& check);

/// At points of random parameters the distance grows along the normal by as much as one goes, on
/// both sides, and no other way.
void CheckNormals(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check);

/// The distance against a formula.
void CheckDistance(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::function<double(const Vector&)>& expected, const std::string& name, Check& check);

/// The distance's absolute value against the nearest of samples x samples points of each part; none
/// of the surface is further from one than \a spacing.
void CheckSamples(const vtkTerminationSurface* surface, const SurfaceScale& scale, int samples,
  double spacing, const std::string& name, Check& check);

}

#endif
