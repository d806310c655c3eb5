// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexList_h
#define interlume_SimplexList_h

#include "Output/ExtractionBuffer.h"

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
#include <vector>

namespace interlume
{

/**
 * @class   SimplexList
 * @brief   the point ids of tetrahedra or triangles, in 32 bits where they fit
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

  /// Makes room for \a number simplices of \a size points each.
  void Allocate(vtkIdType number, int size, vtkIdType numberOfPoints)
  {
    this->Number = number;
    this->Size = size;
    this->Narrow = nullptr;
    this->Wide = nullptr;
    if (AreIdsNarrow(numberOfPoints, number * size))
    {
      this->Narrow = vtkSmartPointer<vtkTypeInt32Array>::New();
      this->Narrow->SetNumberOfValues(number * size);
      ExtractionMemory::PreferLargePages(this->Narrow);
    }
    else
    {
      this->Wide = vtkSmartPointer<vtkTypeInt64Array>::New();
      this->Wide->SetNumberOfValues(number * size);
      ExtractionMemory::PreferLargePages(this->Wide);
    }
  }

  vtkIdType GetId(vtkIdType simplex, int point) const
  {
    const vtkIdType at = simplex * this->Size + point;
    return this->Wide ? static_cast<vtkIdType>(this->Wide->GetValue(at))
                      : static_cast<vtkIdType>(this->Narrow->GetValue(at));
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

  /// Puts a simplex in the place of another.
  void Move(vtkIdType from, vtkIdType to)
  {
    this->Visit([&](auto* values)
      { std::copy_n(values + from * this->Size, this->Size, values + to * this->Size); });
  }

  /// Forgets all but the first \a number simplices.
  void Truncate(vtkIdType number)
  {
    this->Number = number;
    if (this->Narrow)
    {
      this->Narrow->SetNumberOfValues(number * this->Size);
    }
    else if (this->Wide)
    {
      this->Wide->SetNumberOfValues(number * this->Size);
    }
  }

  /**
   * Leaves out the points whose mark is 0; the others keep their order. \a visit(old, kept) is
   * called for each point in order, with the number of points kept before it.
   */
  template <typename Mark, typename Visitor>
  void RemovePoints(const Mark* marks, vtkIdType numberOfPoints, Visitor&& visit)
  {
    this->Visit(
      [&](auto* values)
      {
        std::vector<std::decay_t<decltype(*values)>> newIds(numberOfPoints);
        vtkIdType kept = 0;
        for (vtkIdType p = 0; p < numberOfPoints; ++p)
        {
          Set(newIds[p], kept);
          visit(p, kept);
          kept += marks[p] != 0;
        }
        vtkSMPTools::For(0, this->Number * this->Size,
          [values, &newIds](vtkIdType first, vtkIdType last)
          {
            for (vtkIdType i = first; i < last; ++i)
            {
              values[i] = newIds[values[i]];
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
      cells->SetData(this->MakeOffsets<vtkTypeInt32Array>(), this->Narrow);
    }
    else if (this->Wide)
    {
      cells->SetData(this->MakeOffsets<vtkTypeInt64Array>(), this->Wide);
    }
    return cells;
  }

private:
  template <typename Visitor>
  void Visit(Visitor&& visit)
  {
    if (this->Narrow)
    {
      visit(this->Narrow->GetPointer(0));
    }
    else if (this->Wide)
    {
      visit(this->Wide->GetPointer(0));
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
  vtkSmartPointer<Array> MakeOffsets() const
  {
    using Id = typename Array::ValueType;
    auto offsets = vtkSmartPointer<Array>::New();
    offsets->SetNumberOfValues(this->Number + 1);
    ExtractionMemory::PreferLargePages(offsets);
    Id* values = offsets->GetPointer(0);
    const Id size = this->Size;
    vtkSMPTools::For(0, this->Number + 1,
      [values, size](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          values[i] = static_cast<Id>(i) * size;
        }
      });
    return offsets;
  }

  vtkIdType Number = 0;
  int Size = 4;
  vtkSmartPointer<vtkTypeInt32Array> Narrow;
  vtkSmartPointer<vtkTypeInt64Array> Wide;
};

}

#endif
