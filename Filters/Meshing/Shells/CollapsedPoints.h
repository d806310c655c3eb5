// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CollapsedPoints_h
#define interlume_CollapsedPoints_h

#include "Shells/FaceTriangulation.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   CollapsedPoints
 * @brief   coincident points within cells, such as those of collapsed faces
 *
 * Points of different cells that coincide, as at a crack, remain distinct unless a cell has both.
 */
class CollapsedPoints
{
public:
  /// Returns the point that replaces each point, or an empty list if the points of each of the
  /// given cells are distinct. Points that are merged become the first of them in the given order.
  /// \a number receives the number of points that were replaced.
  static std::vector<vtkIdType> Find(vtkDataSet* input, const std::vector<vtkIdType>& cells,
    const FaceTriangulation::Order& isBefore, vtkIdType& number);
};

}

#endif
