// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CornerOrder_h
#define interlume_CornerOrder_h

#include "Common/GlobalIds.h"

#include "vtkIsotable.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <cstddef>
#include <utility>

namespace interlume
{

/**
 * @class   CornerOrder
 * @brief   the one order of a grid's points by which cells that share a face cut it alike
 *
 * It is the order of the global point ids where there are any, so that distributed pieces of a grid
 * agree, and of the point ids otherwise.
 */
class CornerOrder
{
public:
  /// Makes the order. Global ids that are not of vtkIdType are copied.
  explicit CornerOrder(vtkPointData* points);

  /// Returns whether it is the order of the point ids.
  bool IsById() const { return this->Keys == nullptr; }

  bool IsBefore(vtkIdType a, vtkIdType b) const
  {
    return this->Keys ? this->Keys[a] < this->Keys[b] : a < b;
  }

  bool IsAscending(const vtkIdType* ids, int number) const
  {
    vtkIdType room[vtkIsotable::MaximumNumberOfVertices];
    const vtkIdType* const keys = this->GetKeys(ids, number, room);
    return number == 8 ? AreAscending<8>(keys, number) : AreAscending<0>(keys, number);
  }

  /// Returns whether putting ids in ascending order takes an odd number of exchanges.
  bool IsOdd(const vtkIdType* ids, int number) const
  {
    bool isOdd = false;
    for (int a = 0; a < number; ++a)
    {
      for (int b = a + 1; b < number; ++b)
      {
        isOdd ^= this->IsBefore(ids[b], ids[a]);
      }
    }
    return isOdd;
  }

  /// Computes the rank of each corner; of equal ids, in a degenerate cell, the first corner is the
  /// lower.
  void Rank(const vtkIdType* ids, int number, vtkIsotable::Slot* ranks) const;

  /**
   * Turns a cell by a symmetry of its shape so that its first corners are in ascending order: most
   * cells of most meshes then have their corners in the order of the table's own cut. It may be a
   * reflection: the orientation is to be taken from the coordinates.
   */
  void Turn(vtkIsotable::Shapes shape, vtkIdType* ids) const;

  /**
   * Has output points that are half-way between two grid points computed from the one that comes
   * first, in whatever order a piece stores them: the other way round they may be rounded
   * otherwise. Of grid points at two time steps those from \a split on are at the second.
   */
  template <typename Point>
  void SortHalfway(Point* points, std::size_t number, vtkIdType split = VTK_ID_MAX) const
  {
    vtkSMPTools::For(0, this->Keys ? static_cast<vtkIdType>(number) : 0,
      [&](vtkIdType first, vtkIdType last)
      { this->SortHalfwayInThread(points + first, points + last, split); });
  }

  /// Does the same by the calling thread alone.
  template <typename Point>
  void SortHalfwayInThread(Point* first, Point* last, vtkIdType split = VTK_ID_MAX) const
  {
    const auto isBefore = [this, split](vtkIdType a, vtkIdType b)
    {
      const bool isSecond = a >= split;
      return isSecond == (b >= split)
        ? this->IsBefore(isSecond ? a - split : a, isSecond ? b - split : b)
        : !isSecond;
    };
    for (Point* point = first; this->Keys && point != last; ++point)
    {
      if (point->Weight == 0.5 && isBefore(point->Far, point->Near))
      {
        std::swap(point->Near, point->Far);
      }
    }
  }

private:
  // Returns the numbers that corners are ordered by, which may be put into \a room.
  const vtkIdType* GetKeys(const vtkIdType* ids, int number, vtkIdType* room) const
  {
    for (int v = 0; this->Keys && v < number; ++v)
    {
      room[v] = this->Keys[ids[v]];
    }
    return this->Keys ? room : ids;
  }

  // A known number needs no loop.
  template <int Known>
  static bool AreAscending(const vtkIdType* keys, int number)
  {
    const int end = Known ? Known : number;
    bool ascending = true;
    for (int v = 1; v < end; ++v)
    {
      ascending &= keys[v - 1] < keys[v];
    }
    return ascending;
  }

  void TurnPyramid(vtkIdType* ids) const;
  void TurnWedge(vtkIdType* ids) const;
  void TurnHexahedron(vtkIdType* ids) const;

  vtkSmartPointer<GlobalIds::Array> Array;
  // The global id of each point, or null.
  const vtkIdType* Keys;
};

}

#endif
