// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClosedSurface_h
#define interlume_ClosedSurface_h

#include "Mesh/DistinctPoints.h"
#include "TetGen/TetGenProblem.h"

#include <map>

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
  ClosedSurface() = default;
  /// Takes closed triangles of \a points.
  ClosedSurface(const DistinctPoints& points, const std::vector<int>& triangles);

  /// Takes the polygons, split at contacts if \a splitContacts. Returns what is wrong, naming the
  /// cell or point, or nothing.
  std::string Take(vtkDataSet* input, bool splitContacts);
  /// Makes points one: each key of \a merged becomes its value. Drops triangles that collapse.
  void MergePoints(const std::map<int, int>& merged);

  /// Returns the problem to fill the surface. The triangles of a patch are one facet, or where the
  /// boundary is preserved, each stays.
  TetGenProblem MakeProblem(bool preserveBoundary) const;

  DistinctPoints Points;
  std::vector<int> Triangles;     ///< three indices of distinct points a triangle
  std::vector<vtkIdType> CellIds; ///< the last input cell that has each triangle
  /// The number of input triangles that each triangle is a part of: parts that touch share it.
  std::vector<int> Layers;
  /// The input triangle that each triangle is a part of, and the points of those.
  std::vector<int> Origins;
  std::vector<int> InputTriangles;
  vtkIdType NumberOfSplitTriangles = 0;
  /// The planar patch of each triangle, counted from 0: triangles of one plane, connected by edges
  /// that no other triangle has.
  std::vector<int> Patches;
  int NumberOfPatches = 0;

private:
  std::string AddPolygons(vtkDataSet* input);
  std::string CheckAreas() const;
  void DropRepeated();
  std::string SplitContacts(double tolerance, bool splitContacts);
  /// Checks that every edge has two triangles, and finds the patches.
  std::string ConnectEdges();
  bool AreCoplanar(std::size_t triangle, std::size_t other) const;

  /// The distance from a plane at which a point is still in it.
  double Flatness = 0.0;
};

}

#endif
