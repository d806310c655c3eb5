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
 * @brief   closed triangle surface from the polygons of a dataset
 *
 * FaceTriangulation splits the polygons. Coincident points are merged, and collapsed and duplicate
 * triangles are removed. The surface is closed if each edge belongs to at least two triangles. An
 * edge belongs to more than two triangles where walls between regions meet.
 */
class ClosedSurface
{
public:
  struct Triangle
  {
    std::array<int, 3> Points; ///< indices of distinct points
    vtkIdType Cell = 0;        ///< last input cell with the triangle
    /// Number of input triangles that cover this triangle; more than 1 where parts of the surface
    /// touch.
    int Layers = 1;
    int Origin = -1; ///< index of an input triangle that contains it
    /// Index of the triangle's planar patch. A patch is a set of coplanar triangles connected by
    /// edges that belong to no other triangles.
    int Patch = -1;
  };

  ClosedSurface() = default;
  /// Creates a surface from \a triangles, which must already form a closed surface. They are given
  /// as three indices of \a points per triangle.
  ClosedSurface(const DistinctPoints& points, const std::vector<int>& triangles);

  /// Reads the polygons and splits them at contacts if \a splitContacts is true. Returns an error
  /// that names the offending cell or point.
  Error Take(vtkDataSet* input, bool splitContacts);
  /// Merges points: replaces each key of \a merged with its value. Removes triangles that collapse.
  void MergePoints(const std::map<int, int>& merged);

  /// Returns the TetGen problem for filling the surface. Its facets are the planar patches, or the
  /// single triangles if the boundary is preserved.
  TetGenProblem MakeProblem(bool preserveBoundary) const;

  const double* GetPoint(int p) const { return &this->Points.Coordinates[3 * p]; }
  /// Returns the normal of a triangle with the given points. Its length is twice the triangle's
  /// area.
  glm::dvec3 GetNormal(const std::array<int, 3>& points) const;

  DistinctPoints Points;
  std::vector<Triangle> Triangles;
  std::vector<Triangle> InputTriangles; ///< after merging points, before splitting
  vtkIdType NumberOfSplitTriangles = 0;
  /// The cells with polygons that were cleaned or have no area, once per polygon.
  std::vector<vtkIdType> FoldedCells;
  int NumberOfPatches = 0;

private:
  Error AddPolygons(vtkDataSet* input);
  /// Removes triangles without area. Their neighbors are split at their points, as contacts, or an
  /// error is returned if \a splitContacts is false.
  Error RemoveFlatTriangles(bool splitContacts);
  /// Replaces each point p by point targets[p], which is p or less, or removes it if that is -1.
  void ReplacePoints(const std::vector<int>& targets);
  void RemoveUnusedPoints();
  void RemoveDuplicates();
  Error SplitContacts(double tolerance, bool splitContacts);
  /// Checks that every edge has at least two triangles, and finds the patches.
  Error ConnectEdges();
  bool AreCoplanar(std::size_t triangle, std::size_t other) const;

  /// Maximum distance from a plane at which a point counts as lying in the plane.
  double Flatness = 0.0;
};

}

#endif
