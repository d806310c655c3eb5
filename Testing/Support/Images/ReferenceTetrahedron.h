// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTetrahedron_h
#define ReferenceTetrahedron_h

#include "Support/Images/ReferenceRay.h" // for view rays

#include <array>    // for corners
#include <optional> // for segments

namespace reference
{

/// Barycentric coordinates of a point.
using Barycentric = std::array<Real, 4>;

/**
 * The interval of a view ray inside a tetrahedron, in distances along the ray.
 */
struct Segment
{
  Real Entry;
  Real Exit;
  Barycentric AtEntry;
  Barycentric AtExit;
};

/**
 * @class   RayTetrahedron
 * @brief   tetrahedron for intersections with view rays
 *
 * The segment is the interval where all four barycentric coordinates, which are linear along the
 * ray, are >= 0. The coordinates are evaluated near the tetrahedron, and their gradients are
 * computed from differences of corners. Therefore, segments of thin tetrahedra far away are as
 * accurate as those of regular tetrahedra.
 */
class RayTetrahedron
{
public:
  explicit RayTetrahedron(const std::array<Vector, 4>& corners);

  /// Returns whether the volume is not 0 and all coordinates are finite.
  bool IsValid() const { return this->Valid; }
  const std::array<Vector, 4>& GetCorners() const { return this->Corners; }

  /// Returns the segment of the ray inside the tetrahedron, clipped to two distances, or
  /// std::nullopt if it is empty.
  std::optional<Segment> Meet(const Ray& ray, Real from, Real to) const;

private:
  std::array<Vector, 4> Corners;
  std::array<Vector, 4> Gradients; ///< gradients of the barycentric coordinates
  bool Valid;
};

}

#endif
