// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceViewRays_h
#define ReferenceViewRays_h

#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"
#include "View/ViewRays.h"

#include <string>
#include <vector>

namespace interlume
{
class VisibilityOrder;
}

namespace reference
{

class Check;

/// A named view.
struct View
{
  std::string Name;
  interlume::ViewRays Rays;
};
/// Returns a perspective or parallel view from \a eye toward \a target.
interlume::ViewRays LookAt(
  const glm::dvec3& eye, const glm::dvec3& target, double halfSize, int pixels, bool isParallel);
/// Returns views of the cube [-0.5, 0.5]^3 from outside, from inside, along an axis, and from
/// the point \a hole.
std::vector<View> GetViews(int pixels, const glm::dvec3& hole);

/// Errors of a visibility order along view rays.
struct OrderErrors
{
  /// Number of pairs of consecutive tetrahedra on view rays.
  long long Pairs = 0;
  /// Number of pairs in the wrong order.
  long long Misordered = 0;
  /// Number of pairs that overlap along the ray, which means that the mesh is invalid.
  long long Overlaps = 0;
};

/**
 * @class   ViewRayCheck
 * @brief   checks visibility orders by intersecting view rays with all tetrahedra of a mesh
 */
class ViewRayCheck
{
public:
  explicit ViewRayCheck(const interlume::TetrahedraMesh& mesh);
  std::uint32_t GetNumberOfTetrahedra() const
  {
    return static_cast<std::uint32_t>(this->Planes.size() / 4);
  }

  /// Checks the order along view rays through the centers of \a number pixels: the central pixel
  /// and random pixels.
  OrderErrors CheckPixels(const interlume::ViewRays& rays,
    const std::vector<std::uint32_t>& frontToBack, int number, unsigned int seed) const;
  /// Checks the order along \a number random view rays.
  OrderErrors CheckRandom(const interlume::ViewRays& rays,
    const std::vector<std::uint32_t>& frontToBack, int number, unsigned int seed) const;

private:
  struct Plane
  {
    glm::dvec3 Normal;
    double Offset;
  };

  void CheckLine(const interlume::ViewRays& rays, double x, double y,
    const std::vector<std::uint32_t>& ranks, OrderErrors& errors) const;

  // Four planes for each tetrahedron, with outward unit normals.
  std::vector<Plane> Planes;
};

/// Totals over the visibility orders of several views.
struct OrderTally
{
  int Orders = 0;
  /// Number of orders with cycles, which are not checked along view rays.
  int Cyclic = 0;
  /// Number of checked pairs of consecutive tetrahedra on view rays.
  long long Pairs = 0;
};

/**
 * Checks the visibility order of a view of a mesh: each tetrahedron occurs once, there are no
 * cycles unless \a mayBeCyclic, and without cycles the order is correct along \a lines view rays
 * through pixels. Returns whether the order has no cycles.
 */
bool CheckOrder(const ViewRayCheck& viewRays, const interlume::VisibilityOrder& visibility,
  const interlume::ViewRays& rays, const std::vector<std::uint32_t>& order, int lines,
  bool mayBeCyclic, OrderTally& tally, Check& check);

/// Returns whether \a order contains each integer in [0, \a number) exactly once.
bool IsPermutation(const std::vector<std::uint32_t>& order, std::uint32_t number);

}

#endif
