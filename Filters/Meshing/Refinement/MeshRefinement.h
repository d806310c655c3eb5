// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshRefinement_h
#define interlume_MeshRefinement_h

#include "Common/Error.h"

namespace interlume
{

struct MeshingJob;
struct TetGenProblem;
struct TetGenSolution;

/**
 * @class   MeshRefinement
 * @brief   refines a mesh until the bounds are met
 *
 * The first TetGen call gets the facets and all bounds, because refinement of an existing mesh has
 * no information about small angles between facets and would not terminate next to them. TetGen's
 * mesh optimization can undo part of its refinement, so a mesh that misses a bound is refined again
 * in several passes. The result is the mesh with the smallest MeshMeasures::Excess. A pass is
 * rejected if it generates tiny or degenerate tetrahedra or if TetGen fails. Weaker quality bounds
 * are then tried as long as tetrahedra are too large. Finally, VolumeBisection splits the
 * tetrahedra that are still too large.
 */
class MeshRefinement
{
public:
  /// Solves \a problem within the bounds, or within weaker bounds if TetGen fails, and refines the
  /// result. If TetGen fails again, refines the given \a mesh instead. Returns an error if TetGen
  /// fails and the given \a mesh is empty, or if the time limit is exceeded. A canceled run returns
  /// no error.
  static Error Execute(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& mesh);
};

}

#endif
