// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CriterionRange_h
#define interlume_CriterionRange_h

#include "vtkDataArray.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   CriterionRange
 * @brief   range of a criterion, to find the cells that overlap it
 */
class CriterionRange
{
public:
  /// \a arrays has the array of the criterion at each of one or two time steps.
  CriterionRange(std::vector<vtkDataArray*> arrays, double lower, double upper)
    : Arrays(std::move(arrays))
    , Lower(lower)
    , Upper(upper)
  {
  }

  /// Returns whether the values at the points of a cell, at all steps, overlap the range. NaN
  /// values are ignored.
  bool Overlaps(const vtkIdType* points, vtkIdType number) const
  {
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    for (vtkDataArray* array : this->Arrays)
    {
      for (vtkIdType p = 0; p < number; ++p)
      {
        const double value = array->GetComponent(points[p], 0);
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
      }
    }
    return minimum <= this->Upper && maximum >= this->Lower;
  }

private:
  std::vector<vtkDataArray*> Arrays;
  double Lower;
  double Upper;
};

}

#endif
