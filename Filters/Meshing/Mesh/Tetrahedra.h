// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Tetrahedra_h
#define interlume_Tetrahedra_h

#include "vtkType.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * Source points of a mesh point, and the weights for interpolating from their values. If the mesh
 * point is an input point, it is its own only source, with weight 1.
 */
struct PointSources
{
  std::array<vtkIdType, 4> Sources{ { 0, 0, 0, 0 } };
  std::array<double, 4> Weights{ { 1.0, 0.0, 0.0, 0.0 } };
  /// Number of sources in use; 0 if the value comes from the harmonic extension.
  int NumberOfSources = 0;
};

/**
 * Tetrahedral mesh before its conversion to a vtkUnstructuredGrid.
 */
struct Tetrahedra
{
  std::vector<double> Points; ///< three per point, in units of 2^UnitExponent
  /// The unit of length is 2^UnitExponent, close to the size of the model. This keeps bounds and
  /// products of coordinates within the range of double for any size.
  int UnitExponent = 0;
  std::vector<PointSources> Origins;
  std::vector<vtkIdType> Tetrahedra; ///< four per tetrahedron
  std::vector<vtkIdType> Cells; ///< input cell of each tetrahedron; empty unless cells are meshed
  std::vector<int> Regions;     ///< region of each tetrahedron; empty unless a surface is meshed

  /// Removes unused points. The other points keep their order.
  void RemoveUnusedPoints();
};

}

#endif
