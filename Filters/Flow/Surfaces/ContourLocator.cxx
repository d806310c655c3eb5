// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/ContourLocator.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

ContourLocator::ContourLocator(std::vector<Curve> curves, std::array<bool, 2> isPeriodic)
  : Curves(std::move(curves))
  , IsPeriodic(isPeriodic)
  , Bins(static_cast<std::size_t>(NumberOfBins) * NumberOfBins)
{
  for (int c = 0; c < static_cast<int>(this->Curves.size()); ++c)
  {
    const std::vector<Parameters>& points = this->Curves[c].Points;
    for (int s = 0; s + 1 < static_cast<int>(points.size()); ++s)
    {
      const auto getRange = [&](int direction) {
        return std::minmax({ GetBin(points[s][direction]), GetBin(points[s + 1][direction]) });
      };
      const auto u = getRange(0);
      const auto v = getRange(1);
      for (int j = v.first; j <= v.second; ++j)
      {
        for (int i = u.first; i <= u.second; ++i)
        {
          this->Bins[this->WrapBin(j, 1) * NumberOfBins + this->WrapBin(i, 0)].push_back({ c, s });
        }
      }
    }
  }
}

int ContourLocator::GetBin(double parameter)
{
  return static_cast<int>(std::floor(parameter * NumberOfBins));
}

int ContourLocator::WrapBin(int bin, int direction) const
{
  return this->IsPeriodic[direction] ? (bin % NumberOfBins + NumberOfBins) % NumberOfBins
                                     : std::max(0, std::min(bin, NumberOfBins - 1));
}

void ContourLocator::Compare(
  const Parameters& location, int curve, int segment, Nearest& nearest) const
{
  const Parameters& from = this->Curves[curve].Points[segment];
  const Parameters& to = this->Curves[curve].Points[segment + 1];
  double offset[2];
  double step[2];
  for (int direction = 0; direction < 2; ++direction)
  {
    step[direction] = to[direction] - from[direction];
    offset[direction] = location[direction] - from[direction];
    offset[direction] -=
      this->IsPeriodic[direction] ? std::round(offset[direction] - 0.5 * step[direction]) : 0.0;
  }
  const double length2 = step[0] * step[0] + step[1] * step[1];
  double along = length2 > 0.0 ? (offset[0] * step[0] + offset[1] * step[1]) / length2 : 0.0;
  along = std::max(0.0, std::min(along, 1.0));
  const double distance2 =
    std::pow(offset[0] - along * step[0], 2) + std::pow(offset[1] - along * step[1], 2);
  const std::pair<int, int> segments[2] = { { curve, segment },
    { nearest.Best.Curve, nearest.Segment } };
  if (distance2 < nearest.Distance2 ||
    (distance2 == nearest.Distance2 && segments[0] < segments[1]))
  {
    const std::vector<double>& lengths = this->Curves[curve].Lengths;
    nearest.Distance2 = distance2;
    nearest.Segment = segment;
    nearest.Best.Curve = curve;
    nearest.Best.Length = lengths[segment] + along * (lengths[segment + 1] - lengths[segment]);
  }
}

ContourLocator::Location ContourLocator::Find(const Parameters& location) const
{
  Nearest nearest;
  if (this->Curves.empty() || !std::isfinite(location[0] + location[1]))
  {
    return nearest.Best;
  }
  int center[2];
  for (int direction = 0; direction < 2; ++direction)
  {
    center[direction] =
      this->WrapBin(GetBin(std::max(-1.0, std::min(location[direction], 2.0))), direction);
  }
  // Search rings of bins until all remaining bins are farther than the nearest position found.
  for (int ring = 0; ring <= NumberOfBins; ++ring)
  {
    for (int j = center[1] - ring; j <= center[1] + ring; ++j)
    {
      const bool isFullRow = std::abs(j - center[1]) == ring;
      for (int i = center[0] - ring; i <= center[0] + ring;
           i += isFullRow || ring == 0 ? 1 : 2 * ring)
      {
        const bool isThere = (this->IsPeriodic[0] || (i >= 0 && i < NumberOfBins)) &&
          (this->IsPeriodic[1] || (j >= 0 && j < NumberOfBins));
        if (!isThere)
        {
          continue;
        }
        for (const auto& segment :
          this->Bins[this->WrapBin(j, 1) * NumberOfBins + this->WrapBin(i, 0)])
        {
          this->Compare(location, segment.first, segment.second, nearest);
        }
      }
    }
    const double reach = static_cast<double>(ring) / NumberOfBins;
    if (nearest.Distance2 <= reach * reach)
    {
      break;
    }
  }
  return nearest.Best;
}

ContourLocator::Location ContourLocator::Find(const Parameters& location, int curve) const
{
  Nearest nearest;
  for (int s = 0; s + 1 < static_cast<int>(this->Curves[curve].Points.size()); ++s)
  {
    this->Compare(location, curve, s, nearest);
  }
  return nearest.Best;
}

}
