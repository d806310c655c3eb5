// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteringMedium_h
#define interlume_ScatteringMedium_h

#include "Common/Error.h"
#include "Scattering/PhaseFunction.h"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ScatteringMedium
 * @brief   the matter that scatters light, in the cells of a box
 *
 * Cell (i, j, k) has index i + Cells.x (j + Cells.y k). All vectors are in the axes of the box.
 * There is nothing beyond the box, and what leaves it does not return, unless a side is a mirror.
 */
struct ScatteringMedium
{
  glm::ivec3 Cells{ 0 };
  /// The size of a cell in world units. Cubes give the best accuracy; sizes that differ by more
  /// than a factor of 2 are allowed, and worse.
  glm::dvec3 CellSize{ 1.0 };
  /// The lower corner of the box, in the coordinates that places of lights have.
  glm::dvec3 Origin{ 0.0 };
  /// The mean extinction of each cell in 1 / world unit. What is no finite positive number counts
  /// as 0; NaN and infinities are counted in the report.
  std::vector<float> Extinction;
  /// The share of the light that goes on where it meets matter, for red, green and blue; clamped to
  /// 0 to 1, NaN is 0.
  std::vector<glm::vec3> Albedo;
  /// Not 0 for cells that opaque surfaces fill, which absorb what reaches them. Empty where there
  /// is none.
  std::vector<unsigned char> Blocked;
  PhaseFunction Phase;
  /// Along which axes both sides of the box are mirrors, which makes a box a slab without end.
  glm::bvec3 Mirrors{ false };

  std::size_t GetNumberOfCells() const;
  std::size_t GetIndex(const glm::ivec3& cell) const
  {
    return static_cast<std::size_t>(cell.x) +
      static_cast<std::size_t>(this->Cells.x) *
      (static_cast<std::size_t>(cell.y) +
        static_cast<std::size_t>(this->Cells.y) * static_cast<std::size_t>(cell.z));
  }
  bool IsBlocked(std::size_t cell) const { return !this->Blocked.empty() && this->Blocked[cell]; }
  /// Returns an error if a size is not valid.
  Error Check() const;
};

}

#endif
