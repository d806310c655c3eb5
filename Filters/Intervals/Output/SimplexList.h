// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexList_h
#define interlume_SimplexList_h

#include "Output/ExtractionBuffer.h"
#include "Output/StridedIdBlock.h"
#include "Output/RetainedIdRanges.h"

#include "vtkCellArray.h"
#include "vtkIsotable.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   SimplexList
 * @brief   point ids of tetrahedra or triangles, stored in 32 bits if they fit
 *
 * Interior cells, which have any number of points and are passed through uncut, may follow the
 * simplices.
 *
 * 32 bits suffice unless a point id or the length of the list exceeds 2^31 - 1. The vtkCellArray
 * built from the list uses the same type. Writing half the bytes takes half the time.
 */
class SimplexList
{
public:
  using Slot = vtkIsotable::Slot;

  static bool CanUse32BitStorage(vtkIdType numberOfPoints, vtkIdType numberOfIds)
  {
    constexpr vtkIdType maximum = std::numeric_limits<vtkTypeInt32>::max();
    return numberOfPoints <= maximum && numberOfIds <= maximum;
  }

  /// Allocates \a number simplices of \a size points each, and \a interiorCells interior cells with
  /// \a interiorIds points in total.
  void Allocate(vtkIdType number, int size, vtkIdType numberOfPoints, vtkIdType interiorCells = 0,
    vtkIdType interiorIds = 0);

  vtkIdType GetNumber() const { return this->Number; }
  vtkIdType GetNumberOfInteriorCells() const { return this->NumberOfInteriorCells; }

  /// Returns the number of ids of all cells, including interior cells.
  vtkIdType GetNumberOfIds() const
  {
    vtkIdType number = 0;
    this->VisitList([&number](const auto& list) { number = list.Values->GetNumberOfValues(); });
    return number;
  }
  vtkIdType GetIdAt(vtkIdType at) const
  {
    return this->Wide.Ids ? static_cast<vtkIdType>(this->Wide.Ids[at])
                          : static_cast<vtkIdType>(this->Narrow.Ids[at]);
  }

  /// Returns the index range [first, last) of the ids of an interior cell.
  std::pair<vtkIdType, vtkIdType> GetInteriorIdRange(vtkIdType cell) const
  {
    const vtkIdType at = this->Number + cell;
    std::pair<vtkIdType, vtkIdType> range;
    this->VisitIdsAndOffsets(
      [&](auto*, const auto* offsets) {
        range = { offsets[at], offsets[at + 1] };
      });
    return range;
  }

  /// Calls visit(cell, ids, number) for all interior cells in parallel.
  template <typename Visitor>
  void ForEachInteriorCell(Visitor&& visit) const
  {
    if (this->NumberOfInteriorCells == 0)
    {
      return;
    }
    this->VisitIdsAndOffsets(
      [&](const auto* values, const auto* offsets)
      {
        vtkSMPTools::For(0, this->NumberOfInteriorCells,
          [&, offsets = offsets + this->Number](vtkIdType first, vtkIdType last)
          {
            std::vector<vtkIdType> ids;
            for (vtkIdType cell = first; cell < last; ++cell)
            {
              ids.assign(values + offsets[cell], values + offsets[cell + 1]);
              visit(cell, ids.data(), static_cast<int>(ids.size()));
            }
          });
      });
  }

  /// Writes an interior cell. Its ids start at \a position in the ids of all interior cells.
  void WriteInteriorCell(vtkIdType cell, vtkIdType position, const vtkIdType* ids, int number)
  {
    const vtkIdType first = this->Number * this->Size + position;
    this->VisitIdsAndOffsets(
      [&](auto* values, auto* offsets)
      {
        Set(offsets[this->Number + cell], first);
        for (int i = 0; i < number; ++i)
        {
          Set(values[first + i], ids[i]);
        }
      });
  }

  vtkIdType GetId(vtkIdType simplex, int point) const
  {
    return this->GetIdAt(simplex * this->Size + point);
  }

  /// Writes \a number simplices, starting at index \a first. Their corners are slots of an
  /// isotable, and \a ids contains the point id of each slot.
  void Write(vtkIdType first, const vtkIsotable::Simplex* simplices, std::size_t number,
    const vtkIdType* ids, bool isInverted)
  {
    this->Visit(
      [&](auto* values)
      {
        this->Size == 4 ? WriteSlots<4>(values + 4 * first, simplices, number, ids, isInverted)
                        : WriteSlots<3>(values + 3 * first, simplices, number, ids, isInverted);
      });
  }

