// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexList_h
#define interlume_SimplexList_h

#include "Output/ExtractionBuffer.h"
#include "Output/IdRun.h"
#include "Output/KeptRuns.h"
#include "Output/ThreadGrain.h"

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
 * @brief   the point ids of tetrahedra or triangles, in 32 bits where they fit
 *
 * Whole cells of any number of points may follow the simplices; their places are those of their
 * first ids among the ids of all whole cells.
 *
 * 32 bits are enough while neither a point id nor the length of the list passes 2^31 - 1; the
 * vtkCellArray that is made of the list has the same width, since half of the bytes is half of the
 * time.
 */
class SimplexList
{
public:
  using Slot = vtkIsotable::Slot;

  static bool AreIdsNarrow(vtkIdType numberOfPoints, vtkIdType numberOfIds)
  {
    constexpr vtkIdType most = std::numeric_limits<vtkTypeInt32>::max();
    return numberOfPoints <= most && numberOfIds <= most;
  }

  /// Makes room for \a number simplices of \a size points each, and for \a wholeCells with
  /// \a wholeIds points in all.
  void Allocate(vtkIdType number, int size, vtkIdType numberOfPoints, vtkIdType wholeCells = 0,
    vtkIdType wholeIds = 0)
  {
    this->Number = number;
    this->Size = size;
    this->NumberOfWhole = wholeCells;
    this->Narrow = nullptr;
    this->Wide = nullptr;
    this->NarrowOffsets = nullptr;
    this->WideOffsets = nullptr;
    const vtkIdType ids = number * size + wholeIds;
    const auto allocate = [&](auto& values, auto& offsets)
    {
      using Array = std::decay_t<decltype(*values)>;
      values = vtkSmartPointer<Array>::New();
      ExtractionMemory::SetNumberOfTuples(values, ids);
      if (wholeCells > 0)
      {
        offsets = this->NewOffsets<Array>();
        Set(offsets->GetPointer(0)[number + wholeCells], ids);
      }
    };
    if (AreIdsNarrow(numberOfPoints, ids))
    {
      allocate(this->Narrow, this->NarrowOffsets);
    }
    else
    {
      allocate(this->Wide, this->WideOffsets);
    }
    this->FindIds();
  }

  vtkIdType GetNumber() const { return this->Number; }
  vtkIdType GetNumberOfWhole() const { return this->NumberOfWhole; }

  /// Returns the number of ids of all cells, and one of them; those of whole cells are the last.
  vtkIdType GetNumberOfIds() const
  {
    return this->Wide ? this->Wide->GetNumberOfValues()
      : this->Narrow  ? this->Narrow->GetNumberOfValues()
                      : 0;
  }
  vtkIdType GetIdAt(vtkIdType at) const
  {
    return this->Wide ? static_cast<vtkIdType>(this->Wide->GetValue(at))
                      : static_cast<vtkIdType>(this->Narrow->GetValue(at));
  }

  /// Returns the places [first, last) of a whole cell's ids among all ids.
  std::pair<vtkIdType, vtkIdType> GetWhole(vtkIdType cell) const
  {
    const vtkIdType at = this->Number + cell;
    return this->Wide ? std::make_pair<vtkIdType, vtkIdType>(
                          this->WideOffsets->GetValue(at), this->WideOffsets->GetValue(at + 1))
                      : std::make_pair<vtkIdType, vtkIdType>(
                          this->NarrowOffsets->GetValue(at), this->NarrowOffsets->GetValue(at + 1));
  }

