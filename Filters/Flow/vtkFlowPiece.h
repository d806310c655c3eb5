#ifndef vtkFlowPiece_h
#define vtkFlowPiece_h

class vtkInformation;
class vtkUnstructuredGrid;

/**
 * @class   vtkFlowPiece
 * @brief   the part of a whole grid that a piece of the output is
 */
namespace vtkFlowPiece
{
/// Leaves the cells of the piece that \a info asks for, as many in each, and their points, in
/// their order. The whole grid, with points of no cell, where one piece is asked for.
void Extract(vtkInformation* info, vtkUnstructuredGrid* grid);

/// Whether \a info asks for the whole output, not for one piece of several.
bool IsWhole(vtkInformation* info);
}

#endif
