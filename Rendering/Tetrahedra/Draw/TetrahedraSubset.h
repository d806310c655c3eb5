// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraSubset_h
#define interlume_TetrahedraSubset_h

#include "Frame/TetrahedraFrame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   TetrahedraSubset
 * @brief   selects a subset of the tetrahedra that looks like the mesh
 *
 * Tetrahedra are ranked by priority sampling (N. Duffield, C. Lund, M. Thorup, "Priority sampling
 * for estimation of arbitrary subset sums", 2007). The importance of a tetrahedron is the integral
 * of its optical depth over its projection: volume times extinction times extent in time. The rank
 * is a hash of its index, divided by its importance. A subset is the first tetrahedra by rank, so
 * each subset contains all smaller ones.
 *
 * Each tetrahedron of a subset represents a number of tetrahedra that follows from the ranks. It is
 * enlarged by this factor, so the mean optical depth of every region remains unchanged. Enlarging
 * causes less noise than multiplying extinction. Tetrahedra are not enlarged past the mesh's
 * bounding box; instead, their extent in time increases. A tetrahedron with a boundary triangle is
 * enlarged so that the mean area of the triangles remains unchanged.
 *
 * The subset does not depend on the view or on the number of threads.
 */
class TetrahedraSubset
{
public:
  /**
   * Sets \a mesh and \a fields to a subset of at most \a number tetrahedra of \a frame. Returns
   * false if they are already up to date. Each tetrahedron has its own four points.
   */
  bool Update(const TetrahedraFrame& frame, std::uint32_t number, TetrahedraMesh& mesh,
    TetrahedraFields& fields);

  std::size_t GetBytes() const
  {
    return (this->Ranked.capacity() + this->Keys.capacity()) * sizeof(std::uint32_t);
  }

private:
  using Box = std::array<std::array<double, 3>, 2>;

  /// A tetrahedron of the mesh, and the number of tetrahedra that it represents.
  struct Member
  {
    std::uint32_t Tetrahedron;
    double Weight;
  };

  /// Finds the first \a number tetrahedra by rank and the next one.
  void Rank(const TetrahedraFrame& frame, std::uint32_t number);
  /// Returns the first \a number tetrahedra by rank, in the order of their indices. They are close
  /// in memory to their neighbors in this order.
  std::vector<Member> Select(std::uint32_t number) const;
  /// Sets the points and extents in time of a tetrahedron of \a mesh.
  void Enlarge(const TetrahedraFrame& frame, const Member& member, std::uint32_t tetrahedron,
    TetrahedraMesh& mesh, TetrahedraFields& fields) const;

  /// State of the last update.
  TetrahedraFrame::Changes Versions{ -1, -1, -1, -1, -1, -1 };
  TetrahedraFrame::Blends Blend = TetrahedraFrame::COMPOSITE;
  float SurfaceOpacity = 0.0f;
  std::uint32_t Number = 0;

  /// Tetrahedra with the smallest ranks by index, and their ranks as the bits of floats.
  std::vector<std::uint32_t> Ranked;
  std::vector<std::uint32_t> Keys;
  std::uint32_t NumberRanked = 0;
  Box Bounds{};
};

}

#endif
