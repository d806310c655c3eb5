// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GhostCells_h
#define interlume_GhostCells_h

#include "Common/Blanking.h"

class vtkInformation;

namespace interlume
{

struct ExtractionContext;
struct ExtractionMesh;
struct GridWindow;

/**
 * @class   GhostCells
 * @brief   the cells around a piece, by which it ends as the whole does where values equal
 * isovalues
 *
 * Where values equal an isovalue throughout a face, what is there depends on the cells on both
 * sides. So a piece is extracted with the cells around it, and leaves out what comes of them once
 * that is settled. Elsewhere they are not looked at.
 */
class GhostCells
{
public:
  /// Asks the input for a layer of ghost cells where one piece of several is asked of the output.
  static void Request(vtkInformation* input, vtkInformation* output);

  /// Returns whether a cell is another piece's, and counts there.
  static bool IsOne(const Blanking& blanking, vtkIdType cell)
  {
    return blanking.IsCellBlanked(cell) && !blanking.IsCellHidden(cell);
  }

  /// Takes the ghost arrays of a dataset, without that of its points where it hides none: points
  /// that other pieces have too are looked at in every cell otherwise.
  static void SetBlanking(vtkDataSet* data, Blanking& blanking);

  /// Returns whether a value equals an isovalue, or is not finite, at a corner of a ghost cell.
  /// Extraction from grids of rows finds that by itself, in passing.
  static bool AreTied(const ExtractionContext& context);

  /// Returns the same of the cells of a grid beyond a window, be they ghost cells or hidden.
  static bool AreTiedBeyond(
    const ExtractionContext& context, const int dimensions[3], const GridWindow& window);

  /// Leaves out what comes of ghost cells, and counts these as left out.
  static void Remove(const ExtractionContext& context, ExtractionMesh& mesh);
};

}

#endif
