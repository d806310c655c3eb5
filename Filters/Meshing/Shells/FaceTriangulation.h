// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceTriangulation_h
#define interlume_FaceTriangulation_h

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   FaceTriangulation
 * @brief   splits a polygonal face into triangles, identically for both cells that share it
 *
 * The result depends only on the cyclic sequence of the points, their positions and a given strict
 * order of the points. It does not depend on the point at which the polygon starts or on its
 * direction. Therefore both cells that share a face get the same triangles.
 *
 * Shape quality is measured in the projection along the coordinate axis closest to the normal. The
 * fan from the first point in the strict order is used if its worst triangle is nearly as good as
 * possible. Otherwise, for example for concave polygons or collinear points, the triangulation
 * whose worst triangle is best is used. (In a non-planar face, a needle-shaped triangle of three
 * nearly collinear points could intersect the adjacent face.)
 *
 * A polygon that intersects itself or has no area is cleaned, where it returns along the same edge,
 * and split as well as possible, identically for both cells.
 */
class FaceTriangulation
{
public:
  using Triangle = std::array<vtkIdType, 3>;
  using Order = std::function<bool(vtkIdType, vtkIdType)>;

  /// Sets the function that returns the position of a point, and the strict order of the points.
  FaceTriangulation(std::function<glm::dvec3(vtkIdType)> getPoint, Order isBefore);

  /// Quality of a polygon: simple; cleaned, because it returned along an edge, or without area; or
  /// intersecting itself.
  enum class Result
  {
    Simple,
    Flat,
    Crossing
  };

  /**
   * Appends the triangles of \a polygon, with the orientation of the polygon. Consecutive equal
   * points count once. A polygon with fewer than three points adds no triangle. If the polygon is
   * not simple, some of its triangles may have no area or be inverted.
   */
  Result Triangulate(std::vector<vtkIdType> polygon, std::vector<Triangle>& triangles) const;

  const Order& GetOrder() const { return this->IsBefore; }

private:
  std::function<glm::dvec3(vtkIdType)> GetPoint;
  Order IsBefore;
};

}

#endif
