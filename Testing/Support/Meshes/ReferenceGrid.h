// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceGrid_h
#define ReferenceGrid_h

#include "Support/Meshes/ReferenceChain.h" // for the simplices

#include <string> // for differences
#include <vector> // for the lists

class vtkUnstructuredGrid;

/**
 * Access to the outputs of extractions, and comparison of outputs.
 */
namespace reference
{

/// Returns the tetrahedra with the given value of the cell array IntervalId.
std::vector<Tetrahedron> TetrahedraOf(vtkUnstructuredGrid* grid, int interval);

/// Returns the triangles of an interval and a side (0 lower, 1 upper).
std::vector<Triangle> BoundaryOf(vtkUnstructuredGrid* grid, int interval, int side);

std::vector<Triangle> TrianglesOf(vtkUnstructuredGrid* grid);

/// Returns the triangles with reversed orientation.
std::vector<Triangle> Reversed(std::vector<Triangle> triangles);

/// Returns whether every cell has the given type and every point id is valid.
bool IsValid(vtkUnstructuredGrid* grid, int type);

/// A simplex as the sign of its orientation, the sorted coordinates of its points, and the values
/// of cell arrays. Equal simplices compare equal even if two grids number points and cells
/// differently.
using GeometricSimplex = std::vector<double>;

/// Returns the sorted simplices of a grid. \a cellArrays are one-component numeric cell arrays. \a
/// fourth is a point array that is used as a fourth coordinate, or empty. Throws
/// std::invalid_argument if an array is missing.
std::vector<GeometricSimplex> GeometricSet(vtkUnstructuredGrid* grid,
  const std::vector<std::string>& cellArrays = {}, const std::string& fourth = "");

/// Returns the first difference between two grids, or an empty string if points, cells and arrays
/// are bit-identical.
std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

}

#endif
