// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceVolume_h
#define ReferenceVolume_h

#include "Support/Meshes/ReferenceField.h" // for linear functions

#include <array>  // for points
#include <vector> // for the bounds

class vtkDataSet;
class vtkUnstructuredGrid;

/**
 * Volumes in long double, made by clipping tetrahedra against one plane after another.
 */
namespace reference
{

/// One condition lower <= array <= upper.
struct Range
{
  const char* Array;
  double Lower;
  double Upper;
};

/// Six times the signed volume of a tetrahedron, positive when d sees a, b, c counterclockwise
/// from above.
long double Determinant(const std::array<long double, 3>& a, const std::array<long double, 3>& b,
  const std::array<long double, 3>& c, const std::array<long double, 3>& d);

/// Volumes of the tetrahedra of a grid.
struct TetrahedraVolume
{
  long double Sum = 0;           ///< of the signed volumes
  long double SumOfAbsolute = 0; ///< of their magnitudes
  long double Negative = 0;      ///< of the magnitudes of the negative ones
  long long Count = 0;
  long long Inverted = 0; ///< negative beyond rounding: below -1e-15 times the longest edge cubed
};
TetrahedraVolume MeasureTetrahedra(vtkUnstructuredGrid* grid);
/// The same of the tetrahedra with a value of the cell array IntervalId.
TetrahedraVolume MeasureInterval(vtkUnstructuredGrid* grid, int interval);

/// The volume of a mesh of convex cells, each cut into tetrahedra from its centre.
long double MeshVolume(vtkDataSet* mesh);

/**
 * The volume of the part of a mesh where every condition holds. Exact when the arrays are linear
 * in each cell: for any values on tetrahedra, for linear functions of position on convex cells.
 */
long double ClippedVolume(vtkDataSet* mesh, const std::vector<Range>& ranges);

/// The volume of { x in [0,size0] x [0,size1] x [0,size2] : function(x) <= value } by the formula
/// for a box cut by a plane. No component of the gradient is 0.
long double BoxVolumeBelow(
  const std::array<double, 3>& size, const LinearFunction& function, double value);

}

#endif
