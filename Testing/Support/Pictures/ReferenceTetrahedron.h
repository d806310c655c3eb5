// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTetrahedron_h
#define ReferenceTetrahedron_h

#include "Support/Pictures/ReferenceRay.h" // for lines of sight

#include <array>    // for corners
#include <optional> // for segments

namespace reference
{

/// The four barycentric coordinates of a point.
using Barycentric = std::array<Real, 4>;

/**
 * The part of a line of sight that lies within a tetrahedron, in distances along it.
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
 * @brief   a tetrahedron, to be met by lines of sight
 *
 * The segment is where all four barycentric coordinates, each linear along the line, are >= 0. They
 * are taken near the tetrahedron, and their gradients from differences of corners, so that thin
 * tetrahedra far away are met as well as regular ones.
 */
class RayTetrahedron
{
public:
  explicit RayTetrahedron(const std::array<Vector, 4>& corners);

  /// Whether there is a volume, and no coordinate is NaN or infinite.
  bool IsValid() const { return this->Valid; }
  const std::array<Vector, 4>& GetCorners() const { return this->Corners; }

  /// The segment between two distances along the line; nothing where it is empty.
  std::optional<Segment> Meet(const Ray& ray, Real from, Real to) const;

private:
  std::array<Vector, 4> Corners;
  std::array<Vector, 4> Gradients; ///< of the barycentric coordinates
  bool Valid;
};

}

#endif
