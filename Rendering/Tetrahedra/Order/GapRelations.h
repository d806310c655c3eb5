// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GapRelations_h
#define interlume_GapRelations_h

#include "Mesh/TetrahedraMesh.h"
#include "View/ViewRays.h"

#include <cstdint>
#include <vector>

namespace interlume
{

class FrontNeighbors;

/**
 * @class   GapRelations
 * @brief   relates tetrahedra across gaps, where a view ray exits a mesh and enters it again
 *
 * The open faces of the mesh are rasterized into a list for each pixel, sorted by depth. The
 * tetrahedron at which the view ray exits is in front of the tetrahedron at which it enters next
 * (R. Cook, N. Max, C. Silva, P. Williams, "Image-space visibility ordering for cell projection
 * volume rendering of unstructured data", 2004). The order is therefore correct along the view rays
 * of all pixel centers. Tetrahedra that overlap on the screen only between pixel centers are not
 * related.
 *
 * Depths that differ by less than 1e-9 of the mesh's radius are treated as equal. Of an entry and
 * an exit at equal depths, the exit is first if the ray was inside the mesh, and the entry is first
 * if it was outside. Touching pieces and the outline of the mesh are therefore handled correctly
 * despite rounding.
 */
class GapRelations
{
public:
  /// Finds all relations. There are none if \a rays has no pixels.
  void Compute(const TetrahedraMesh& mesh, const FrontNeighbors& sides, const ViewRays& rays);

  /// Returns the number of related pairs, without duplicates.
  std::uint32_t GetNumberOfRelations() const
  {
    return static_cast<std::uint32_t>(this->InFront.size());
  }
  ///@{
  /**
   * The tetrahedra in front of tetrahedron t are GetInFront()[i], ascending, for i from
   * GetOffsets()[t] to GetOffsets()[t + 1] - 1. Both arrays are empty if there are no relations.
   */
  const std::vector<std::uint32_t>& GetOffsets() const { return this->Offsets; }
  const std::vector<std::uint32_t>& GetInFront() const { return this->InFront; }
  ///@}

  /// Returns the memory size in bytes.
  std::size_t GetBytes() const;

private:
  std::vector<std::uint32_t> Offsets;
  std::vector<std::uint32_t> InFront;
};

}

#endif
