// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VisibilityOrder_h
#define interlume_VisibilityOrder_h

#include "Mesh/TetrahedraMesh.h"
#include "Order/CentroidOrder.h"
#include "Order/EyeSides.h"
#include "Order/GapRelations.h"
#include "Order/VisibilitySearch.h"
#include "View/ViewRays.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   VisibilityOrder
 * @brief   tetrahedra in order of visibility, front to back
 *
 * Of two tetrahedra that share a face, that on the eye's side of it comes first (MPVO, P. Williams,
 * "Visibility-ordering meshed polyhedra", 1992). Where a line of sight leaves the mesh and enters
 * it again, as in a mesh that is not convex or of several pieces, the one it leaves by comes before
 * the one it enters by (R. Cook et al. 2004, after XMPVO, C. Silva et al. 1998): see GapRelations.
 * An order that keeps all these relations is exact along the line of sight of every pixel, inside
 * the mesh and outside, in perspective and in parallel. Among the orders that do, this is the one
 * that follows the order of centroids until a tetrahedron still has some in front of it, which are
 * then put out first: distance decides where no relation does.
 *
 * Where tetrahedra hide one another in a cycle there is no such order. Each strongly connected set
 * then is put out by centroid, after all in front of it and before all behind it, and
 * GetNumberOfTetrahedraInCycles says how many tetrahedra that were. All are put out, each once,
 * always. Tetrahedra that overlap in space have no order of visibility either; that is not detected
 * unless it makes a cycle.
 *
 * The order is the same for any number of threads.
 */
class VisibilityOrder
{
public:
  /**
   * Takes the data that do not depend on the view from a mesh, which the calls of Compute are then
   * given. Returns false beyond FaceAdjacency::MaximumNumberOfTetrahedra; nothing may be computed
   * then.
   */
  bool Build(const TetrahedraMesh& mesh);

  /**
   * Fills \a frontToBack with the numbers of all tetrahedra. Without pixels in \a rays only shared
   * faces are considered, which is exact for a convex mesh.
   */
  void Compute(
    const TetrahedraMesh& mesh, const ViewRays& rays, std::vector<std::uint32_t>& frontToBack);

  /// Returns the number of tetrahedra in cycles of visibility, in the last order computed.
  vtkIdType GetNumberOfTetrahedraInCycles() const { return this->InCycles; }
  /// Returns the number of pairs of tetrahedra that are related across a gap, in the last order
  /// computed; 0 for a convex mesh.
  vtkIdType GetNumberOfGapRelations() const { return this->Gaps.GetNumberOfRelations(); }

  /// Returns the bytes held.
  std::size_t GetBytes() const;

private:
  /// The data that do not depend on the view: see FaceAdjacency.
  std::vector<std::uint32_t> Twins;
  EyeSides Sides;
  CentroidOrder Centroid;
  GapRelations Gaps;
  VisibilitySearch Search;
  std::vector<unsigned char> InFront;
  std::vector<std::uint32_t> Centroids;
  vtkIdType InCycles = 0;
};

}

#endif
