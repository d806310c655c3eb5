// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures/PictureTurn.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace reference
{

PictureTurn::Bend PictureTurn::Measure(const std::vector<double>& numbers)
{
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < numbers.size(); ++i)
  {
    bends.push_back(std::abs(0.5 * (numbers[i - 1] + numbers[i + 1]) - numbers[i]));
  }
  Bend bend;
  if (bends.empty())
  {
    return bend;
  }
  const auto largest = std::max_element(bends.begin(), bends.end());
  bend.Largest = *largest;
  bend.At = static_cast<int>(largest - bends.begin()) + 1;
  std::sort(bends.begin(), bends.end());
  bend.P95 = bends[static_cast<std::size_t>(0.95 * static_cast<double>(bends.size() - 1))];
  return bend;
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
