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
 * @brief   finds and splits triangles that touch each other
 *
 * TetGen requires that triangles meet only in common points, edges or entire triangles. This class
 * handles the other contacts: a point on an edge or inside a triangle, coplanar edges that cross,
 * and overlapping coplanar triangles. Each contact point becomes a vertex of all triangles that
 * contain it. Overlapping coplanar triangles are triangulated together so that their common area
 * has one set of triangles. Contacts are found within a tolerance for rounding errors, and points
 * within the tolerance are merged.
 */
class SurfaceContacts
{
public:
  /// Sets the surface, which must outlive this object, and the contact tolerance.
  SurfaceContacts(ClosedSurface& surface, double tolerance);

  /// Finds the contacts. Returns whether any exist.
  bool Find();
  /// Returns the input cells of the contact with the lowest cell ids.
  const std::array<vtkIdType, 2>& GetFirstCells() const { return this->FirstCells; }

  /// Splits the triangles at contacts. Returns an error if a triangle cannot be split.
  Error Split();
  vtkIdType GetNumberOfSplitTriangles() const { return this->NumberOfSplitTriangles; }

private:
  using Edge = std::array<int, 2>; ///< point indices in ascending order

  void FindPairContacts(int s, int t);
  /// Finds the corners of triangle \a s that lie on triangle \a t. \a distances are the distances
  /// of the corners from the plane of \a t.
  void FindPoints(int s, int t, const std::array<double, 3>& distances);
  void FindCrossings(int s, int t);
  /// Finds the edges of triangle \a s that lie in the plane of triangle \a t.
  void FindEdgesInside(int s, int t, const std::array<double, 3>& distances);
  /// Returns whether two coplanar triangles overlap.
  bool DoOverlap(int s, int t) const;
  void RecordContact(int s, int t);
  int FindRoot(int t);
  /// Adds each crossing of two edges as a point to both edges.
  void AddCrossings();
  /// Returns the points on an edge in their order along the edge, including its ends.
  std::vector<int> PointsAlong(const Edge& edge) const;
  /// Splits a set of overlapping coplanar triangles, or a single triangle.
  Error SplitCoplanarTriangles(const std::vector<int>& members);
  /// Adds each triangle of \a plane that is covered by one or more overlapping triangles to the
  /// result. \a pieces lists, for each edge segment, the overlapping triangles that it bounds.
  void AddCoveredTriangles(const class PlanarTriangulation& plane, const std::vector<int>& ids,
    const std::map<Edge, std::vector<int>>& pieces);

  /// Adds a part of triangle \a t to the result. \a layers input triangles cover the part.
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
  std::map<int, int> Merged;                   ///< points merged with an earlier point
  std::map<Edge, std::set<int>> PointsOnEdges; ///< points between the ends
  std::map<int, std::set<int>> PointsInside;   ///< points inside triangles
  std::map<int, std::set<Edge>> EdgesInside;   ///< edges of other triangles inside triangles
  std::map<std::pair<Edge, Edge>, glm::dvec3> Crossings; ///< crossings of two edges
  std::vector<int> Parents; ///< union-find parents of overlapping coplanar triangles
  std::vector<ClosedSurface::Triangle> Result;
};

}

#endif
