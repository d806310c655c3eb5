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
 * @brief   the cells that a ray goes through, one after the other, reflected by mirrors
 */
class CellRay
{
public:
  /// \a place is in the box, in cells from its lower corner; \a direction of length 1, in the
  /// world's units along the axes of the box.
  CellRay(const ScatteringMedium& medium, const glm::dvec3& place, const glm::dvec3& direction)
    : CellRay(medium, glm::clamp(glm::ivec3(glm::floor(place)), glm::ivec3(0), medium.Cells - 1),
        place, direction)
  {
  }
  /// \a place is in or on the sides of \a cell.
  CellRay(const ScatteringMedium& medium, const glm::ivec3& cell, const glm::dvec3& place,
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
      const double within = place[axis] - this->Cell[axis];
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
  /// Its index in the medium.
  std::size_t GetIndex() const { return static_cast<std::size_t>(this->Index); }
  /// The direction in this cell; mirrors turn it.
  const glm::dvec3& GetDirection() const { return this->Direction; }
  /// Returns how far from its start the ray enters and leaves this cell.
  double GetEntry() const { return this->Gone; }
  double GetExit() const { return this->Next[this->Axis]; }

  /// Returns the place, in cells from the lower corner, so far from the start, in this cell.
  glm::dvec3 GetPlace(double distance) const
  {
    glm::dvec3 place;
    for (int axis = 0; axis < 3; ++axis)
    {
      // Up to the border that comes next.
      const double along = this->Direction[axis];
      const double left =
        along != 0.0 ? (this->Next[axis] - distance) / this->Step[axis] : 1.0 - this->Within[axis];
      place[axis] = this->Cell[axis] + (along < 0.0 ? left : 1.0 - left);
    }
    return place;
  }

  /// Goes on to the next cell; returns false where the ray leaves the box.
  bool Advance()
  {
    const int axis = this->Axis;
    this->Gone = this->Next[axis];
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
  /// The cell's index, and what a step along each axis adds to it.
  std::ptrdiff_t Index;
  std::array<std::ptrdiff_t, 3> Strides{};
  /// How far the ray goes between two borders along each axis, and to the next of them.
  glm::dvec3 Step{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Next{ std::numeric_limits<double>::infinity() };
  double Gone = 0.0;
  /// Where in its first cell the ray starts.
  glm::dvec3 Within{ 0.5 };
  int Axis = 0;
};

}

#endif
