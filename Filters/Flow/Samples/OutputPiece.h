// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OutputPiece_h
#define interlume_OutputPiece_h

class vtkInformation;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   OutputPiece
 * @brief   the part of a whole grid that a piece of the output is
 */
namespace OutputPiece
{
/// Reduces the grid to the cells of the piece that \a info asks for, as many in each, and their
/// points, in their order. The grid stays whole, with points of no cell, where one piece is asked
/// for.
void Extract(vtkInformation* info, vtkUnstructuredGrid* grid);

/// Returns whether \a info asks for the whole output, not for one piece of several.
bool IsWhole(vtkInformation* info);
}

}

#endif
