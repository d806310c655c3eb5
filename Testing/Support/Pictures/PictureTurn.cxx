// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pictures/PictureTurn.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace reference
{

namespace
{

/// Times what 95 % of the second differences are below.
constexpr double OutlierFactor = 3.0;
/// Shares of the mean.
constexpr double SeenMean = 0.0025;
constexpr double MostMean = 0.01;
/// Of a pixel, 0 to 1.
constexpr double SeenChange = 0.05;
constexpr double MostChange = 1.0;

}

PictureTurn::Bend PictureTurn::Measure(
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
  const double most = std::min(std::max(OutlierFactor * bend.P95, seen), bound);
  const std::vector<double>& counted = isAbove ? above : bends;
  bend.Outliers = static_cast<int>(
    std::count_if(counted.begin(), counted.end(), [most](double number) { return number > most; }));
  return bend;
}

PictureTurn::Bend PictureTurn::GetMeanBend() const
{
  const double mean = this->GetMean();
  return Measure(this->Means, SeenMean * mean, MostMean * mean);
}

PictureTurn::Bend PictureTurn::GetChangeBend() const
{
  return Measure(this->Changes, SeenChange, MostChange, true);
}

void PictureTurn::Add(RgbaPicture picture)
{
  double sum = 0.0;
  double change = 0.0;
  for (std::size_t k = 0; k < picture.Values.size(); k += 4)
  {
    sum += picture.Values[k];
    change = this->Means.empty()
      ? 0.0
      : std::max(change, std::abs(picture.Values[k] - this->Last.Values[k]));
  }
  if (!this->Means.empty())
  {
    this->Changes.push_back(change);
  }
  this->Means.push_back(4.0 * sum / static_cast<double>(picture.Values.size()));
  this->Last = std::move(picture);
}

double PictureTurn::GetMean() const
{
  const double sum = std::accumulate(this->Means.begin(), this->Means.end(), 0.0);
  return this->Means.empty() ? 0.0 : sum / static_cast<double>(this->Means.size());
}

}
