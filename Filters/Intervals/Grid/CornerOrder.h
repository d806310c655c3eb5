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
 * @brief   total order of a grid's points, so that adjacent cells split shared faces identically
 *
 * It is the order of the global point ids, if available, so that partitions of a distributed grid
 * agree. Otherwise it is the order of the point ids.
 */
class CornerOrder
{
public:
  /// Creates the order. Global ids of a type other than vtkIdType are copied.
  explicit CornerOrder(vtkPointData* points);

  /// Returns whether this is the order of the point ids.
  bool IsById() const { return this->Keys == nullptr; }

  bool IsBefore(vtkIdType a, vtkIdType b) const
  {
    return this->Keys ? this->Keys[a] < this->Keys[b] : a < b;
  }

  bool IsAscending(const vtkIdType* ids, int number) const
  {
    vtkIdType buffer[vtkIsotable::MaximumNumberOfVertices];
    const vtkIdType* const keys = this->GetKeys(ids, number, buffer);
    return number == 8 ? AreAscending<8>(keys, number) : AreAscending<0>(keys, number);
  }

  /// Returns whether sorting the ids is an odd permutation.
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

  /// Computes the rank of each corner. If corners of a degenerate cell have equal ids, the first
  /// one has the lower rank.
  void Rank(const vtkIdType* ids, int number, vtkIsotable::Slot* ranks) const;

  /**
   * Permutes the corners of a cell by a symmetry of its shape so that its first corners are in
   * ascending order. Most cells of most meshes then match the precomputed triangulation of the
   * isotable. The symmetry may be a reflection, so determine the orientation from the coordinates
   * afterward. Quadrilaterals remain unchanged, since their orientation cannot be determined from
   * coordinates.
   */
  void Turn(vtkIsotable::Shapes shape, vtkIdType* ids) const;

  /**
   * Makes interpolation independent of the numbering within a piece: an output point at the
   * midpoint of an edge is interpolated from the end that is first in the order, since rounding may
   * differ if the ends are swapped. Ids from \a split on are points at the second time step.
   */
  template <typename Point>
  void SortMidpointEnds(Point* points, std::size_t number, vtkIdType split = VTK_ID_MAX) const
  {
    vtkSMPTools::For(0, this->Keys ? static_cast<vtkIdType>(number) : 0,
      [&](vtkIdType first, vtkIdType last)
      { this->SortMidpointEndsInThread(points + first, points + last, split); });
  }

  /// Same as SortMidpointEnds(), but in the calling thread.
  template <typename Point>
  void SortMidpointEndsInThread(Point* first, Point* last, vtkIdType split = VTK_ID_MAX) const
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
  // Returns the sort keys of the corners: \a ids itself, or their global ids in \a buffer.
  const vtkIdType* GetKeys(const vtkIdType* ids, int number, vtkIdType* buffer) const
  {
    for (int v = 0; this->Keys && v < number; ++v)
    {
      buffer[v] = this->Keys[ids[v]];
    }
    return this->Keys ? buffer : ids;
  }

  // Compilers unroll the loop if \a Known, the number of keys, is not 0.
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

  void PermutePyramid(vtkIdType* ids) const;
  void PermuteWedge(vtkIdType* ids) const;
  void PermuteHexahedron(vtkIdType* ids) const;

  vtkSmartPointer<GlobalIds::Array> Array;
  // Global id of each point; null if there are no global ids.
  const vtkIdType* Keys;
};

}

#endif
