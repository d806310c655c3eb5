// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowResults_h
#define ReferenceFlowResults_h

#include "vtkSmartPointer.h" // for the images
#include "vtkType.h"         // for vtkIdType

#include <array>      // for bounds and points
#include <functional> // for flow functions
#include <vector>     // for surfaces

class vtkDataSet;
class vtkImageData;
class vtkUnstructuredGrid;

/**
 * Implicit flow fields of flows with known streamlines, and measures of meshes extracted from them.
 */
namespace reference
{

/// Status, surface id, parameters and time at the end of a sample's streamline.
struct FlowResult
{
  int Status = 0;
  int Id = 0;
  double U = 0.0;
  double V = 0.0;
  double Time = 0.0;
};
using FlowResultFunction = std::function<FlowResult(const double* x)>;

/// Id of a termination surface, and whether its parameters u and v are periodic.
using FlowSurface = std::array<int, 3>;

/// Adds the arrays of an implicit flow field to \a data.
void AddFlow(
  vtkDataSet* data, const FlowResultFunction& function, const std::vector<FlowSurface>& surfaces);

/// Returns an image with the given number of points and bounds.
vtkSmartPointer<vtkImageData> MakeFlowImage(
  const std::array<int, 3>& points, const std::array<double, 6>& bounds);

/// Returns the uniform flow of \a speed along x from the plane x = 0, with id 0 and (u,v) = (y,z).
FlowResultFunction UniformFlow(double speed);
/// Returns the radial flow of speed 1 from a cylinder around the z-axis, with id 0 and (u,v) =
/// (angle in turns, z). Streamlines of samples inside the cylinder do not reach it.
FlowResultFunction CylinderFlow(double radius);
/// Returns the radial flow of speed 1 from a sphere around the origin; (u,v) = (longitude in turns,
/// polar angle in half turns).
FlowResultFunction SphereFlow(double radius);
/// Returns the flow (x, -y, 0) from the planes y = 1 (id 0) and y = -1 (id 1), where (u,v) = (x,
/// z). Streamlines from y = 0 stagnate.
FlowResultFunction SaddleFlow();
/// Returns the rotating flow about the z-axis, with angular velocity 1, from the half-plane y = 0,
/// x > 0 (id 0), where (u,v) = (radius, z).
FlowResultFunction RotationFlow();

/// Returns the total area of triangles. If a cell array is named, only triangles with the given
/// value count.
double MeasureArea(vtkUnstructuredGrid* triangles, const char* array = nullptr, int value = 0);

/// Returns the total volume of tetrahedra, selected as in MeasureArea().
double MeasureVolume(vtkUnstructuredGrid* tetrahedra, const char* array = nullptr, int value = 0);

/// Returns the flux of a vector field through the triangles with the given value of the cell array.
/// Uses the field at the edge midpoints.
double MeasureFlux(vtkUnstructuredGrid* triangles,
  const std::function<std::array<double, 3>(const double* x)>& field, const char* array, int value);

}

#endif