  /// Repeats the \a number simplices before index \a first, \a cells times. Each repetition
  /// increases all ids by 1.
  void WriteIncrementedCopies(vtkIdType first, std::size_t number, vtkIdType cells)
  {
    const int ids = static_cast<int>(number) * this->Size;
    const vtkIdType position = first * this->Size;
    // Do not stream short runs: the next run starts by reading the last ids, which should still be
    // in the cache.
    constexpr vtkIdType minimumCells = 4;
    if (this->IsStreamed && cells >= minimumCells)
    {
      StridedIdBlock::Stream(this->Narrow.Ids + position, ids, cells);
      return;
    }
    this->Visit([&](auto* values) { StridedIdBlock::Write(values + position, ids, cells); });
  }

  /// Writes one simplex.
  void Write(vtkIdType simplex, const vtkIdType* points)
  {
    this->Visit(
      [&](auto* values)
      {
        for (int p = 0; p < this->Size; ++p)
        {
          Set(values[simplex * this->Size + p], points[p]);
        }
      });
  }

  /// Numbers the points of all simplices consecutively, so that no two simplices share a point.
  void NumberConsecutively();

  /// Moves the retained simplices to the front. Call Truncate() to remove the rest.
  void Keep(const RetainedIdRanges& retained)
  {
    this->Visit([&](auto* values) { retained.Compact(values, this->Size); });
  }

  /// Calls \a visit(ids) with a pointer to the ids of all cells, as 32-bit or 64-bit integers.
  template <typename Visitor>
  void Visit(Visitor&& visit) const
  {
    this->VisitList([&visit](const auto& list) { visit(list.Ids); });
  }

  /// Calls \a visit(id) for each id of each cell, in parallel.
  template <typename Visitor>
  void ForEachId(Visitor&& visit)
  {
    this->Visit(
      [&](auto* values)
      {
        vtkSMPTools::For(0, this->GetNumberOfIds(),
          [values, &visit](vtkIdType first, vtkIdType last)
          { std::for_each(values + first, values + last, visit); });
      });
  }

  /// Removes all but the first \a number simplices, and moves the interior cells after them.
  void Truncate(vtkIdType number);

  /// Removes the marked interior cells.
  void RemoveInteriorCells(const std::vector<bool>& isRemoved);

  /// Renumbers the points after all but the \a retained ones were removed. \a numberOfPoints is the
  /// number of points before the removal. The cells must use only retained points.
  void RemovePoints(const RetainedIdRanges& retained, vtkIdType numberOfPoints);

  /// Creates the cell array, which shares the memory of the list.
  vtkSmartPointer<vtkCellArray> MakeCells();

  /// Returns a copy of the simplices, without the interior cells.
  SimplexList CopySimplices() const;

private:
  // The ids of all cells, and a raw pointer to them for fast writing.
  template <typename Array>
  struct IdList
  {
    vtkSmartPointer<Array> Values;
    typename Array::ValueType* Ids = nullptr;
    // The offsets of all cells, or null if there are no interior cells.
    vtkSmartPointer<Array> Offsets;

    void FindIds() { this->Ids = this->Values ? this->Values->GetPointer(0) : nullptr; }
  };

  void FindIds();

  // Calls visit(list) for the list in use, if any.
  template <typename Visitor>
  void VisitList(Visitor&& visit) const
  {
    if (this->Narrow.Values)
    {
      visit(this->Narrow);
    }
    else if (this->Wide.Values)
    {
      visit(this->Wide);
    }
  }

  // Frees the unused capacity of the arrays. \a ids is the number of ids to keep.
  void Shorten(vtkIdType ids);

  // Calls visit(ids, offsets). Requires interior cells.
  template <typename Visitor>
  void VisitIdsAndOffsets(Visitor&& visit) const
  {
    this->VisitList([&visit](const auto& list) { visit(list.Ids, list.Offsets->GetPointer(0)); });
  }

  template <typename Id>
  static void Set(Id& id, vtkIdType value)
  {
    id = static_cast<Id>(value);
  }

  template <int Points, typename Id>
  static void WriteSlots(Id* out, const vtkIsotable::Simplex* simplices, std::size_t number,
    const vtkIdType* ids, bool isInverted)
  {
    const int first = isInverted ? 1 : 0;
    for (std::size_t s = 0; s < number; ++s, out += Points)
    {
      Set(out[0], ids[simplices[s][first]]);
      Set(out[1], ids[simplices[s][1 - first]]);
      for (int p = 2; p < Points; ++p)
      {
        Set(out[p], ids[simplices[s][p]]);
      }
    }
  }

  template <typename Array>
  vtkSmartPointer<Array> NewOffsets() const;

  // Returns the offsets of all cells. Those of interior cells are already set.
  template <typename Array>
  vtkSmartPointer<Array> MakeOffsets(const vtkSmartPointer<Array>& interiorOffsets) const;

  vtkIdType Number = 0;
  int Size = 4;
  vtkIdType NumberOfInteriorCells = 0;
  // At most one of these lists is in use.
  IdList<vtkTypeInt32Array> Narrow;
  IdList<vtkTypeInt64Array> Wide;
  // If true, runs of ids are written without loading them into the cache.
  bool IsStreamed = false;
};

}

#endif
