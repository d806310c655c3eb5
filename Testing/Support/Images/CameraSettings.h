// SPDX-License-Identifier: BSD-3-Clause
#ifndef CameraSettings_h
#define CameraSettings_h

#include "vtkSmartPointer.h" // for the results

#include <array>  // for vectors
#include <vector> // for nodes

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

/**
 * Cameras and transfer functions for renderings that are compared with a reference.
 */
namespace reference
{

using Point3 = std::array<double, 3>;

/// Returns a camera that looks along \a direction at the center of the grid. The grid fills most of
/// a square image and is inside the clipping range.
vtkSmartPointer<vtkCamera> LookAt(
  vtkUnstructuredGrid* grid, const Point3& direction, bool parallel);
/// Returns a camera that looks along \a direction at the center of a sphere. The sphere fills most
/// of a square image and is inside the clipping range.
vtkSmartPointer<vtkCamera> LookAt(
  const Point3& center, double radius, const Point3& direction, bool parallel);

/// A node of a color and an opacity transfer function.
struct FunctionNode
{
  double X;
  Point3 Color;
  double Opacity;
};

/// Returns a property with piecewise linear transfer functions and without shading.
vtkSmartPointer<vtkVolumeProperty> MakeProperty(
  const std::vector<FunctionNode>& nodes, double unitDistance = 1.0);

/// Returns a property with a color ramp from blue at 0 to yellow at 1 and an opacity that rises
/// from \a low to \a high.
vtkSmartPointer<vtkVolumeProperty> MakeRamp(double low, double high, double unitDistance = 1.0);

}

#endif
