// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVFieldExtent.h"

#include <algorithm>

void vtkPVFieldExtent::GetEnds(double length, const double bounds[6], const double center[3],
  const double along[3], double ends[2])
{
  const bool isEmpty = bounds[0] > bounds[1] || bounds[2] > bounds[3] || bounds[4] > bounds[5];
  if (length != 0.0 || isEmpty)
  {
    const double half = 0.5 * (length != 0.0 ? length : 1.0);
    ends[0] = -half;
    ends[1] = half;
    return;
  }
  ends[0] = 0.0;
  ends[1] = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double low = (bounds[2 * i] - center[i]) * along[i];
    const double high = (bounds[2 * i + 1] - center[i]) * along[i];
    ends[0] += std::min(low, high);
    ends[1] += std::max(low, high);
  }
}
