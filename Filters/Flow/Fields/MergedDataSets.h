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
 * @brief   datasets that meet in points of the same coordinates, as one unstructured grid
 */
namespace MergedDataSets
{
/**
 * Merges the cells that count (Blanking: not hidden, not refined, without hidden points, not
 * duplicates, whose originals are in another part) and their points, part by part in their order.
 * Points with the same coordinates, to the last bit, are one, with the values of the first. The
 * point and cell arrays are those that all parts have, by name, type and components; there are no
 * ghost arrays, since nothing is left that they would mark. Coordinates are float where all parts'
 * are.
 */
vtkSmartPointer<vtkUnstructuredGrid> Merge(const std::vector<vtkDataSet*>& parts);
}

}

#endif
