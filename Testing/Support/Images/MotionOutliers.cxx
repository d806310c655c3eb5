// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/MotionOutliers.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace reference
{

namespace
{

/// Outliers exceed the 95th percentile of the second differences by this factor.
constexpr double OutlierFactor = 3.0;
/// Limits for second differences of the mean, as fractions of the mean: differences below
/// VisibleMean are invisible, differences above MaximumMean are outliers.
constexpr double VisibleMean = 0.0025;
constexpr double MaximumMean = 0.01;
/// The same two limits for second differences of pixel changes, which are in [0, 1].
constexpr double VisibleChange = 0.05;
constexpr double MaximumChange = 1.0;

}

MotionOutliers::Bend MotionOutliers::Measure(
  const std::vector<double>& numbers, double seen, double bound, bool isAbove)
{
  std::vector<double> above;
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < numbers.size(); ++i)
  {
    above.push_back(numbers[i] - 0.5 * (numbers[i - 1] + numbers[i + 1]));
    bends.push_back(std::abs(above.back()));
  }
  Bend bend;
  if (bends.empty())
  {
    return bend;
  }
  const auto largest = std::max_element(bends.begin(), bends.end());
  bend.Largest = *largest;
  bend.At = static_cast<int>(largest - bends.begin()) + 1;
  std::vector<double> sorted = bends;
  std::sort(sorted.begin(), sorted.end());
  bend.P95 = sorted[static_cast<std::size_t>(0.95 * static_cast<double>(sorted.size() - 1))];
  const double limit = std::min(std::max(OutlierFactor * bend.P95, seen), bound);
  const std::vector<double>& counted = isAbove ? above : bends;
  bend.Outliers = static_cast<int>(std::count_if(
    counted.begin(), counted.end(), [limit](double number) { return number > limit; }));
  return bend;
}

MotionOutliers::Bend MotionOutliers::GetSecondDifferencesOfMean() const
{
  const double mean = this->GetMean();
  return Measure(this->Means, VisibleMean * mean, MaximumMean * mean);
}

MotionOutliers::Bend MotionOutliers::GetSecondDifferencesOfChange() const
{
  return Measure(this->Changes, VisibleChange, MaximumChange, true);
}

void MotionOutliers::Add(RgbaImage image)
{
  double sum = 0.0;
  double change = 0.0;
  for (std::size_t k = 0; k < image.Values.size(); k += 4)
  {
    sum += image.Values[k];
    change = this->Means.empty()
      ? 0.0
      : std::max(change, std::abs(image.Values[k] - this->Last.Values[k]));
  }
  if (!this->Means.empty())
  {
    this->Changes.push_back(change);
  }
  this->Means.push_back(4.0 * sum / static_cast<double>(image.Values.size()));
  this->Last = std::move(image);
}

double MotionOutliers::GetMean() const
{
  const double sum = std::accumulate(this->Means.begin(), this->Means.end(), 0.0);
  return this->Means.empty() ? 0.0 : sum / static_cast<double>(this->Means.size());
}

}
