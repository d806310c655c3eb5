// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/CellMedium.h"

#include <algorithm>
#include <stdexcept>

namespace reference
{

CellMedium::CellMedium(const glm::dvec3& lower, const glm::dvec3& size,
  const std::array<int, 3>& counts, std::vector<double> extinction, std::vector<glm::dvec3> albedo)
  : Size(size)
  , Counts(counts)
  , Extinction(std::move(extinction))
  , Albedo(std::move(albedo))
{
  if (this->Albedo.size() != 1 && this->Albedo.size() != this->Extinction.size())
  {
    throw std::invalid_argument("the number of albedos must be 1 or the number of extinctions");
  }
  std::vector<ExtinctionRange> ranges;
  for (const double value : this->Extinction)
  {
    ranges.push_back({ value, value });
  }
  this->SetCells(
    lower, lower + size * glm::dvec3(counts[0], counts[1], counts[2]), counts, std::move(ranges));
}

std::size_t CellMedium::GetCell(const glm::dvec3& position) const
{
  const glm::dvec3 at = (position - this->GetLower()) / this->Size;
  std::size_t cell = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    cell = cell * static_cast<std::size_t>(this->Counts[axis]) +
      static_cast<std::size_t>(std::clamp(static_cast<int>(at[axis]), 0, this->Counts[axis] - 1));
  }
  return cell;
}

double CellMedium::GetExtinction(const glm::dvec3& position) const
{
  return this->Extinction[this->GetCell(position)];
}

glm::dvec3 CellMedium::GetAlbedo(const glm::dvec3& position) const
{
  return this->Albedo.size() == 1 ? this->Albedo.front() : this->Albedo[this->GetCell(position)];
}

}
