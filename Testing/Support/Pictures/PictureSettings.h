// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureSettings_h
#define PictureSettings_h

#include "vtkSmartPointer.h" // for what is made

#include <array>  // for vectors
#include <vector> // for nodes

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

/**
 * Cameras and transfer functions of pictures that are compared with a reference.
 */
namespace reference
{

using Point3 = std::array<double, 3>;

/// A camera that looks along \a direction at the middle of the grid, which fills most of a square
/// picture, its clipping range around the grid.
vtkSmartPointer<vtkCamera> LookAt(
  vtkUnstructuredGrid* grid, const Point3& direction, bool parallel);
/// The same at the middle of a sphere.
vtkSmartPointer<vtkCamera> LookAt(
  const Point3& middle, double radius, const Point3& direction, bool parallel);

/// A node of both transfer functions: position, colour, opacity.
struct FunctionNode
{
  double X;
  Point3 Color;
  double Opacity;
};

/// A property with straight transfer functions, not shaded.
vtkSmartPointer<vtkVolumeProperty> MakeProperty(
  const std::vector<FunctionNode>& nodes, double unitDistance = 1.0);

/// From blue at 0 to yellow at 1, with an opacity that rises from low to high.
vtkSmartPointer<vtkVolumeProperty> MakeRamp(double low, double high, double unitDistance = 1.0);

}

#endif
