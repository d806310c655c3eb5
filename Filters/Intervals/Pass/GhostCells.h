// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GhostCells_h
#define interlume_GhostCells_h

#include "Common/Blanking.h"

class vtkInformation;

namespace interlume
{

struct ExtractionContext;
struct ExtractionMesh;
struct GridCellRange;

/**
 * @class   GhostCells
 * @brief   extraction with ghost cells, so that a piece matches the full grid where values equal
 * isovalues
 *
 * If values equal an isovalue throughout a face, the output there depends on the cells on both
 * sides. In this case ghost cells are extracted too, and their output is removed after such faces
 * are resolved. Otherwise ghost cells are not visited.
 */
class GhostCells
{
public:
  /// Requests a layer of ghost cells from the input if the output requests one of several pieces.
  static void Request(vtkInformation* input, vtkInformation* output);

  /// Returns whether a cell is a ghost cell that is not hidden.
  static bool IsGhost(const Blanking& blanking, vtkIdType cell)
  {
    return blanking.IsCellBlanked(cell) && !blanking.IsCellHidden(cell);
  }

  /// Sets the ghost arrays of a dataset. The point ghost array is dropped if it hides no points,
  /// since testing points shared with other pieces would slow down every cell.
  static void SetBlanking(vtkDataSet* data, Blanking& blanking);

  /// Returns whether a value equals an isovalue, or is not finite, at a corner of a ghost cell.
  /// Extractions from structured grids check this themselves.
  static bool AreTied(const ExtractionContext& context);

  /// Same as AreTied(), but for all cells outside a window of a structured grid, including hidden
  /// cells.
  static bool AreTiedOutside(
    const ExtractionContext& context, const int dimensions[3], const GridCellRange& window);

  /// Removes the output of ghost cells and counts the cells as skipped.
  static void Remove(const ExtractionContext& context, ExtractionMesh& mesh);
};

}

#endif
