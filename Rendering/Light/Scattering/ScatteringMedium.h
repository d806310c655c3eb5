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
 * @brief   a scattering medium on the cells of a box
 *
 * Cell (i, j, k) has the index i + Cells.x (j + Cells.y k). Vectors have components along the axes
 * of the box. Space outside the box is empty, and light that leaves the box does not return, unless
 * a face is a mirror.
 */
struct ScatteringMedium
{
  glm::ivec3 Cells{ 0 };
  /// Cell size in world units. Cubic cells give the best accuracy. Aspect ratios above 2 are valid
  /// but less accurate.
  glm::dvec3 CellSize{ 1.0 };
  /// Lower corner of the box, in the same coordinates as light positions.
  glm::dvec3 Origin{ 0.0 };
  /// Mean extinction of each cell per world unit. Values that are negative or not finite are
  /// treated as 0; ScatteringReport counts the cells with non-finite values.
  std::vector<float> Extinction;
  /// Fraction of extinguished light that is scattered, for red, green and blue. Clamped to the
  /// range from 0 to 1; NaN is treated as 0.
  std::vector<glm::vec3> Albedo;
  /// Nonzero for cells that opaque surfaces intersect. They absorb all light. Empty if there are no
  /// such cells.
  std::vector<unsigned char> Blocked;
  PhaseFunction Phase;
  /// Axes along which both faces of the box are mirrors. The medium then repeats infinitely along
  /// these axes.
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
  /// Returns an error if a size or an array length is invalid.
  Error Check() const;
};

}

#endif
