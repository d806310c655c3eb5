// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceGrid_h
#define ReferenceGrid_h

#include "Support/Meshes/ReferenceChain.h" // for the simplices

#include <string> // for differences
#include <vector> // for the lists

class vtkUnstructuredGrid;

/**
 * Reads and compares the outputs of extraction filters.
 */
namespace reference
{

/// Returns the tetrahedra with the given value of the cell array IntervalId.
std::vector<Tetrahedron> TetrahedraOf(vtkUnstructuredGrid* grid, int interval);

/// Returns the triangles on one side of an interval (0: lower, 1: upper).
std::vector<Triangle> BoundaryOf(vtkUnstructuredGrid* grid, int interval, int side);

std::vector<Triangle> TrianglesOf(vtkUnstructuredGrid* grid);

/// Returns the triangles with reversed orientation.
std::vector<Triangle> Reversed(std::vector<Triangle> triangles);

/// Returns whether every cell has the given type and every point id is valid.
bool IsValid(vtkUnstructuredGrid* grid, int type);

/// A simplex, represented by the sign of its orientation, the sorted coordinates of its points, and
/// its values in cell arrays. Equal simplices compare equal even if two grids number points and
/// cells differently.
using GeometricSimplex = std::vector<double>;

/// Returns the sorted simplices of a grid. \a cellArrays are the names of one-component numeric
/// cell arrays. \a fourth is the name of a point array that is used as the fourth coordinate, or
/// empty. Throws std::invalid_argument if an array is missing.
std::vector<GeometricSimplex> GeometricSet(vtkUnstructuredGrid* grid,
  const std::vector<std::string>& cellArrays = {}, const std::string& fourth = "");

/// Returns a description of the first difference between two grids, or an empty string if points,
/// cells and arrays are bit-identical.
std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

}

#endif
