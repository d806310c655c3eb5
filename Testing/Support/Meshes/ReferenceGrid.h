// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceGrid_h
#define ReferenceGrid_h

#include "Support/Meshes/ReferenceChain.h" // for the simplices

#include <string> // for differences
#include <vector> // for the lists

class vtkUnstructuredGrid;

/**
 * Reading and comparing the output of an extraction.
 */
namespace reference
{

/// The tetrahedra with a value of the cell array IntervalId.
std::vector<Tetrahedron> TetrahedraOf(vtkUnstructuredGrid* grid, int interval);

/// The triangles of one interval and one side (0 lower, 1 upper).
std::vector<Triangle> BoundaryOf(vtkUnstructuredGrid* grid, int interval, int side);

/// All triangles of a grid.
std::vector<Triangle> TrianglesOf(vtkUnstructuredGrid* grid);

/// The same triangles with the other side up.
std::vector<Triangle> Reversed(std::vector<Triangle> triangles);

/// Whether every cell is of a type and every point id is one of the grid.
bool IsValid(vtkUnstructuredGrid* grid, int type);

/// A simplex as the sorted coordinates of its points, the sign of its orientation, and the values
/// of cell arrays: equal for two grids that number their points and cells differently.
using GeometricSimplex = std::vector<double>;

/// The simplices of a grid, sorted. \a cellArrays are numeric cell arrays with one component,
/// \a fourth a point array whose value is a coordinate of the points too, where it is not empty;
/// std::invalid_argument where one is missing.
std::vector<GeometricSimplex> GeometricSet(vtkUnstructuredGrid* grid,
  const std::vector<std::string>& cellArrays = {}, const std::string& fourth = "");

/// Empty when both grids have the same points, cells and arrays bit for bit; else the first
/// difference.
std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

}

#endif
