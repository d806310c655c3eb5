// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MergedDataSets_h
#define interlume_MergedDataSets_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   MergedDataSets
 * @brief   merges datasets that share point coordinates into an unstructured grid
 */
namespace MergedDataSets
{
/**
 * Merges the cells and their points, in the order of the parts. Hidden, refined and duplicate
 * cells, and cells with hidden points, are excluded (Blanking). Points with identical coordinates
 * become one point, which gets the values of the first.
 *
 * Point and cell arrays are kept if all parts have an array of the same name and number of
 * components; arrays of different types become double. Ghost arrays are removed. Coordinates are
 * float if all parts have float coordinates.
 */
vtkSmartPointer<vtkUnstructuredGrid> Merge(const std::vector<vtkDataSet*>& parts);
}

}

#endif
