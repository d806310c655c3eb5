// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTetrahedron_h
#define ReferenceTetrahedron_h

#include "Support/Images/ReferenceRay.h" // for view rays

#include <array>    // for corners
#include <optional> // for segments

namespace reference
{

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
 * @brief   intersects a tetrahedron with view rays
 *
 * All four barycentric coordinates, which are linear along the ray, are >= 0 on the segment inside
 * the tetrahedron. The coordinates are evaluated near the tetrahedron, and their gradients are
 * computed from differences between corners. Therefore, the segments of thin tetrahedra far away
 * are as accurate as those of regular tetrahedra.
 */
class RayTetrahedron
{
public:
  explicit RayTetrahedron(const std::array<Vector, 4>& corners);

  /// Returns whether the volume is not 0 and all coordinates are finite.
  bool IsValid() const { return this->Valid; }
  const std::array<Vector, 4>& GetCorners() const { return this->Corners; }

  /// Returns the segment of the ray inside the tetrahedron, clipped to the distances [from, to], or
  /// std::nullopt if it is empty.
  std::optional<Segment> Meet(const Ray& ray, Real from, Real to) const;

private:
  std::array<Vector, 4> Corners;
  std::array<Vector, 4> Gradients; ///< gradients of the barycentric coordinates
  bool Valid;
};

}

#endif
