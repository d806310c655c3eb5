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
 * @brief   finds where the coordinates of a rectilinear grid are not strictly monotonic
 *
 * The first and the last coordinate determine whether the coordinates must ascend or descend.
 * Coordinates that are not finite are ignored.
 */
struct AxisCheck
{
  /// Number of steps between successive coordinates that reverse the direction or have zero length.
  vtkIdType Number = 0;
  /// Index of the coordinate at the end of the first such step, or -1.
  vtkIdType First = -1;

  /// Checks the first \a number coordinates. \a number must be positive.
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

  /// Describes the first step that reverses the direction or has zero length, as a clause. \a axis
  /// is 0, 1 or 2.
  std::string Describe(int axis, vtkDataArray* coordinates) const
  {
    std::ostringstream words;
    words << "the "
          << "xyz"[axis] << " coordinates are not strictly monotonic at index " << this->First
          << " (" << coordinates->GetComponent(this->First, 0) << " after "
          << coordinates->GetComponent(this->First - 1, 0) << ")";
    return words.str();
  }
};

}

#endif
