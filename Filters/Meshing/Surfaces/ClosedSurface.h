// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClosedSurface_h
#define interlume_ClosedSurface_h

#include "Common/Error.h"
#include "Mesh/DistinctPoints.h"
#include "TetGen/TetGenProblem.h"

#include <array>
#include <map>

#include <glm/vec3.hpp>

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
  struct Triangle
  {
    std::array<int, 3> Points; ///< indices of distinct points
    vtkIdType Cell = 0;        ///< the last input cell that has it
    /// The number of input triangles that it is a part of: parts that touch share it.
    int Layers = 1;
    int Origin = -1; ///< the input triangle that it is a part of
    /// Its planar patch, counted from 0: triangles of one plane, connected by edges that no other
    /// triangle has.
    int Patch = -1;
  };

  ClosedSurface() = default;
  /// Takes closed triangles of \a points.
  ClosedSurface(const DistinctPoints& points, const std::vector<int>& triangles);

  /// Takes the polygons, split at contacts if \a splitContacts. Returns an error that
  /// names the cell or point.
  Error Take(vtkDataSet* input, bool splitContacts);
  /// Makes points one: each key of \a merged becomes its value. Drops triangles that collapse.
  void MergePoints(const std::map<int, int>& merged);

  /// Returns the problem to fill the surface. The triangles of a patch are one facet, or where the
  /// boundary is preserved, each stays.
  TetGenProblem MakeProblem(bool preserveBoundary) const;

  const double* GetPoint(int p) const { return &this->Points.Coordinates[3 * p]; }
  /// Returns the normal of three points, as long as twice the area of their triangle.
  glm::dvec3 GetNormal(const std::array<int, 3>& points) const;

  DistinctPoints Points;
  std::vector<Triangle> Triangles;
  std::vector<Triangle> InputTriangles; ///< before splitting, with merged points
  vtkIdType NumberOfSplitTriangles = 0;
  int NumberOfPatches = 0;

private:
  Error AddPolygons(vtkDataSet* input);
  Error CheckAreas() const;
  void DropRepeated();
  Error SplitContacts(double tolerance, bool splitContacts);
  /// Checks that every edge has two triangles, and finds the patches.
  Error ConnectEdges();
  bool AreCoplanar(std::size_t triangle, std::size_t other) const;

  /// The distance from a plane at which a point is still in it.
  double Flatness = 0.0;
};

}

#endif
