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
 * @brief   points of a dataset, each place once
 *
 * Of points with equal coordinates the one of lowest id stands for all; nothing is taken for equal
 * that is not. The distinct points keep the order of their ids.
 */
class DistinctPoints
{
public:
  /**
   * Takes the points marked in \a isUsed. Returns an error if a point is not finite, or if there
   * are more points than TetGen can number.
   */
  Error Take(vtkDataSet* input, const std::vector<bool>& isUsed);

  std::vector<double> Coordinates;  ///< three a distinct point, in the unit below
  std::vector<vtkIdType> SourceIds; ///< the input point of each distinct point
  std::vector<int> Indices;         ///< of each input point; -1 for one that is not used
  vtkIdType NumberOfMerged = 0;
  int UnitExponent = 0; ///< the power of two above the largest extent
};

}

#endif
