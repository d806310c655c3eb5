// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClosestTrianglePoint_h
#define interlume_ClosestTrianglePoint_h

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ClosestTrianglePoint
 * @brief   point of a triangle nearest to a given point, and the feature on which it lies
 *
 * See C. Ericson, "Real-Time Collision Detection", 2005, section 5.1.5.
 */
struct ClosestTrianglePoint
{
  /// Features of a triangle: corner i is FIRST_CORNER + i, and the edge from corner i to the next
  /// corner is FIRST_EDGE + i.
  enum Features
  {
    FACE = 0,
    FIRST_CORNER = 1,
    FIRST_EDGE = 4
  };

  ClosestTrianglePoint() = default;
  ClosestTrianglePoint(
    const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

  bool IsCorner() const { return this->Feature >= FIRST_CORNER && this->Feature < FIRST_EDGE; }
  bool IsEdge() const { return this->Feature >= FIRST_EDGE; }

  int Feature = FACE;
  glm::dvec3 Weights{ 0.0, 0.0, 0.0 };
  glm::dvec3 Point{ 0.0, 0.0, 0.0 };
  double SquaredDistance = 0.0;
};

}

#endif
