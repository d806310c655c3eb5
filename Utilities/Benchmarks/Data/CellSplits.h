// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellSplits_h
#define CellSplits_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

/**
 * The cells of \a image as tetrahedra of positive volume that match at every face, with the point
 * scalars. \a pieces of a cell:
 * - 5, a tetrahedron in the middle and one at every other corner, mirrored from cell to cell;
 * - 6, around the diagonal from the first corner to the last.
 * Throws std::invalid_argument for another number.
 */
vtkSmartPointer<vtkUnstructuredGrid> SplitIntoTetrahedra(vtkImageData* image, int pieces);

#endif
