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
 * @brief   decomposes one cell into tetrahedra that preserve the triangles of its shell
 *
 * The first method that gives tetrahedra of positive volume is used:
 * 1. Connect a point of the cell to all triangles that do not contain the point. This succeeds for
 *    convex cells and adds no point.
 * 2. Run TetGen with preserved boundary, which may add points inside.
 * 3. Connect all triangles to a new point that sees each of them from inside.
 * If TetGen's tetrahedra are nearly degenerate, method 3 is used if it gives better ones.
 */
class CellDecomposition
{
public:
  explicit CellDecomposition(const CellShell& shell);

  /// Decomposes the cell. A canceled run returns no error and no tetrahedra.
  Error Execute(MeshingJob& job);

  /// Point indices of each tetrahedron. The points of the shell are numbered first, then NewPoints.
  std::vector<std::array<int, 4>> Tetrahedra;
  std::vector<double> NewPoints; ///< three per point

private:
  bool DecomposeFromPoint();
  /// Returns an error if TetGen's tetrahedra cannot be used.
  Error DecomposeWithTetGen(MeshingJob& job);
  bool DecomposeFromKernelPoint();
  bool FindKernelPoint(glm::dvec3& center) const;
  bool MatchesShell(const TetGenSolution& solution) const;
  /// Returns the minimum polar sine of the tetrahedra that connect \a apex to all triangles.
  double GetMinimumShape(const double* apex) const;

  const CellShell& Shell;
};

}

#endif
