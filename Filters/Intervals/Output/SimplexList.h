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
    this->Narrow = {};
    this->Wide = {};
    const vtkIdType ids = number * size + wholeIds;
    const auto allocate = [&](auto& list)
    {
      using Array = std::decay_t<decltype(*list.Values)>;
      list.Values = vtkSmartPointer<Array>::New();
      ExtractionMemory::SetNumberOfTuples(list.Values, ids);
      if (wholeCells > 0)
      {
        list.Offsets = this->NewOffsets<Array>();
        Set(list.Offsets->GetPointer(0)[number + wholeCells], ids);
      }
    };
    AreIdsNarrow(numberOfPoints, ids) ? allocate(this->Narrow) : allocate(this->Wide);
    this->FindIds();
  }

  vtkIdType GetNumber() const { return this->Number; }
  vtkIdType GetNumberOfWhole() const { return this->NumberOfWhole; }

  /// Returns the number of ids of all cells, and one of them; those of whole cells are the last.
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

  /// Returns the places [first, last) of a whole cell's ids among all ids.
  std::pair<vtkIdType, vtkIdType> GetWhole(vtkIdType cell) const
  {
    const vtkIdType at = this->Number + cell;
    std::pair<vtkIdType, vtkIdType> places;
    this->VisitAll([&](auto*, const auto* offsets) { places = { offsets[at], offsets[at + 1] }; });
    return places;
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
      IdRun::Stream(this->Narrow.Ids + place, ids, cells);
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
    this->VisitList([&visit](const auto& list) { visit(list.Ids); });
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
    this->VisitList(
      [&](const auto& list) { cells->SetData(this->MakeOffsets(list.Offsets), list.Values); });
    return cells;
  }

  /// Makes a copy of the simplices alone.
  SimplexList CopySimplices() const
  {
    SimplexList copy;
    copy.Allocate(
      this->Number, this->Size, this->Wide.Values ? std::numeric_limits<vtkIdType>::max() : 0);
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
  // The ids of all cells, and their memory: simplices are written one by one.
  template <typename Array>
  struct IdList
  {
    vtkSmartPointer<Array> Values;
    typename Array::ValueType* Ids = nullptr;
    // The offsets of all cells, where there are whole cells; else null.
    vtkSmartPointer<Array> Offsets;

    void FindIds() { this->Ids = this->Values ? this->Values->GetPointer(0) : nullptr; }
  };

  void FindIds()
  {
    this->Narrow.FindIds();
    this->Wide.FindIds();
    this->IsStreamed =
      this->Size == 4 && this->Narrow.Ids && IdRun::IsStreamed(this->Narrow.Ids, this->Number);
  }

  // Visits the list that is there.
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

  // Gives up the room after the last cell, whose ids end at \a ids.
  void Shorten(vtkIdType ids)
  {
    this->VisitList(
      [&](const auto& list)
      {
        ExtractionMemory::Shorten(list.Values, ids);
        if (list.Offsets)
        {
          ExtractionMemory::Shorten(list.Offsets, this->Number + this->NumberOfWhole + 1);
        }
      });
    this->FindIds();
  }

  // Visits the ids and the offsets, where there are whole cells.
  template <typename Visitor>
  void VisitAll(Visitor&& visit) const
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
  // One of these is there.
  IdList<vtkTypeInt32Array> Narrow;
  IdList<vtkTypeInt64Array> Wide;
  // Whether runs of ids are written past the cache.
  bool IsStreamed = false;
};

}

#endif
