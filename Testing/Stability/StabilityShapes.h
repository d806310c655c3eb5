// SPDX-License-Identifier: BSD-3-Clause
#ifndef StabilityShapes_h
#define StabilityShapes_h

#include "vtkSmartPointer.h" // for the surfaces

#include <array>
#include <functional>
#include <vector>

class vtkTerminationSurface;

namespace stability
{

/// A kind of termination surface. Make() scales the surface by \a size and moves it by \a midpoint
/// along x. At size 1, Area is the surface's area, and Distance is its distance from the point
/// Position.
struct Shape
{
  std::function<vtkSmartPointer<vtkTerminationSurface>(double size, double midpoint)> Make;
  double Area;
  double AreaBound;
  std::array<double, 3> Position;
  double Distance;
};

/// Returns one shape of each kind: plane, sphere, box, cylinder, tube and mesh.
std::vector<Shape> MakeShapes();

}

#endif
