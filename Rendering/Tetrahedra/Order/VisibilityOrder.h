// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VisibilityOrder_h
#define interlume_VisibilityOrder_h

#include "Mesh/TetrahedraMesh.h"
#include "Order/CentroidOrder.h"
#include "Order/FrontNeighbors.h"
#include "Order/GapRelations.h"
#include "Order/VisibilitySearch.h"
#include "View/ViewRays.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   VisibilityOrder
 * @brief   sorts tetrahedra in visibility order, front to back
 *
 * Of two tetrahedra that share a face, the tetrahedron on the camera's side of the face is first
 * (MPVO; P. Williams, "Visibility-ordering meshed polyhedra", 1992). Across a gap, where a view ray
 * exits the mesh and enters it again, the tetrahedron of the exit is first (R. Cook et al. 2004,
 * after XMPVO, C. Silva et al. 1998): see GapRelations. An order that satisfies all relations is
 * exact along the view ray of every pixel, inside and outside the mesh, in perspective and in
 * parallel projection. Among these orders, this one follows the centroid order as far as possible:
 * a tetrahedron is moved forward only if it must be in front of an earlier one.
 *
 * If tetrahedra hide one another in a cycle, no such order exists. Each strongly connected
 * component is then sorted by centroid, and placed behind all tetrahedra in front of it. All
 * tetrahedra are output exactly once. Tetrahedra that overlap in space have no visibility order
 * either. This is detected only if it creates a cycle.
 *
 * The order does not depend on the number of threads.
 */
class VisibilityOrder
{
public:
  /**
   * Computes the data that do not depend on the view. Pass the same mesh to Compute(). Returns
   * false for more than FaceAdjacency::MaximumNumberOfTetrahedra; do not call Compute() then.
   */
  bool Build(const TetrahedraMesh& mesh);

  /**
   * Fills \a frontToBack with the indices of all tetrahedra. If \a rays has no pixels, only shared
   * faces are considered, which is exact for a convex mesh. Returns false if \a isAborted, which is
   * called between stages, returned true.
   */
  bool Compute(const TetrahedraMesh& mesh, const ViewRays& rays,
    std::vector<std::uint32_t>& frontToBack, const std::function<bool()>& isAborted = nullptr);

  /// Returns the number of tetrahedra in visibility cycles, in the last order.
  vtkIdType GetNumberOfTetrahedraInCycles() const { return this->InCycles; }
  /// Returns the number of relations across gaps in the last order; 0 for a convex mesh.
  vtkIdType GetNumberOfGapRelations() const { return this->Gaps.GetNumberOfRelations(); }

  /// Returns the memory size in bytes.
  std::size_t GetBytes() const;

private:
  /// Twins of all faces, from FaceAdjacency.
  std::vector<std::uint32_t> Twins;
  FrontNeighbors Sides;
  CentroidOrder Centroid;
  GapRelations Gaps;
  VisibilitySearch Search;
  std::vector<unsigned char> InFront;
  std::vector<std::uint32_t> Centroids;
  vtkIdType InCycles = 0;
};

}

#endif
