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
 * @brief   cuts a polygon into triangles, the same whichever cell asks
 *
 * The triangles depend on the cyclic sequence of the points, their places and their order alone:
 * not on where the list starts, nor on its direction. So two cells agree on the face they share.
 *
 * All is measured in the projection along the polygon's main axis. The fan from the point of lowest
 * order is taken if its worst triangle is not much worse than it has to be; otherwise, as for
 * concave polygons and those with points on a line, the triangles whose worst one is best are
 * taken. (A needle between three points nearly on a line would, in a face that is not planar, stand
 * up against the next face.)
 */
class FaceTriangulation
{
public:
  using Triangle = std::array<vtkIdType, 3>;
  using Order = std::function<bool(vtkIdType, vtkIdType)>;

  /// Takes functions: \a getPoint gives the place of a point, \a isBefore is the strict order of
  /// the points.
  FaceTriangulation(std::function<glm::dvec3(vtkIdType)> getPoint, Order isBefore);

  /**
   * Appends the triangles of \a polygon, oriented as it is. Repeated points next to each other
   * count once, and what is left with fewer than three gives nothing. Returns false, with nothing
   * appended, where the polygon meets itself or has no area.
   */
  bool Triangulate(std::vector<vtkIdType> polygon, std::vector<Triangle>& triangles) const;

  const Order& GetOrder() const { return this->IsBefore; }

private:
  std::function<glm::dvec3(vtkIdType)> GetPoint;
  Order IsBefore;
};

}

#endif
