// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AxisCheck_h
#define interlume_AxisCheck_h

#include "vtkDataArray.h"

#include <cmath>
#include <sstream>
#include <string>

namespace interlume
{

/**
 * @class   AxisCheck
 * @brief   finds where coordinates along an axis of a rectilinear grid turn back or repeat
 *
 * Coordinates may ascend or descend, as from the first to the last one. Coordinates that are not
 * finite are ignored.
 */
struct AxisCheck
{
  /// The number of steps from one coordinate to the next that turn back or repeat.
  vtkIdType Number = 0;
  /// The coordinate at the end of the first of these steps, or -1.
  vtkIdType First = -1;

  /// Checks the first \a number coordinates, at least one.
  static AxisCheck Find(vtkDataArray* coordinates, vtkIdType number)
  {
    AxisCheck found;
    const double range = coordinates->GetComponent(number - 1, 0) - coordinates->GetComponent(0, 0);
    for (vtkIdType i = 1; i < number; ++i)
    {
      const double step = coordinates->GetComponent(i, 0) - coordinates->GetComponent(i - 1, 0);
      if (std::isfinite(step) && !(range < 0.0 ? step < 0.0 : step > 0.0))
      {
        found.First = found.Number == 0 ? i : found.First;
        ++found.Number;
      }
    }
    return found;
  }

  /// Describes the first of these steps, a part of a sentence; \a axis is 0, 1 or 2.
  std::string Describe(int axis, vtkDataArray* coordinates) const
  {
    std::ostringstream words;
    words << "the coordinates along "
          << "xyz"[axis] << " turn back or repeat at number " << this->First << " ("
          << coordinates->GetComponent(this->First, 0) << " after "
          << coordinates->GetComponent(this->First - 1, 0) << ")";
    return words.str();
  }
};

}

#endif
