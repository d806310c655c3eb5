// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DistinctPoints_h
#define interlume_DistinctPoints_h

#include "Common/Error.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   DistinctPoints
 * @brief   points of a dataset without duplicates
 *
 * Points are merged only if their coordinates are equal. The lowest point id represents the merged
 * points. The distinct points keep the order of their ids.
 */
class DistinctPoints
{
public:
  /**
   * Reads the points marked in \a isUsed. Returns an error if a point is not finite, or if TetGen
   * does not support that many points.
   */
  Error Take(vtkDataSet* input, const std::vector<bool>& isUsed);

  std::vector<double> Coordinates;  ///< three per distinct point, in units of 2^UnitExponent
  std::vector<vtkIdType> SourceIds; ///< the input point of each distinct point
  std::vector<int> Indices;         ///< index of each input point; -1 if unused
  vtkIdType NumberOfMerged = 0;
  int UnitExponent = 0; ///< exponent of a power of two above the largest extent
};

}

#endif
