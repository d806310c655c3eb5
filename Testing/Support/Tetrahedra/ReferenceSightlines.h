// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSightlines_h
#define ReferenceSightlines_h

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

/// A view with a name.
struct View
{
  std::string Name;
  interlume::ViewRays Rays;
};
/// A view from \a eye toward \a target, or in parallel along that line.
interlume::ViewRays LookAt(
  const glm::dvec3& eye, const glm::dvec3& target, double halfSize, int pixels, bool isParallel);
/// Views of the cube [-0.5, 0.5]^3 from outside, within, and along its axes; \a hole: one more
/// place to look from.
std::vector<View> GetViews(int pixels, const glm::dvec3& hole);

/// What an order of tetrahedra was found to do along some lines of sight.
struct OrderErrors
{
  /// Consecutive tetrahedra on a line of sight, and those that are in the wrong order.
  long long Pairs = 0;
  long long Wrong = 0;
  /// Consecutive tetrahedra that overlap: the mesh is not one.
  long long Overlaps = 0;
};

/**
 * @class   Sightlines
 * @brief   intersects lines of sight with all tetrahedra of a mesh, one by one
 */
class Sightlines
{
public:
  explicit Sightlines(const interlume::TetrahedraMesh& mesh);
  std::uint32_t GetNumberOfTetrahedra() const
  {
    return static_cast<std::uint32_t>(this->Planes.size() / 4);
  }

  /// Along the lines of sight through \a number pixel centres, the middle one and random ones.
  OrderErrors CheckPixels(const interlume::ViewRays& rays,
    const std::vector<std::uint32_t>& frontToBack, int number, unsigned int seed) const;
  /// Along \a number random lines of sight in the picture.
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

  // Four for each tetrahedron, with the outward unit normal.
  std::vector<Plane> Planes;
};

/// What the orders of several views were found to do.
struct OrderTally
{
  int Orders = 0;
  /// Orders with cycles, which are not looked at.
  int Cyclic = 0;
  /// Along lines of sight through the middles of pixels.
  long long Pairs = 0;
};

/**
 * Checks the visibility order that was computed for a view of a mesh: each tetrahedron once, no
 * cycles but where there may be some, and, where there are none, along \a lines lines of sight
 * through pixels. Returns whether there are none.
 */
bool CheckOrder(const Sightlines& sightlines, const interlume::VisibilityOrder& visibility,
  const interlume::ViewRays& rays, const std::vector<std::uint32_t>& order, int lines,
  bool mayBeCyclic, OrderTally& tally, Check& check);

/// Whether \a order has each number below \a number once.
bool IsPermutation(const std::vector<std::uint32_t>& order, std::uint32_t number);

}

#endif
