#ifndef vtkCellDecomposition_h
#define vtkCellDecomposition_h

#include <array>
#include <string>
#include <vector>

class vtkCellShell;
struct vtkMeshingJob;

/**
 * @class   vtkCellDecomposition
 * @brief   the tetrahedra of one cell, with just the triangles of its shell outside
 *
 * The first of these that gives tetrahedra of positive volume:
 * 1. the tetrahedra from one of its points to all triangles that do not touch it, as for every
 *    convex cell: no new point;
 * 2. TetGen, with the boundary preserved: new points inside where it needs some;
 * 3. the tetrahedra from a new point that sees every triangle from within.
 * Where TetGen's are flat to rounding, the third comes before the second.
 */
class vtkCellDecomposition
{
public:
  explicit vtkCellDecomposition(const vtkCellShell& shell);

  /// Returns what is wrong, or nothing; cancelled, there are no tetrahedra.
  std::string Execute(vtkMeshingJob& job);

  /// Indices of points: the shell's, then the new ones.
  std::vector<std::array<int, 4>> Tetrahedra;
  std::vector<double> NewPoints; ///< three a point

private:
  bool TakeFromPoint();
  bool TakeFromTetGen(vtkMeshingJob& job);
  bool TakeFromCenter();
  bool FindCenter(std::array<double, 3>& center) const;
  bool HasShell(const std::vector<int>& tetrahedra, const std::vector<int>& neighbors) const;
  /// The least sine of a solid angle among the tetrahedra from a place to all triangles.
  double GetLeastShape(const double* apex) const;

  const vtkCellShell& Shell;
};

#endif
