// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Tetrahedra_h
#define interlume_Tetrahedra_h

#include "vtkType.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * The origin of the values of a point of the mesh: a weighted sum over up to four points of the
 * input. A point of the input itself has one, with weight 1.
 */
struct MeshedPoint
{
  std::array<vtkIdType, 4> Sources{ { 0, 0, 0, 0 } };
  std::array<double, 4> Weights{ { 1.0, 0.0, 0.0, 0.0 } };
  /// The number of sources that count; 0 where the values are those of the harmonic function.
  int NumberOfSources = 0;
};

/**
 * A mesh before it becomes a vtkUnstructuredGrid.
 */
struct Tetrahedra
{
  std::vector<double> Points; ///< three a point, in the unit below
  /// The unit of length is this power of two. It is near the size of the model, so that bounds and
  /// products of coordinates are within the range of double at any size.
  int UnitExponent = 0;
  std::vector<MeshedPoint> Origins;
  std::vector<vtkIdType> Tetrahedra; ///< four a tetrahedron
  std::vector<vtkIdType> Cells;      ///< the input cell of each tetrahedron, where there is one
  std::vector<int> Regions;          ///< the region of each tetrahedron, where there are some

  /// Drops the points that no tetrahedron has; the others keep their order.
  void RemoveUnusedPoints();
};

}

#endif
