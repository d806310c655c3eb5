// SPDX-License-Identifier: BSD-3-Clause
#include "Lights/EmitterGrid.h"

#include "Lights/LightImage.h"

#include "vtkImageData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interlume
{

namespace
{
double GetBrightness(const glm::dvec3& color)
{
  return color.r + color.g + color.b;
}

// Finds the cell where the prefix sums reach \a fraction of their total. Replaces \a fraction with
// the corresponding position in the unit interval.
std::size_t Find(const std::vector<double>& sums, double& fraction)
{
  const double sum = fraction * sums.back();
  // The first cell with a larger sum is not black.
  const auto above = std::upper_bound(sums.begin(), sums.end(), sum);
  const auto cell = static_cast<std::size_t>(above - sums.begin());
  const double before = cell > 0 ? sums[cell - 1] : 0.0;
  fraction = (static_cast<double>(cell) + (sum - before) / (sums[cell] - before)) /
    static_cast<double>(sums.size());
  return cell;
}
}

EmitterGrid::EmitterGrid(bool isRound, vtkImageData* image)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  this->Size = std::min(std::max({ 128, dimensions[0], dimensions[1] }), 512);
  const auto size = static_cast<std::size_t>(this->Size);
  this->Colors.reserve(size * size);
  this->Columns.resize(size);
  const LightImage colors(image);
  double total = 0.0;
  for (std::size_t j = 0; j < size; ++j)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const glm::dvec2 cell(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      const glm::dvec2 position = MapToEmitter(isRound, cell / static_cast<double>(size)) + 0.5;
      this->Colors.push_back(colors.GetColor(position.x, position.y, true));
      sum += GetBrightness(this->Colors.back());
      this->Columns[j].push_back(sum);
    }
    total += sum;
    this->Rows.push_back(total);
  }
  this->Mean = std::accumulate(this->Colors.begin(), this->Colors.end(), glm::dvec3(0.0)) /
    static_cast<double>(this->Colors.size());
}

glm::dvec3 EmitterGrid::GetColor() const
{
  const double largest = std::max({ this->Mean.r, this->Mean.g, this->Mean.b });
  return largest > 0.0 ? this->Mean / largest : this->Mean;
}

std::vector<glm::dvec3> EmitterGrid::Warp(std::vector<glm::dvec2>& points) const
{
  std::vector<glm::dvec3> colors;
  for (glm::dvec2& point : points)
  {
    const std::size_t j = Find(this->Rows, point.y);
    const std::size_t i = Find(this->Columns[j], point.x);
    const glm::dvec3& color = this->Colors[j * static_cast<std::size_t>(this->Size) + i];
    colors.push_back(color / GetBrightness(color));
  }
  return colors;
}

glm::dvec2 EmitterGrid::MapToEmitter(bool isRound, const glm::dvec2& point)
{
  const glm::dvec2 position = point - 0.5;
  if (!isRound || position == glm::dvec2(0.0))
  {
    return position;
  }
  const bool isWide = std::abs(position.x) > std::abs(position.y);
  const double radius = isWide ? position.x : position.y;
  const double angle =
    0.25 * vtkMath::Pi() * (isWide ? position.y / position.x : 2.0 - position.x / position.y);
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

}
