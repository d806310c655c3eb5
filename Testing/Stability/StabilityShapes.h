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

/// A surface scaled by \a size and moved to \a midpoint along x. At size 1 it has the given area,
/// and the point Position has the given distance from the surface.
struct Shape
{
  std::function<vtkSmartPointer<vtkTerminationSurface>(double size, double midpoint)> Make;
  double Area;
  double AreaBound;
  std::array<double, 3> Position;
  double Distance;
};

/// Returns a plane, a sphere, a box, a cylinder, a tube and a mesh.
std::vector<Shape> MakeShapes();

}

#endif
