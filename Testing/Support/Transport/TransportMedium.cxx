// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/TransportMedium.h"

#include <algorithm>
#include <stdexcept>

namespace reference
{

void TransportMedium::SetCells(const glm::dvec3& lower, const glm::dvec3& upper,
  const std::array<int, 3>& counts, std::vector<ExtinctionRange> ranges)
{
  if (ranges.size() != static_cast<std::size_t>(counts[0]) * counts[1] * counts[2])
  {
    throw std::invalid_argument("the number of extinction ranges differs from the number of cells");
  }
  this->Lower = lower;
  this->Upper = upper;
  this->Size = (upper - lower) / glm::dvec3(counts[0], counts[1], counts[2]);
  this->Counts = counts;
  this->Ranges = std::move(ranges);
}

bool TransportMedium::Clip(const TransportRay& ray, double& begin, double& end) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = ray.Direction[axis];
    const double below = this->Lower[axis] - ray.Origin[axis];
    const double above = this->Upper[axis] - ray.Origin[axis];
    if (step == 0.0)
    {
      if (below > 0.0 || above < 0.0)
      {
        return false;
      }
      continue;
    }
    begin = std::max(begin, std::min(below / step, above / step));
    end = std::min(end, std::max(below / step, above / step));
  }
  return begin < end;
}

}
