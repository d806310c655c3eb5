// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OutputPiece_h
#define interlume_OutputPiece_h

class vtkInformation;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   OutputPiece
 * @brief   reduces a complete grid to the requested piece, and requests complete inputs
 */
namespace OutputPiece
{
/// Reduces the grid to the cells of the piece requested by \a info and to the points of these
/// cells, in their original order. All pieces have about the same number of cells. If there is only
/// one piece, the grid keeps all its points, including unused ones.
void Extract(vtkInformation* info, vtkUnstructuredGrid* grid);

/// Returns true if \a info requests the complete output, not one piece of several.
bool IsEntireOutput(vtkInformation* info);

/// Requests a complete input. \a info is the information of the input.
void RequestEntireInput(vtkInformation* info);
}

}

#endif
