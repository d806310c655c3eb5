// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/ExtractionValues.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace interlume
{

namespace
{
std::vector<double> SortedUnique(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}
}

int ExtractionValues::IndexOf(double value) const
{
  return static_cast<int>(
    std::lower_bound(this->Values.begin(), this->Values.end(), value) - this->Values.begin());
}

ExtractionValues ExtractionValues::ForContours(const std::vector<double>& values)
{
  ExtractionValues result;
  result.Kind = vtkIsotable::CONTOUR;
  result.Values = SortedUnique(values);
  for (double value : values)
  {
    const int index = result.IndexOf(value);
    result.Items.push_back({ index, index, static_cast<Code>(2 * index + 1), NoCode, false });
  }
  result.FindPoints();
  return result;
}

ExtractionValues ExtractionValues::ForIntervals(const std::vector<std::array<double, 2>>& intervals)
{
  ExtractionValues result;
  result.Kind = vtkIsotable::INTERVAL;
  for (const auto& interval : intervals)
  {
    result.Values.insert(result.Values.end(), interval.begin(), interval.end());
  }
  result.Values = SortedUnique(result.Values);
  for (const auto& interval : intervals)
  {
    const int lower = result.IndexOf(interval[0]);
    const int upper = result.IndexOf(interval[1]);
    // The upper value belongs to another interval of nonzero width that starts there, if any.
    const bool isShared = lower != upper &&
      std::any_of(intervals.begin(), intervals.end(),
        [&interval](const std::array<double, 2>& other)
        { return other[0] == interval[1] && other[0] < other[1]; });
    result.Items.push_back({ lower, upper, static_cast<Code>(2 * lower + 1),
      static_cast<Code>(2 * upper + (isShared ? 1 : 2)), lower == upper });
    result.FlatItem |= lower == upper;
  }
  result.FindPoints();
  return result;
}

std::vector<double> ExtractionValues::TakeConstants(std::vector<std::array<double, 2>>& intervals)
{
  const auto constants = std::stable_partition(intervals.begin(), intervals.end(),
    [](const std::array<double, 2>& interval) { return interval[0] != interval[1]; });
  std::vector<double> values;
  std::transform(constants, intervals.end(), std::back_inserter(values),
    [](const std::array<double, 2>& interval) { return interval[0]; });
  intervals.erase(constants, intervals.end());
  return values;
}

ExtractionValues ExtractionValues::ForComplement(std::vector<std::array<double, 2>> intervals)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::sort(intervals.begin(), intervals.end());
  std::vector<std::array<double, 2>> gaps;
  double begin = -infinity;
  for (const auto& interval : intervals)
  {
    if (interval[0] > begin)
    {
      gaps.push_back({ { begin, interval[0] } });
    }
    begin = std::max(begin, interval[1]);
  }
  gaps.push_back({ { begin, infinity } });
  ExtractionValues result = ExtractionValues::ForIntervals(gaps);
  // The ends of a gap belong to the intervals.
  for (Item& item : result.Items)
  {
    const bool isFirst = result.Values[item.Lower] == -infinity;
    const bool isLast = result.Values[item.Upper] == infinity;
    item.First = static_cast<Code>(2 * item.Lower + (isFirst ? 1 : 2));
    item.Second = static_cast<Code>(2 * item.Upper + (isLast ? 2 : 1));
  }
  result.FindPoints();
  return result;
}

void ExtractionValues::FindPoints()
{
  const std::size_t codes = 2 * this->Values.size() + 2;
  this->Points.assign(codes, 0);
  for (std::size_t code = 0; code + 1 < codes; ++code)
  {
    this->Points[code] = code & 1;
    for (const Item& item : this->Items)
    {
      this->Points[code] |=
        this->Kind == vtkIsotable::INTERVAL && item.GetDigit(static_cast<Code>(code)) == 1;
    }
  }
}

bool ExtractionValues::Overlaps(double minimum, double maximum) const
{
  return std::any_of(this->Items.begin(), this->Items.end(),
    [&](const Item& item)
    { return minimum <= this->Values[item.Upper] && maximum >= this->Values[item.Lower]; });
}

}
