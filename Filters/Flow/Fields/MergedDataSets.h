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
 * The cells that count (Blanking: not hidden, not refined, without hidden points, not
 * duplicates, whose originals are in another part) and their points, part by part in their order.
 * Points with the same coordinates, to the last bit, are one, with the values of the first. The
 * point and cell arrays that all parts have, by name, type and components; no ghost arrays, nothing
 * being left that they would mark. Coordinates are float where all parts' are.
 */
vtkSmartPointer<vtkUnstructuredGrid> Merge(const std::vector<vtkDataSet*>& parts);
}

}

#endif
