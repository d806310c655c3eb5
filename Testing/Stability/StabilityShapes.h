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

/// A surface of size 1 times \a size, moved to \a middle along x, its area at size 1, and what is
/// known of its distance: a place at size 1 and the distance there.
struct Shape
{
  std::function<vtkSmartPointer<vtkTerminationSurface>(double size, double middle)> Make;
  double Area;
  double AreaBound;
  std::array<double, 3> Place;
  double Distance;
};

/// One of each kind that is placed by numbers: plane, sphere, box, cylinder, tube, mesh.
std::vector<Shape> MakeShapes();

}

#endif
