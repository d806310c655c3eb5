// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkGridExchange_h
#define vtkGridExchange_h

/**
 * @class   vtkGridExchange
 * @brief   tests whether processes can send grids to each other
 *
 * VTK sends a grid between processes as XML with raw data appended. VTK before 9.3 cannot read this
 * with versions of expat that defer parsing (2.6, and 2.5 with the security update). See
 * https://gitlab.kitware.com/vtk/vtk/-/issues/19258.
 */
namespace vtkGridExchange
{
/// Returns true if grids can be sent. The first call tests this within this process: it serializes
/// and reads a grid that is larger than the parser's buffer.
bool IsPossible();
}

#endif
