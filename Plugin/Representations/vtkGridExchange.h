// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkGridExchange_h
#define vtkGridExchange_h

/**
 * @class   vtkGridExchange
 * @brief   tells whether processes can send each other grids
 *
 * VTK sends a grid between processes as XML with raw bytes at its end. Before 9.3 it cannot read
 * that by an expat that defers what it parses (2.6, or 2.5 with that security update):
 * https://gitlab.kitware.com/vtk/vtk/-/issues/19258.
 */
namespace vtkGridExchange
{
/// Tries it once, with a grid that is larger than what the parser takes at a time, within this
/// process.
bool IsPossible();
}

#endif
