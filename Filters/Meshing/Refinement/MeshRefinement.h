// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshRefinement_h
#define interlume_MeshRefinement_h

#include <string>

namespace interlume
{

struct MeshingJob;
struct TetGenSolution;

/**
 * @class   MeshRefinement
 * @brief   refines a mesh until the bounds hold
 *
 * TetGen's own improvement of a refined mesh can undo what the refinement reached, and a strict
 * bound is reached better from a mesh that holds a weaker one. So the mesh goes through TetGen
 * several times. The result is the mesh nearest to its bounds, see MeshMeasures::Excess. A pass
 * that makes tiny or flat tetrahedra, as next to small angles, is dropped, and so is one in which
 * TetGen fails; then weaker bounds on the shape are tried, as long as tetrahedra are too large.
 */
class MeshRefinement
{
public:
  /// Refines \a mesh. Returns that the time is up, or nothing; nothing where it was cancelled, too.
  static std::string Execute(MeshingJob& job, TetGenSolution& mesh);
};

}

#endif
