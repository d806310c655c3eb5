// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellDecomposition_h
#define interlume_CellDecomposition_h

#include "Common/Error.h"
#include "Common/Vectors.h"

#include <array>
#include <vector>

namespace interlume
{

class CellShell;
struct MeshingJob;
struct TetGenSolution;

/**
 * @class   CellDecomposition
 * @brief   the tetrahedra of one cell, with just the triangles of its shell outside
 *
 * It is the first of these that gives tetrahedra of positive volume: 1. the tetrahedra from one of
 * its points to all triangles that do not touch it, as for every
 *    convex cell: no new point;
 * 2. TetGen, with the boundary preserved: new points inside where it needs some;
 * 3. the tetrahedra from a new point that sees every triangle from within.
 * Where TetGen's are flat to rounding, the third comes before the second.
 */
class CellDecomposition
{
public:
  explicit CellDecomposition(const CellShell& shell);

  /// Decomposes the cell. A canceled run has no error and no tetrahedra.
  Error Execute(MeshingJob& job);

  /// The corners as indices of points: the shell's, then the new ones.
  std::vector<std::array<int, 4>> Tetrahedra;
  std::vector<double> NewPoints; ///< three a point

private:
  bool TakeFromPoint();
  /// Returns an error if TetGen's tetrahedra cannot be used.
  Error TakeFromTetGen(MeshingJob& job);
  bool TakeFromCenter();
  bool FindCenter(glm::dvec3& center) const;
  bool HasShell(const TetGenSolution& solution) const;
  /// Returns the least sine of a solid angle among the tetrahedra from a place to all triangles.
  double GetLeastShape(const double* apex) const;

  const CellShell& Shell;
};

}

#endif
