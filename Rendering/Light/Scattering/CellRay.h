// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellRay_h
#define interlume_CellRay_h

#include "Scattering/ScatteringMedium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>

namespace interlume
{

/**
 * @class   CellRay
 * @brief   traverses the cells along a ray that mirrors reflect
 */
class CellRay
{
public:
  /// \a position is a position in the box, in cells from its lower corner. \a direction has
  /// components along the axes of the box and length 1 in world units.
  CellRay(const ScatteringMedium& medium, const glm::dvec3& position, const glm::dvec3& direction)
    : CellRay(medium, glm::clamp(glm::ivec3(glm::floor(position)), glm::ivec3(0), medium.Cells - 1),
        position, direction)
  {
  }
  /// \a position is in \a cell or on its boundary.
  CellRay(const ScatteringMedium& medium, const glm::ivec3& cell, const glm::dvec3& position,
    const glm::dvec3& direction)
    : Medium(medium)
    , Cell(cell)
    , Direction(direction)
    , Index(static_cast<std::ptrdiff_t>(medium.GetIndex(cell)))
  {
    std::ptrdiff_t stride = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double along = direction[axis];
      const double within = position[axis] - this->Cell[axis];
      this->Within[axis] = within;
      if (along != 0.0)
      {
        this->Step[axis] = medium.CellSize[axis] / std::abs(along);
        this->Next[axis] = this->Step[axis] * (along > 0.0 ? 1.0 - within : within);
      }
      this->Strides[static_cast<std::size_t>(axis)] = along > 0.0 ? stride : -stride;
      stride *= medium.Cells[axis];
    }
    this->Find();
  }

  const glm::ivec3& GetCell() const { return this->Cell; }
  /// Returns the cell's index in the medium.
  std::size_t GetIndex() const { return static_cast<std::size_t>(this->Index); }
  /// Returns the direction in this cell. Mirrors change it.
  const glm::dvec3& GetDirection() const { return this->Direction; }
  /// Returns the distance from the ray's start at which it enters or exits this cell.
  double GetEntry() const { return this->Entry; }
  double GetExit() const { return this->Next[this->Axis]; }

  /// Returns the position at a distance from the ray's start, within this cell, in cells from the
  /// lower corner of the box.
  glm::dvec3 GetPosition(double distance) const
  {
    glm::dvec3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
      // The fraction of the cell that remains up to the next cell boundary.
      const double along = this->Direction[axis];
      const double remaining =
        along != 0.0 ? (this->Next[axis] - distance) / this->Step[axis] : 1.0 - this->Within[axis];
      position[axis] = this->Cell[axis] + (along < 0.0 ? remaining : 1.0 - remaining);
    }
    return position;
  }

  /// Advances to the next cell. Returns false if the ray leaves the box.
  bool Advance()
  {
    const int axis = this->Axis;
    this->Entry = this->Next[axis];
    this->Next[axis] += this->Step[axis];
    const int next = this->Cell[axis] + (this->Direction[axis] > 0.0 ? 1 : -1);
    if (next >= 0 && next < this->Medium.Cells[axis])
    {
      this->Cell[axis] = next;
      this->Index += this->Strides[static_cast<std::size_t>(axis)];
    }
    else if (this->Medium.Mirrors[axis])
    {
      this->Direction[axis] = -this->Direction[axis];
      this->Strides[static_cast<std::size_t>(axis)] *= -1;
    }
    else
    {
      return false;
    }
    this->Find();
    return true;
  }

private:
  void Find()
  {
    const glm::dvec3& next = this->Next;
    this->Axis = next.x <= next.y && next.x <= next.z ? 0 : (next.y <= next.z ? 1 : 2);
  }

  const ScatteringMedium& Medium;
  glm::ivec3 Cell;
  glm::dvec3 Direction;
  /// The cell's index, and the change of the index per step along each axis.
  std::ptrdiff_t Index;
  std::array<std::ptrdiff_t, 3> Strides{};
  /// For each axis, the length of the ray between two cell boundaries, and the distance from the
  /// ray's start to the next boundary.
  glm::dvec3 Step{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Next{ std::numeric_limits<double>::infinity() };
  double Entry = 0.0;
  /// Position of the ray's start within its cell, from 0 to 1 along each axis.
  glm::dvec3 Within{ 0.5 };
  int Axis = 0;
};

}

#endif
