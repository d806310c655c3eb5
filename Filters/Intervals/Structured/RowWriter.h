// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowWriter_h
#define interlume_RowWriter_h

#include "Cuts/MergedCut.h"
#include "Grid/CellOrientation.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionContext.h"
#include "Structured/CellRow.h"
#include "Structured/RowCount.h"
#include "Structured/SlotPlace.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace interlume
{

/**
 * @class   RowWriter
 * @brief   writes what the cells of a row give into a mesh that has room for it
 *
 * Each call writes at a place and moves it on. Threads may write rows at the same time. Points of
 * the output are marked as used, if asked for.
 */
class RowWriter
{
public:
  using Code = ExtractionValues::Code;
  using Slot = vtkIsotable::Slot;

  /// The cell inside of an interval that was written last in a row.
  struct CellInside
  {
    vtkIdType Column = -1;
    vtkIdType Corners[8] = {};
    bool IsInverted = false;
  };

  /// All of these must outlive this.
  RowWriter(const ExtractionContext& context, const vtkIsotable& table, const RowIndex& rows,
    ExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Table(table)
    , Rows(rows)
    , Mesh(mesh)
    , Places(SlotPlace::FindAll(table, *context.Values))
    , Orientation(context.Input)
    , SimplexSize(context.GetSimplexSize())
  {
  }

  const std::vector<SlotPlace>& GetPlaces() const { return this->Places; }
  const CellOrientation& GetOrientation() const { return this->Orientation; }

  /// Makes room for the marks of \a points points, of which none is used yet.
  void StartMarks(vtkIdType points)
  {
    this->MarksUsed = true;
    this->Mesh.Used.AllocateZeros(points);
  }

  /// Marks a point as used.
  void Use(vtkIdType point)
  {
    if (this->MarksUsed)
    {
      this->Mesh.Used[point].store(1, std::memory_order_relaxed);
    }
  }

  /// Writes a cell by its case of the table.
  void WriteCell(
    const CellRow& row, vtkIdType i, int item, const vtkIsotable::Case& found, RowCount& place)
  {
    const auto& what = this->Values.GetItems()[item];
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    for (const Slot slot : found.Slots)
    {
      ids[slot] = this->GetId(row, i, what, slot);
    }
    this->Use(found.Slots.data(), found.Slots.size(), ids);
    const bool isInverted = this->Orientation.IsInverted(this->Rows, row.FirstPoint + i);
    this->WriteSimplices(row, i, item, found.Simplices, ids, isInverted, place);
    for (std::size_t t = 0; this->Context.GenerateBoundaries && t < found.Boundary.size(); ++t)
    {
      this->WriteTriangle(row, i, item, found.Boundary[t], ids, isInverted, place);
    }
  }

  /// Writes a cell whose slots that are one point have been made one, and lists its simplices that
  /// lie in a face, and its triangles.
  void WriteTied(const CellRow& row, vtkIdType i, int item, MergedCut& cut, RowCount& place,
    std::vector<vtkIdType>& tiedSimplices, std::vector<vtkIdType>& tiedTriangles)
  {
    const auto& what = this->Values.GetItems()[item];
    const auto& simplices = cut.GetSimplices();
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    const auto find = [&](Slot slot) { ids[slot] = this->GetId(row, i, what, slot); };
    const bool isInverted = this->Orientation.IsInverted(this->Rows, row.FirstPoint + i);
    for (const vtkIsotable::Simplex& simplex : simplices)
    {
      std::for_each_n(simplex.begin(), this->SimplexSize, find);
      if (cut.IsInFace(this->Table, simplex))
      {
        tiedSimplices.push_back(place.Simplices + (&simplex - simplices.data()));
      }
      else
      {
        this->Use(simplex.data(), this->SimplexSize, ids);
      }
    }
    this->WriteSimplices(row, i, item, simplices, ids, isInverted, place);
    for (const vtkIsotable::Triangle& triangle : cut.GetTriangles())
    {
      std::for_each_n(triangle.begin(), 3, find);
      this->Use(triangle.data(), 3, ids);
      tiedTriangles.push_back(place.Triangles);
      this->WriteTriangle(row, i, item, triangle, ids, isInverted, place);
    }
  }

  /// Writes the cells [first, last) inside of an interval, which have no boundary.
  void WriteInside(const CellRow& row, vtkIdType first, vtkIdType last, int item,
    const vtkIsotable::Case& found, CellInside& before, RowCount& place)
  {
    while (first < last)
    {
      this->WriteInside(row, first, item, found, before, place);
      const vtkIdType next =
        this->Orientation.IsPerCell() ? first + 1 : FindBreak(row, first, last);
      this->WriteRun(row, first + 1, next, item, found.Simplices.size(), before, place);
      first = next;
    }
  }

private:
  // Marks the points of some slots as used; apart from other work, since a compiler has to think
  // that a mark may change anything.
  void Use(const Slot* slots, std::size_t number, const vtkIdType* ids)
  {
    std::atomic<unsigned char>* used = this->MarksUsed ? this->Mesh.Used.GetData() : nullptr;
    for (std::size_t s = 0; used && s < number; ++s)
    {
      used[ids[slots[s]]].store(1, std::memory_order_relaxed);
    }
  }

  // Returns the output id of a slot.
  vtkIdType GetId(
    const CellRow& row, vtkIdType i, const ExtractionValues::Item& item, Slot slot) const
  {
    const SlotPlace& at = this->Places[slot];
    const CellRow::SlotRow& owner = row.Slots[slot];
    const vtkIdType id = owner.First + owner.Starts[i] + owner.Offsets[i];
    if (!at.MayFollow)
    {
      return id;
    }
    return id + (at.Kind == 0 ? item.Lower : item.Upper) -
      ExtractionValues::GetFirstCrossing(row.GetCode(i, at.Ends[0]), row.GetCode(i, at.Ends[1]));
  }

  // A call of its own for each cell would take 3 % of an extraction.
  [[gnu::always_inline]] void WriteSimplices(const CellRow& row, vtkIdType i, int item,
    const std::vector<vtkIsotable::Simplex>& simplices, const vtkIdType* ids, bool isInverted,
    RowCount& place)
  {
    this->Mesh.Simplices.Write(
      place.Simplices, simplices.data(), simplices.size(), ids, isInverted);
    this->Mesh.NoteSimplices(place.Simplices, simplices.size(), item, row.FirstCell + i);
    place.Simplices += static_cast<vtkIdType>(simplices.size());
  }

  void WriteTriangle(const CellRow& row, vtkIdType i, int item, const vtkIsotable::Triangle& slots,
    const vtkIdType* ids, bool isInverted, RowCount& place)
  {
    this->Mesh.WriteTriangle(place.Triangles++, { { ids[slots[0]], ids[slots[1]], ids[slots[2]] } },
      isInverted, item, slots[3], row.FirstCell + i);
  }

  // Writes a cell inside of an interval. Along a row of such cells each point's id is mostly one
  // more than that of the cell before, and so are those of the simplices.
  void WriteInside(const CellRow& row, vtkIdType i, int item, const vtkIsotable::Case& found,
    CellInside& before, RowCount& place)
  {
    const bool isInverted = this->Orientation.IsInverted(this->Rows, row.FirstPoint + i);
    bool isNext = before.Column + 1 == i && before.IsInverted == isInverted;
    for (int v = 0; v < 8; ++v)
    {
      const vtkIdType id = row.GetVertexId(i, v);
      isNext &= id == before.Corners[v] + 1;
      before.Corners[v] = id;
    }
    before.Column = i;
    before.IsInverted = isInverted;
    this->Use(found.Slots.data(), found.Slots.size(), before.Corners);
    if (!isNext)
    {
      this->WriteSimplices(row, i, item, found.Simplices, before.Corners, isInverted, place);
      return;
    }
    const std::size_t number = found.Simplices.size();
    this->Mesh.Simplices.WriteNext(place.Simplices, number, 1);
    this->Mesh.NoteSimplices(place.Simplices, number, item, row.FirstCell + i);
    place.Simplices += static_cast<vtkIdType>(number);
  }

  // Returns the end of the cells inside after the first each of whose points has an id one more
  // than that of the cell before.
  static vtkIdType FindBreak(const CellRow& row, vtkIdType first, vtkIdType last)
  {
    // Vertices 0, 2, 4 and 6 are at the columns' beginnings, in the four rows.
    const std::uint32_t* starts[4];
    for (int r = 0; r < 4; ++r)
    {
      starts[r] = row.Slots[2 * r].Starts;
    }
    const auto isNext = [&starts](vtkIdType i)
    {
      return starts[0][i] == starts[0][i - 1] + 1 && starts[1][i] == starts[1][i - 1] + 1 &&
        starts[2][i] == starts[2][i - 1] + 1 && starts[3][i] == starts[3][i - 1] + 1;
    };
    vtkIdType i = first + 1;
    while (i <= last && isNext(i))
    {
      ++i;
    }
    // The last cell's points end a column later.
    return std::max(first + 1, i - 1);
  }

  // Writes the cells [first, last) inside of an interval that follow one, where each id is one more
  // than that of the cell before.
  void WriteRun(const CellRow& row, vtkIdType first, vtkIdType last, int item, std::size_t number,
    CellInside& before, RowCount& place)
  {
    const vtkIdType length = last - first;
    if (length == 0)
    {
      return;
    }
    this->Mesh.Simplices.WriteNext(place.Simplices, number, length);
    this->Mesh.NoteRun(place.Simplices, number, length, item, row.FirstCell + first);
    place.Simplices += static_cast<vtkIdType>(number) * length;
    before.Column += length;
    // The last cell's points end a column later; each row's are those of two corners.
    for (int v = 0; this->MarksUsed && v < 8; v += 2)
    {
      for (vtkIdType id = before.Corners[v] + 1; id <= before.Corners[v] + length + 1; ++id)
      {
        this->Use(id);
      }
    }
    for (vtkIdType& corner : before.Corners)
    {
      corner += length;
    }
  }

  const ExtractionContext& Context;
  const ExtractionValues& Values;
  const vtkIsotable& Table;
  const RowIndex& Rows;
  ExtractionMesh& Mesh;
  std::vector<SlotPlace> Places;
  CellOrientation Orientation;
  int SimplexSize;
  bool MarksUsed = false;
};

}

#endif
