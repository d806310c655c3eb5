// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellSplits_h
#define CellSplits_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

/**
 * Splits the cells of \a image into tetrahedra of positive volume that match at all faces, and
 * passes the point scalars. \a pieces is the number of tetrahedra per cell:
 * - 5: one in the center and one at every other corner, mirrored from cell to cell;
 * - 6: around the diagonal from the first to the last corner.
 * Throws std::invalid_argument for other numbers.
 */
vtkSmartPointer<vtkUnstructuredGrid> SplitIntoTetrahedra(vtkImageData* image, int pieces);

#endif
