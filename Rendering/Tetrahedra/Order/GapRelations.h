// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GapRelations_h
#define interlume_GapRelations_h

#include "Mesh/TetrahedraMesh.h"
#include "View/ViewRays.h"

#include <cstdint>
#include <vector>

namespace interlume
{

class EyeSides;

/**
 * @class   GapRelations
 * @brief   relations between tetrahedra where a line of sight leaves a mesh and enters it again
 *
 * The open faces of a mesh are drawn into a list for each pixel, sorted by depth; the tetrahedron
 * whose face the line of sight leaves the mesh by is in front of that whose face it enters by next
 * (R. Cook, N. Max, C. Silva, P. Williams, "Image-space visibility ordering for cell projection
 * volume rendering of unstructured data", 2004). So the order is right along the lines of sight of
 * all pixel centres, which are all that a picture consists of; two tetrahedra whose shared lines of
 * sight all pass between pixel centres are not related.
 *
 * Depths nearer to each other than 1e-9 of the mesh's radius count as equal: there a line of sight
 * leaves before it enters where it was inside, and the other way round where it was outside, so
 * that touching pieces and the outline of the mesh come out right whatever the rounding.
 */
class GapRelations
{
public:
  /// Finds all relations; none where \a rays have no pixels.
  void Compute(const TetrahedraMesh& mesh, const EyeSides& sides, const ViewRays& rays);

  /// Returns how many pairs were found, each counted once.
  std::uint32_t GetNumberOfRelations() const
  {
    return static_cast<std::uint32_t>(this->InFront.size());
  }
  ///@{
  /**
   * Return the tetrahedra in front of tetrahedron t, ascending: GetInFront()[GetOffsets()[t]] up
   * to, without it, GetInFront()[GetOffsets()[t + 1]]. Empty where there is no relation at all.
   */
  const std::vector<std::uint32_t>& GetOffsets() const { return this->Offsets; }
  const std::vector<std::uint32_t>& GetInFront() const { return this->InFront; }
  ///@}

  /// Returns the bytes held.
  std::size_t GetBytes() const;

private:
  std::vector<std::uint32_t> Offsets;
  std::vector<std::uint32_t> InFront;
};

}

#endif
