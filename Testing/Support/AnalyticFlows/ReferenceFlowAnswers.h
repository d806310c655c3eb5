// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowAnswers_h
#define ReferenceFlowAnswers_h

#include "vtkSmartPointer.h" // for the images
#include "vtkType.h"         // for vtkIdType

#include <array>      // for bounds and points
#include <functional> // for answers
#include <vector>     // for surfaces

class vtkDataSet;
class vtkImageData;
class vtkUnstructuredGrid;

/**
 * Implicit flow fields of flows whose streamlines are known, and measures of what is made of them.
 */
namespace reference
{

/// What a sample's streamline comes to.
struct FlowAnswer
{
  int Status = 0;
  int Id = 0;
  double U = 0.0;
  double V = 0.0;
  double Time = 0.0;
};
using AnswerFunction = std::function<FlowAnswer(const double* x)>;

/// An id, and whether u and v are periodic.
using FlowSurface = std::array<int, 3>;

/// Gives \a data the arrays of an implicit flow field.
void AddFlow(
  vtkDataSet* data, const AnswerFunction& function, const std::vector<FlowSurface>& surfaces);

/// An image of \a points points over \a bounds.
vtkSmartPointer<vtkImageData> MakeFlowImage(
  const std::array<int, 3>& points, const std::array<double, 6>& bounds);

/// Uniform flow of \a speed along x, from the plane x = 0 with id 0 and (u,v) = (y,z).
AnswerFunction UniformFlow(double speed);
/// Flow outward along radii of the z-axis with speed 1, from a cylinder of id 0 with (u,v) = (angle
/// in turns, z). Samples inside of it have no answer.
AnswerFunction CylinderFlow(double radius);
/// The same around the origin, from a sphere; (u,v) = (longitude, polar angle) in turns and half
/// turns.
AnswerFunction SphereFlow(double radius);
/// The flow (x, -y, 0) from the planes y = 1 (id 0) and y = -1 (id 1), (u,v) = (x, z) there; y = 0
/// stagnates.
AnswerFunction SaddleFlow();
/// Rotation about the z-axis with angular speed 1 from the half-plane y = 0, x > 0 with id 0 and
/// (u,v) = (radius, z).
AnswerFunction RotationFlow();

/// The sum of the areas of triangles, those with a value of a cell array where one is named.
double MeasureArea(vtkUnstructuredGrid* triangles, const char* array = nullptr, int value = 0);

/// The sum of the volumes of tetrahedra, likewise.
double MeasureVolume(vtkUnstructuredGrid* tetrahedra, const char* array = nullptr, int value = 0);

/// The flux of a vector field through triangles with a value of a cell array, by its values at the
/// middles of the edges.
double MeasureFlux(vtkUnstructuredGrid* triangles,
  const std::function<std::array<double, 3>(const double* x)>& field, const char* array, int value);

}

#endif
