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
 * @brief   extraction from ghost cells, so that pieces have the same output as the full grid
 *
 * If all values on a face equal an isovalue, the output on that face depends on the cells on both
 * sides. In this case ghost cells are extracted too, and their output is removed after the cleanup
 * of such faces. Otherwise ghost cells are not visited.
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

  /// Sets the ghost arrays in \a blanking to those of \a data. Leaves out a point ghost array that
  /// hides no points, since testing the points of every cell would be slow.
  static void SetBlanking(vtkDataSet* data, Blanking& blanking);

  /// Returns whether the value at any corner of a ghost cell equals an isovalue or is not finite.
  /// Used for unstructured grids.
  static bool HaveTies(const ExtractionContext& context);

  /// Same as HaveTies(), but for all cells outside a window of a structured grid, hidden or not.
  static bool HaveTiesOutside(
    const ExtractionContext& context, const int dimensions[3], const GridCellRange& window);

  /// Removes the output of ghost cells and counts these cells as blanked.
  static void Remove(const ExtractionContext& context, ExtractionMesh& mesh);
};

}

#endif
