// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/SurfaceLevels.h"

#include "vtkIntervalVolume.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace interlume
{

SurfaceLevels::SurfaceLevels(
  const std::vector<Interval>& intervals, const std::vector<double>& values, double lowest)
  : Values(values)
{
  for (const Interval& interval : intervals)
  {
    std::copy_if(interval.begin(), interval.end(), std::back_inserter(this->Values),
      [](double bound) { return std::abs(bound) < VTK_DOUBLE_MAX; });
  }
  std::sort(this->Values.begin(), this->Values.end());
  this->Values.erase(std::unique(this->Values.begin(), this->Values.end()), this->Values.end());
  const auto find = [this](double value)
  {
    const auto found = std::lower_bound(this->Values.begin(), this->Values.end(), value);
    return found != this->Values.end() && *found == value
      ? static_cast<int>(found - this->Values.begin())
      : -1;
  };
  for (std::size_t i = 0; i < intervals.size(); ++i)
  {
    const double lower = intervals[i][0];
    const double upper = intervals[i][1];
    std::vector<double> cuts{ lower };
    std::copy_if(this->Values.begin(), this->Values.end(), std::back_inserter(cuts),
      [&](double value)
      {
        return value > lower && value < upper && value > lowest &&
          std::find(values.begin(), values.end(), value) != values.end();
      });
    cuts.push_back(upper);
    for (std::size_t c = 1; c < cuts.size(); ++c)
    {
      this->Items.push_back({ { cuts[c - 1] > lowest ? cuts[c - 1] : -VTK_DOUBLE_MAX, cuts[c] } });
      this->IntervalOfItem.push_back(static_cast<int>(i));
      this->SurfacesOfItem.push_back({ { find(cuts[c - 1]), find(cuts[c]) } });
    }
  }
}

bool SurfaceLevels::HasSharedSurfaces() const
{
  std::vector<int> uses(this->Values.size(), 0);
  for (const auto& surfaces : this->SurfacesOfItem)
  {
    for (const int surface : surfaces)
    {
      if (surface >= 0 && ++uses[surface] > 1)
      {
        return true;
      }
    }
  }
  return false;
}

void SurfaceLevels::SetItems(vtkIntervalVolume* filter) const
{
  filter->SetNumberOfIntervals(static_cast<int>(this->Items.size()));
  for (std::size_t i = 0; i < this->Items.size(); ++i)
  {
    filter->SetInterval(static_cast<int>(i), this->Items[i][0], this->Items[i][1]);
  }
}

}
