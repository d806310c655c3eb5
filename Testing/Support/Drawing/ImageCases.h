// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageCases_h
#define ImageCases_h

#include "Support/Images/CameraSettings.h" // for points
#include "Support/Images/ReferenceRay.h"   // for view rays

#include <array>  // for vectors
#include <string> // for names
#include <vector> // for layer positions

class vtkUnstructuredGrid;

/**
 * Tetrahedral meshes and arrays for rendering tests.
 */
namespace reference
{

/// Returns the unit cube, divided into cells^3 boxes of five tetrahedra each. Points are in double
/// precision. The active scalars are `f` = 0.1 + 0.5 x + 0.3 y + 0.1 z, from 0.1 to 1.
vtkSmartPointer<vtkUnstructuredGrid> MakeCube(int cells);

/// Returns the unit cube with the given number of boxes along each axis, each split into six
/// tetrahedra. The scalars are `f` of MakeCube().
vtkSmartPointer<vtkUnstructuredGrid> MakeBox(const std::array<int, 3>& cells);

/// Returns a mesh over the unit square with one layer between consecutive values of \a z. Each
/// layer has cells^2 boxes of five tetrahedra. The scalars are `f` of MakeCube().
vtkSmartPointer<vtkUnstructuredGrid> MakeLayers(int cells, const std::vector<double>& z);

/// Moves every point p to origin + scale * stretch * p. Vectors are multiplied componentwise.
void MovePoints(vtkUnstructuredGrid* grid, const Point3& origin, double scale,
  const Point3& stretch = { { 1.0, 1.0, 1.0 } });

/// Adds a point array whose value at each point p is constant + gradient . p.
void AddLinearArray(
  vtkUnstructuredGrid* grid, const std::string& name, double constant, const Point3& gradient);

/// Adds a cell array with the index of the slab that contains the cell's center. The bounds are
/// divided into \a slabs equal slabs along the axis.
void AddSlabIndices(vtkUnstructuredGrid* grid, const std::string& name, int axis, int slabs);

/// Returns the length of the part of a view ray inside the bounds of a grid.
double GetChordLength(vtkUnstructuredGrid* grid, const Ray& ray);

}

#endif
