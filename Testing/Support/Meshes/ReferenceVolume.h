// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceVolume_h
#define ReferenceVolume_h

#include "Support/Meshes/ReferenceField.h" // for linear functions

#include <array>  // for points
#include <vector> // for ranges

class vtkDataSet;
class vtkUnstructuredGrid;

/**
 * Volumes in long double, computed by clipping tetrahedra with one plane after another.
 */
namespace reference
{

/// The condition lower <= array <= upper.
struct Range
{
  const char* Array;
  double Lower;
  double Upper;
};

/// Returns six times the signed volume of a tetrahedron, which is positive if a, b, c are
/// counterclockwise seen from d.
long double Determinant(const std::array<long double, 3>& a, const std::array<long double, 3>& b,
  const std::array<long double, 3>& c, const std::array<long double, 3>& d);

/// Volumes of the tetrahedra of a grid.
struct TetrahedraVolume
{
  long double Sum = 0;           ///< sum of signed volumes
  long double SumOfAbsolute = 0; ///< sum of absolute volumes
  long double Negative = 0;      ///< sum of the absolute values of negative volumes
  long long Count = 0;
  long long Inverted =
    0; ///< number of volumes below -1e-15 * (longest edge)^3, which is more than rounding error
};
TetrahedraVolume MeasureTetrahedra(vtkUnstructuredGrid* grid);
/// Measures the tetrahedra with the given value of the cell array IntervalId.
TetrahedraVolume MeasureInterval(vtkUnstructuredGrid* grid, int interval);

/// Returns the volume of a mesh of convex cells. Each cell other than a tetrahedron is split into
/// tetrahedra around its center.
long double MeshVolume(vtkDataSet* mesh);

/**
 * Returns the volume of the region of a mesh where all conditions hold. The result is exact on
 * tetrahedra, and on other convex cells if the arrays are linear functions of position.
 */
long double ClippedVolume(vtkDataSet* mesh, const std::vector<Range>& ranges);

/// Returns the volume of { x in [0,size0] x [0,size1] x [0,size2] : function(x) <= value } in
/// closed form. No component of the gradient may be 0.
long double BoxVolumeBelow(
  const std::array<double, 3>& size, const LinearFunction& function, double value);

}

#endif
