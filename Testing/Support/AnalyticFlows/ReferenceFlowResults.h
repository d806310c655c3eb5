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
 * Analytic implicit flow fields, and the areas, volumes and fluxes of meshes extracted from them.
 */
namespace reference
{

/// How the streamline of a sample ends: status (see vtkFlowStatus), surface id, surface parameters
/// and time.
struct FlowResult
{
  int Status = 0;
  int Id = 0;
  double U = 0.0;
  double V = 0.0;
  double Time = 0.0;
};
using FlowResultFunction = std::function<FlowResult(const double* x)>;

/// Id of a termination surface, and two flags: whether its parameters u and v are periodic.
using FlowSurface = std::array<int, 3>;

/// Evaluates \a function at the points of \a data and adds the arrays of an implicit flow field.
void AddFlow(
  vtkDataSet* data, const FlowResultFunction& function, const std::vector<FlowSurface>& surfaces);

vtkSmartPointer<vtkImageData> MakeFlowImage(
  const std::array<int, 3>& points, const std::array<double, 6>& bounds);

/// Returns the uniform flow with velocity (speed, 0, 0) from the plane x = 0. The plane has id 0
/// and (u,v) = (y, z).
FlowResultFunction UniformFlow(double speed);
/// Returns the radial flow of speed 1 from a cylinder around the z-axis. The cylinder has id 0 and
/// (u,v) = (angle in turns, z). Streamlines of samples inside the cylinder do not reach it.
FlowResultFunction CylinderFlow(double radius);
/// Returns the radial flow of speed 1 from a sphere around the origin. The sphere has id 0 and
/// (u,v) = (longitude in turns, polar angle in half turns).
FlowResultFunction SphereFlow(double radius);
/// Returns the flow with velocity (x, -y, 0) from the planes y = 1 (id 0) and y = -1 (id 1), which
/// have (u,v) = (x, z). Streamlines of samples at y = 0 stagnate.
FlowResultFunction SaddleFlow();
/// Returns the rotation about the z-axis with angular velocity 1 from the half-plane y = 0, x > 0.
/// The half-plane has id 0 and (u,v) = (radius, z).
FlowResultFunction RotationFlow();

/// Returns the total area of the triangles whose value in the cell array is \a value, or of all
/// triangles if \a array is null.
double MeasureArea(vtkUnstructuredGrid* triangles, const char* array = nullptr, int value = 0);

/// Returns the total volume of tetrahedra, selected as in MeasureArea().
double MeasureVolume(vtkUnstructuredGrid* tetrahedra, const char* array = nullptr, int value = 0);

/// Returns the flux of a vector field through the triangles whose value in the cell array is \a
/// value. The field is evaluated at the edge midpoints.
double MeasureFlux(vtkUnstructuredGrid* triangles,
  const std::function<std::array<double, 3>(const double* x)>& field, const char* array, int value);

}

#endif
