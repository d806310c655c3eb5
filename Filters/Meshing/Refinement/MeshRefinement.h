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
 * @brief   refines a mesh until the bounds hold
 *
 * TetGen gets all bounds together with the facets. A mesh that it refines later has lost the small
 * angles between them, and next to these it would not end. Its own improvement of a refined mesh
 * can undo what the refinement reached, so a mesh that misses a bound goes through TetGen again,
 * several times. The result is the mesh nearest to its bounds, see MeshMeasures::Excess. A pass
 * that makes tiny or flat tetrahedra is dropped, and so is one in which TetGen fails; then weaker
 * bounds on the shape are tried, as long as tetrahedra are too large. VolumeBisection splits
 * tetrahedra that are too large after that.
 */
class MeshRefinement
{
public:
  /// Solves \a problem within the bounds. If TetGen fails, refines \a mesh, or if that is empty, a
  /// mesh within weaker bounds. Returns an error if there is no mesh or the time is up. A canceled
  /// run has no error.
  static Error Execute(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& mesh);
};

}

#endif
