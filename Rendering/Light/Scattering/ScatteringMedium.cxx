// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringMedium.h"

#include "Common/Vectors.h"

namespace interlume
{

std::size_t ScatteringMedium::GetNumberOfCells() const
{
  return static_cast<std::size_t>(this->Cells.x) * static_cast<std::size_t>(this->Cells.y) *
    static_cast<std::size_t>(this->Cells.z);
}

Error ScatteringMedium::Check() const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->Cells[axis] < 1)
    {
      return "The scattering grid has " + std::to_string(this->Cells[axis]) + " cells along axis " +
        std::to_string(axis) + ". At least 1 cell is required.";
    }
    if (!(this->CellSize[axis] > 0.0 && std::isfinite(this->CellSize[axis])))
    {
      return "The scattering grid's cell size is " + std::to_string(this->CellSize[axis]) +
        " along axis " + std::to_string(axis) + ". The size must be finite and above 0.";
    }
  }
  if (!Vectors::IsFinite(this->Origin))
  {
    return "The scattering grid's origin is not finite. Check the volume's origin and matrix.";
  }
  const std::size_t number = this->GetNumberOfCells();
  if (this->Extinction.size() != number || this->Albedo.size() != number ||
    (!this->Blocked.empty() && this->Blocked.size() != number))
  {
    return "The scattering grid has " + std::to_string(number) + " cells, but " +
      std::to_string(this->Extinction.size()) + " extinction values, " +
      std::to_string(this->Albedo.size()) + " albedo values and " +
      std::to_string(this->Blocked.size()) +
      " flags for blocked cells. Every cell needs an extinction and an albedo; flags are optional.";
  }
  return {};
}

}
