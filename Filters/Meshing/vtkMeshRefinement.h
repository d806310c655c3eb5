#ifndef vtkMeshRefinement_h
#define vtkMeshRefinement_h

struct vtkMeshingJob;
struct vtkTetGenSolution;

/**
 * @class   vtkMeshRefinement
 * @brief   refines a mesh until the bounds hold
 *
 * TetGen's own improvement of a refined mesh can undo what the refinement reached, and a strict
 * bound is reached better from a mesh that holds a weaker one. So the mesh goes through TetGen
 * several times. The result of a pass is taken when tetrahedra of less volume in all exceed a bound
 * than before and none has become tiny or flat, as next to small angles. Otherwise, and where
 * TetGen fails, the last good mesh stays, and goes through TetGen with weaker bounds on its shape
 * as long as tetrahedra are too large.
 */
class vtkMeshRefinement
{
public:
  /// Refines \a mesh. Returns false when cancelled, or with an error of the job when the time is
  /// up.
  static bool Execute(vtkMeshingJob& job, vtkTetGenSolution& mesh);
};

#endif