  /// Calls visit(cell, ids, number) for the whole cells, by any number of threads.
  template <typename Visitor>
  void ForEachWhole(Visitor&& visit) const
  {
    if (this->NumberOfWhole == 0)
    {
      return;
    }
    this->VisitAll(
      [&](const auto* values, const auto* offsets)
      {
        vtkSMPTools::For(0, this->NumberOfWhole,
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

  /// Writes a whole cell, whose ids begin at \a place.
  void WriteWhole(vtkIdType cell, vtkIdType place, const vtkIdType* ids, int number)
  {
    const vtkIdType first = this->Number * this->Size + place;
    this->VisitAll(
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

  /// Writes \a number simplices from the first on, given by slots; \a ids has the id of each slot.
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

  /// Writes \a cells times \a number simplices from the first on, which are those \a number before
  /// them with each id one more.
  void WriteNext(vtkIdType first, std::size_t number, vtkIdType cells)
  {
    const int ids = static_cast<int>(number) * this->Size;
    const vtkIdType place = first * this->Size;
    // Ids that were streamed are not in the cache where the next run begins with them.
    constexpr vtkIdType leastCells = 4;
    if (this->IsStreamed && cells >= leastCells)
    {
      IdRun::Stream(this->NarrowIds + place, ids, cells);
      return;
    }
    this->Visit([&](auto* values) { IdRun::Write(values + place, ids, cells); });
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

  /// Writes all simplices: each has points of its own, in the order of their ids.
  void NumberConsecutively()
  {
    this->Visit(
      [this](auto* values)
      {
        vtkSMPTools::For(0, this->Number * this->Size, ThreadGrain,
          [values](vtkIdType first, vtkIdType last)
          {
            for (vtkIdType at = first; at < last; ++at)
            {
              Set(values[at], at);
            }
          });
      });
  }

  /// Moves the simplices that stay to the front.
  void Keep(const KeptRuns& kept)
  {
    this->Visit([&](auto* values) { kept.Compact(values, this->Size); });
  }

  /// Calls \a visit(ids) with the ids of all cells, in the type they are stored in.
  template <typename Visitor>
  void Visit(Visitor&& visit) const
  {
    if (this->Narrow)
    {
      visit(this->NarrowIds);
    }
    else if (this->Wide)
    {
      visit(this->WideIds);
    }
  }

  /// Calls \a visit(id) for the points of all cells, by any number of threads.
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

  /// Forgets all but the first \a number simplices; the whole cells follow these.
  void Truncate(vtkIdType number)
  {
    const vtkIdType gone = this->Number - number;
    const vtkIdType before = this->GetNumberOfIds();
    if (this->NumberOfWhole > 0)
    {
      this->VisitAll(
        [&](auto* values, auto* offsets)
        {
          std::copy(
            values + this->Number * this->Size, values + before, values + number * this->Size);
          for (vtkIdType cell = 0; cell <= this->NumberOfWhole; ++cell)
          {
            Set(offsets[number + cell], offsets[this->Number + cell] - gone * this->Size);
          }
        });
    }
    this->Number = number;
    this->Shorten(before - gone * this->Size);
  }

  /// Leaves out the whole cells that are marked.
  void RemoveWhole(const std::vector<bool>& isRemoved)
  {
    vtkIdType kept = 0;
    vtkIdType place = this->Number * this->Size;
    for (vtkIdType cell = 0; cell < this->NumberOfWhole; ++cell)
    {
      const auto ids = this->GetWhole(cell);
      if (!isRemoved[cell])
      {
        this->VisitAll(
          [&](auto* values, auto* offsets)
          {
            std::copy(values + ids.first, values + ids.second, values + place);
            Set(offsets[this->Number + kept], place);
          });
        place += ids.second - ids.first;
        ++kept;
      }
    }
    this->VisitAll([&](auto*, auto* offsets) { Set(offsets[this->Number + kept], place); });
    this->NumberOfWhole = kept;
    this->Shorten(place);
  }

  /// Gives the points that stay, of \a numberOfPoints, their new ids; the cells use no others.
  void RemovePoints(const KeptRuns& kept, vtkIdType numberOfPoints)
  {
    this->Visit(
      [&](auto* values)
      {
        ExtractionBuffer<std::decay_t<decltype(*values)>> newIds;
        newIds.Allocate(numberOfPoints);
        kept.FillIds(newIds.GetData());
        vtkSMPTools::For(0, this->GetNumberOfIds(), ThreadGrain,
          [values, ids = newIds.GetData()](vtkIdType first, vtkIdType last)
          {
            for (vtkIdType i = first; i < last; ++i)
            {
              values[i] = ids[values[i]];
            }
          });
      });
  }

  /// Makes the cells, which hold the list's own memory.
  vtkSmartPointer<vtkCellArray> MakeCells()
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (this->Narrow)
    {
      cells->SetData(this->MakeOffsets(this->NarrowOffsets), this->Narrow);
    }
    else if (this->Wide)
    {
      cells->SetData(this->MakeOffsets(this->WideOffsets), this->Wide);
    }
    return cells;
  }

  /// Makes a copy of the simplices alone.
  SimplexList CopySimplices() const
  {
    SimplexList copy;
    copy.Allocate(this->Number, this->Size, this->Wide ? std::numeric_limits<vtkIdType>::max() : 0);
    copy.Visit(
      [this](auto* values)
      {
        for (vtkIdType at = 0; at < this->Number * this->Size; ++at)
        {
          Set(values[at], this->GetIdAt(at));
        }
      });
    return copy;
  }

private:
  // Asks the arrays for their values once, since simplices are written one by one.
  void FindIds()
  {
    this->NarrowIds = this->Narrow ? this->Narrow->GetPointer(0) : nullptr;
    this->WideIds = this->Wide ? this->Wide->GetPointer(0) : nullptr;
    this->IsStreamed =
      this->Size == 4 && this->NarrowIds && IdRun::IsStreamed(this->NarrowIds, this->Number);
  }

  // Gives up the room after the last cell, whose ids end at \a ids.
  void Shorten(vtkIdType ids)
  {
    const auto shorten = [](auto& array, vtkIdType size)
    {
      if (array)
      {
        ExtractionMemory::Shorten(array, size);
      }
    };
    shorten(this->Narrow, ids);
    shorten(this->Wide, ids);
    shorten(this->NarrowOffsets, this->Number + this->NumberOfWhole + 1);
    shorten(this->WideOffsets, this->Number + this->NumberOfWhole + 1);
    this->FindIds();
  }

  // Visits the ids and the offsets, where there are whole cells.
  template <typename Visitor>
  void VisitAll(Visitor&& visit) const
  {
    if (this->Narrow)
    {
      visit(this->Narrow->GetPointer(0), this->NarrowOffsets->GetPointer(0));
    }
    else
    {
      visit(this->Wide->GetPointer(0), this->WideOffsets->GetPointer(0));
    }
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
  vtkSmartPointer<Array> NewOffsets() const
  {
    auto offsets = vtkSmartPointer<Array>::New();
    ExtractionMemory::SetNumberOfTuples(offsets, this->Number + this->NumberOfWhole + 1);
    return offsets;
  }

  // Completes the offsets; those of whole cells, where there are any, are there.
  template <typename Array>
  vtkSmartPointer<Array> MakeOffsets(const vtkSmartPointer<Array>& ofWhole) const
  {
    using Id = typename Array::ValueType;
    const vtkSmartPointer<Array> offsets = ofWhole ? ofWhole : this->NewOffsets<Array>();
    Id* values = offsets->GetPointer(0);
    const Id size = this->Size;
    const bool isStreamed = this->IsStreamed;
    vtkSMPTools::For(0, this->Number + (ofWhole ? 0 : 1), ThreadGrain,
      [values, size, isStreamed](vtkIdType first, vtkIdType last)
      { IdRun::FillMultiples(values, size, first, last, isStreamed); });
    return offsets;
  }

  vtkIdType Number = 0;
  int Size = 4;
  vtkIdType NumberOfWhole = 0;
  vtkSmartPointer<vtkTypeInt32Array> Narrow;
  vtkSmartPointer<vtkTypeInt64Array> Wide;
  // The values of the one that is there.
  vtkTypeInt32* NarrowIds = nullptr;
  vtkTypeInt64* WideIds = nullptr;
  // Whether runs of ids are written past the cache.
  bool IsStreamed = false;
  // The offsets of all cells, where there are whole cells; else null.
  vtkSmartPointer<vtkTypeInt32Array> NarrowOffsets;
  vtkSmartPointer<vtkTypeInt64Array> WideOffsets;
};

}

#endif
