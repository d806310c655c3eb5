// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ColorDilation_h
#define interlume_ColorDilation_h

#include "vtkType.h"

#include <algorithm>

namespace interlume
{

/**
 * Finds colours for points that have no density, from red, green, blue and density for each point.
 */
namespace ColorDilation
{
/**
 * Gives the points without density in rows first ... last - 1 of an extent the mean colour of those
 * of their 26 neighbours that have density. Only densities and the colours of points with density
 * are read, and neither is written, so that rows can be treated in any order.
 */
template <typename Value>
void DilateRows(Value* values, const int extent[6], vtkIdType first, vtkIdType last)
{
  const int size[3] = { extent[1] - extent[0] + 1, extent[3] - extent[2] + 1,
    extent[5] - extent[4] + 1 };
  for (vtkIdType row = first; row < last; ++row)
  {
    const int y = static_cast<int>(row % size[1]);
    const int z = static_cast<int>(row / size[1]);
    // The row itself and those around it, as far as there are any.
    const Value* rows[9];
    int number = 0;
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, size[2] - 1); ++k)
    {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size[1] - 1); ++j)
      {
        rows[number++] = values + (static_cast<vtkIdType>(k) * size[1] + j) * size[0] * 4;
      }
    }
    Value* written = values + row * size[0] * 4;
    for (int x = 0; x < size[0]; ++x)
    {
      if (written[4 * x + 3] > 0)
      {
        continue;
      }
      double sums[3] = { 0.0, 0.0, 0.0 };
      int count = 0;
      for (int r = 0; r < number; ++r)
      {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size[0] - 1); ++i)
        {
          const Value* value = rows[r] + static_cast<vtkIdType>(4) * i;
          if (value[3] > 0)
          {
            ++count;
            sums[0] += value[0];
            sums[1] += value[1];
            sums[2] += value[2];
          }
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        written[4 * x + c] = static_cast<Value>(count ? sums[c] / count : 0.0);
      }
    }
  }
}
}

}

#endif
