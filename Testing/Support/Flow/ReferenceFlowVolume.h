// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowVolume_h
#define ReferenceFlowVolume_h

#include "vtkSmartPointer.h" // for the meshes

#include <array>      // for positions
#include <functional> // for regions
#include <vector>     // for lists of positions

class vtkDataSet;
class vtkTerminationPlane;
class vtkUnstructuredGrid;

/**
 * Extracts flow volumes with default settings and measures them.
 */
namespace reference
{

/// Returns the square in the plane x = \a position with y and z from -5 to 5, u along y and v along
/// z.
vtkSmartPointer<vtkTerminationPlane> MakeWidePlane(double position);

/// Returns the flow volume of an implicit flow field, with double-precision points. Warnings are
/// allowed.
vtkSmartPointer<vtkUnstructuredGrid> ExtractFlow(vtkDataSet* samples);

/// Like ExtractFlow(), but omits the cells that ExtractFlow() cuts at surfaces and boundaries.
vtkSmartPointer<vtkUnstructuredGrid> ExtractUncutFlow(vtkDataSet* samples);

/// Returns the total volume of the tetrahedra whose centers satisfy \a isInside.
double MeasureVolumeIn(
  vtkUnstructuredGrid* mesh, const std::function<bool(const double*)>& isInside);

/// Returns a random position in each of \a boxes^3 boxes that fill the cube from -1 to 1.
std::vector<std::array<double, 3>> MakeRandomPositions(int boxes, unsigned int seed);

}

#endif
