// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowVolume_h
#define ReferenceFlowVolume_h

#include "vtkSmartPointer.h" // for the meshes

#include <array>      // for places
#include <functional> // for regions
#include <vector>     // for places

class vtkDataSet;
class vtkTerminationPlane;
class vtkUnstructuredGrid;

/**
 * Flow volumes with all default settings, and their size.
 */
namespace reference
{

/// The plane x = \a place from -5 to 5 in y and z, u along y and v along z.
vtkSmartPointer<vtkTerminationPlane> MakeWidePlane(double place);

/// The flow volume of samples in double precision; it may warn.
vtkSmartPointer<vtkUnstructuredGrid> ExtractFlow(vtkDataSet* samples);

/// The same without the cells that are cut at surfaces and boundaries.
vtkSmartPointer<vtkUnstructuredGrid> ExtractUncutFlow(vtkDataSet* samples);

/// The volume of the tetrahedra whose center is in a region.
double MeasureVolumeIn(
  vtkUnstructuredGrid* mesh, const std::function<bool(const double*)>& isInside);

/// A random place in each of \a boxes^3 boxes that fill the cube from -1 to 1.
std::vector<std::array<double, 3>> MakeRandomPlaces(int boxes, unsigned int seed);

}

#endif
