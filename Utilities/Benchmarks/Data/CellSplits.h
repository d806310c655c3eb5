// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellSplits_h
#define CellSplits_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

/**
 * Splits the cells of \a image into tetrahedra of positive volume and retains the point scalars.
 * Tetrahedra of neighboring cells match at their common face. \a pieces is the number of tetrahedra
 * per cell:
 * - 5: one in the center and one at every other corner, mirrored from cell to cell;
 * - 6: around the diagonal from the first to the last corner.
 *
 * Throws std::invalid_argument if \a pieces is neither 5 nor 6.
 */
vtkSmartPointer<vtkUnstructuredGrid> SplitIntoTetrahedra(vtkImageData* image, int pieces);

#endif
