// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceContacts_h
#define interlume_SurfaceContacts_h

#include "Surfaces/ClosedSurface.h"

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   SurfaceContacts
 * @brief   finds where triangles of a surface touch each other, and splits them there
 *
 * TetGen requires triangles that meet in common points, edges or whole triangles only. Parts that
 * touch otherwise - a point on an edge or within a triangle, edges that cross in a plane, triangles
 * of one plane that overlap - are split: every touching place becomes a point of all triangles
 * there, and overlapping triangles of one plane are triangulated together, so that what is common
 * to them is there once. Touching is meant within a tolerance of rounding; points within it become
 * one.
 */
class SurfaceContacts
{
public:
  /// Takes a surface, which must outlive this object, and the distance that counts as touching.
  SurfaceContacts(ClosedSurface& surface, double tolerance);

  /// Finds the contacts. Returns whether there are any.
  bool Find();
  /// Returns the input cells of the first contact found.
  const std::array<vtkIdType, 2>& GetFirstCells() const { return this->FirstCells; }

  /// Splits the triangles at contacts. Returns an error if one cannot be split.
  Error Split();
  /// Returns the number of triangles that were split.
  vtkIdType GetNumberOfSplitTriangles() const { return this->NumberOfSplitTriangles; }

private:
  using Edge = std::array<int, 2>; ///< points in ascending order

  void FindInPair(int s, int t);
  /// Finds the corners of \a s that lie on \a t. \a distances are theirs from its plane.
  void FindPoints(int s, int t, const std::array<double, 3>& distances);
  void FindCrossings(int s, int t);
  /// Finds the edges of \a s that lie in the plane of \a t.
  void FindEdgesInside(int s, int t, const std::array<double, 3>& distances);
  /// Returns whether two triangles of one plane have an area in common.
  bool DoOverlap(int s, int t) const;
  void Note(int s, int t);
  int FindRoot(int t);
  /// Makes every crossing of edges a point of both.
  void AddCrossings();
  /// Returns the points of an edge from its first to its last.
  std::vector<int> PointsAlong(const Edge& edge) const;
  /// Splits triangles of one plane that overlap, or a single triangle.
  Error SplitTogether(const std::vector<int>& members);
  /// Takes the triangles that members cover. \a pieces has the members that a piece of an edge
  /// bounds.
  void TakeCovered(const class PlanarTriangulation& plane, const std::vector<int>& ids,
    const std::map<Edge, std::vector<int>>& pieces);

  /// Adds a part of triangle \a t to the split surface.
  void AddPart(int t, const std::array<int, 3>& points, int layers);
  const double* GetPoint(int p) const { return this->Surface.GetPoint(p); }
  int GetCorner(int t, int i) const;
  Edge GetEdge(int t, int i) const;
  bool HasCorner(int t, int p) const;
  glm::dvec3 GetNormal(int t) const;

  ClosedSurface& Surface;
  double Tolerance;
  std::array<vtkIdType, 2> FirstCells{ { -1, -1 } };
  vtkIdType NumberOfSplitTriangles = 0;
  std::map<int, int> Merged;                             ///< points that become an earlier one
  std::map<Edge, std::set<int>> PointsOnEdges;           ///< between the ends
  std::map<int, std::set<int>> PointsInside;             ///< of triangles
  std::map<int, std::set<Edge>> EdgesInside;             ///< of triangles, from others
  std::map<std::pair<Edge, Edge>, glm::dvec3> Crossings; ///< of edges
  std::vector<int> Parents; ///< of triangles that overlap in a plane: a path to the first one
  std::vector<ClosedSurface::Triangle> Result;
};

}

#endif
