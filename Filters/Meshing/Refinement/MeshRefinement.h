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
 * The first call passes all bounds to TetGen together with the facets. A later refinement has no
 * information about small angles between facets and would not terminate next to such angles.
 * TetGen's mesh optimization can undo part of its refinement, so a mesh that misses a bound is
 * refined again, several times. The result is the mesh with the smallest MeshMeasures::Excess. A
 * pass is rejected if it generates tiny or degenerate tetrahedra or if TetGen fails. Weaker quality
 * bounds are then tried as long as tetrahedra are too large. Finally, VolumeBisection splits the
 * tetrahedra that are still too large.
 */
class MeshRefinement
{
public:
  /// Solves \a problem within the bounds, or within weaker bounds if TetGen fails, and refines the
  /// result. If TetGen fails again, refines \a mesh instead. Returns an error if \a mesh is then
  /// empty or if the time limit is exceeded. A canceled run returns no error.
  static Error Execute(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& mesh);
};

}

#endif
