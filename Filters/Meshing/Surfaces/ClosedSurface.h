// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClosedSurface_h
#define interlume_ClosedSurface_h

#include "Mesh/DistinctPoints.h"

#include <array>

namespace interlume
{

/**
 * @class   ClosedSurface
 * @brief   the polygons of a dataset as a closed surface of triangles
 *
 * Polygons are cut by FaceTriangulation. Points in the same place are one; triangles that
 * this collapses are left out, and of equal triangles one is kept. What remains is closed where no
 * edge belongs to one triangle alone; edges of more than two are walls between regions.
 */
class ClosedSurface
{
public:
  /// Takes the polygons. Returns what is wrong, naming the cell or point, or nothing.
  std::string Take(vtkDataSet* input);

  DistinctPoints Points;
  std::vector<int> Triangles;     ///< three indices of distinct points a triangle
  std::vector<vtkIdType> CellIds; ///< the input cell of each triangle
  /// The planar patch of each triangle, counted from 0: triangles of one plane, connected by edges
  /// that no other triangle has.
  std::vector<int> Patches;
  int NumberOfPatches = 0;

private:
  std::string AddPolygons(vtkDataSet* input);
  std::string CheckAreas() const;
  void DropRepeated();
  /// Checks that every edge has two triangles, and finds the patches.
  std::string ConnectEdges();
  bool AreCoplanar(std::size_t triangle, std::size_t other) const;
};

}

#endif
