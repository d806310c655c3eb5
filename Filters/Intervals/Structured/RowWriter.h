// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowWriter_h
#define interlume_RowWriter_h

#include "Cuts/MergedCut.h"
#include "Grid/CellOrientation.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionContext.h"
#include "Structured/CellRow.h"
#include "Structured/RowCount.h"
#include "Structured/SlotLocation.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace interlume
{

/**
 * @class   RowWriter
 * @brief   writes the output of rows of cells to a mesh with allocated arrays
 *
 * Each call writes at a position and advances it. Threads may write different rows at the same
 * time. If requested, marks the points that simplices use.
 */
class RowWriter
{
public:
  using Code = ExtractionValues::Code;
  using Slot = vtkIsotable::Slot;

  /// The previous cell inside an interval in a row of cells.
  struct InsideCell
  {
    vtkIdType Column = -1;
    vtkIdType Corners[8] = {};
    bool IsInverted = false;
  };

  /// All arguments must outlive this object.
  RowWriter(const ExtractionContext& context, const vtkIsotable& table, const RowIndex& rows,
    ExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Table(table)
    , Rows(rows)
    , Mesh(mesh)
    , SlotLocations(SlotLocation::FindAll(table, *context.Values))
    , Orientation(context.Input)
    , SimplexSize(context.GetSimplexSize())
  {
  }

  const std::vector<SlotLocation>& GetSlotLocations() const { return this->SlotLocations; }
  const CellOrientation& GetOrientation() const { return this->Orientation; }

  /// Allocates marks for \a points output points and initializes them to zero.
  void StartMarks(vtkIdType points)
  {
    this->MarksUsed = true;
    this->Mesh.Used.AllocateZeros(points);
  }

  /// Marks an output point as used if StartMarks() was called.
  void Use(vtkIdType point)
  {
    if (this->MarksUsed)
    {
      this->Mesh.Used[point].store(1, std::memory_order_relaxed);
    }
  }

  /// Writes the output of a cell, using its table case.
  void WriteCell(
    const CellRow& row, vtkIdType i, int item, const vtkIsotable::Case& found, RowCount& position)
  {
    const auto& what = this->Values.GetItems()[item];
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    for (const Slot slot : found.Slots)
    {
      ids[slot] = this->GetId(row, i, what, slot);
    }
    this->Use(found.Slots.data(), found.Slots.size(), ids);
    const bool isInverted = this->Orientation.IsInverted(this->Rows, row.FirstPoint + i);
    this->WriteSimplices(row, i, item, found.Simplices, ids, isInverted, position);
    for (std::size_t t = 0; this->Context.GenerateBoundaries && t < found.Boundary.size(); ++t)
    {
      this->WriteTriangle(row, i, item, found.Boundary[t], ids, isInverted, position);
    }
  }

  /// Writes the output of a cell with merged slots. Appends the indices of its boundary triangles
  /// to \a tiedTriangles, and those of its simplices that lie in a face to \a tiedSimplices.
  void WriteTiedCell(const CellRow& row, vtkIdType i, int item, MergedCut& cut, RowCount& position,
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
        tiedSimplices.push_back(position.Simplices + (&simplex - simplices.data()));
      }
      else
      {
        this->Use(simplex.data(), this->SimplexSize, ids);
      }
    }
    this->WriteSimplices(row, i, item, simplices, ids, isInverted, position);
    for (const vtkIsotable::Triangle& triangle : cut.GetTriangles())
    {
      std::for_each_n(triangle.begin(), 3, find);
      this->Use(triangle.data(), 3, ids);
      tiedTriangles.push_back(position.Triangles);
      this->WriteTriangle(row, i, item, triangle, ids, isInverted, position);
    }
  }

  /// Writes the cells [first, last), which are inside an interval and have no boundary triangles.
  void WriteInside(const CellRow& row, vtkIdType first, vtkIdType last, int item,
    const vtkIsotable::Case& found, InsideCell& before, RowCount& position)
  {
    while (first < last)
    {
      this->WriteInside(row, first, item, found, before, position);
      const vtkIdType next =
        this->Orientation.IsPerCell() ? first + 1 : FindRunEnd(row, first, last);
      this->WriteRun(row, first + 1, next, item, found.Simplices.size(), before, position);
      first = next;
    }
  }

private:
  // Marks the points of the slots as used. This is a separate loop because the compiler must assume
  // that a mark may alias any other data.
  void Use(const Slot* slots, std::size_t number, const vtkIdType* ids)
  {
    std::atomic<unsigned char>* used = this->MarksUsed ? this->Mesh.Used.GetData() : nullptr;
    for (std::size_t s = 0; used && s < number; ++s)
    {
      used[ids[slots[s]]].store(1, std::memory_order_relaxed);
    }
  }

  // Returns the output point id of a slot.
  vtkIdType GetId(
    const CellRow& row, vtkIdType i, const ExtractionValues::Item& item, Slot slot) const
  {
    const SlotLocation& at = this->SlotLocations[slot];
    const CellRow::SlotRow& owner = row.Slots[slot];
    const vtkIdType id = owner.First + owner.Starts[i] + owner.Offsets[i];
    if (!at.MayFollow)
    {
      return id;
    }
    return id + (at.Kind == 0 ? item.Lower : item.Upper) -
      ExtractionValues::GetFirstCrossing(row.GetCode(i, at.Ends[0]), row.GetCode(i, at.Ends[1]));
  }

  // Inlined because a function call per cell would take measurable time.
  [[gnu::always_inline]] void WriteSimplices(const CellRow& row, vtkIdType i, int item,
    const std::vector<vtkIsotable::Simplex>& simplices, const vtkIdType* ids, bool isInverted,
    RowCount& position)
  {
    this->Mesh.Simplices.Write(
      position.Simplices, simplices.data(), simplices.size(), ids, isInverted);
    this->Mesh.SetSimplexOrigins(position.Simplices, simplices.size(), item, row.FirstCell + i);
    position.Simplices += static_cast<vtkIdType>(simplices.size());
  }

  void WriteTriangle(const CellRow& row, vtkIdType i, int item, const vtkIsotable::Triangle& slots,
    const vtkIdType* ids, bool isInverted, RowCount& position)
  {
    this->Mesh.WriteTriangle(position.Triangles++,
      { { ids[slots[0]], ids[slots[1]], ids[slots[2]] } }, isInverted, item, slots[3],
      row.FirstCell + i);
  }

  // Writes a cell inside an interval. Along a row of such cells, each corner's id usually exceeds
  // the id of the same corner of the previous cell by 1. Then the point ids of the simplices also
  // increase by 1.
  void WriteInside(const CellRow& row, vtkIdType i, int item, const vtkIsotable::Case& found,
    InsideCell& before, RowCount& position)
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
      this->WriteSimplices(row, i, item, found.Simplices, before.Corners, isInverted, position);
      return;
    }
    const std::size_t number = found.Simplices.size();
    this->Mesh.Simplices.WriteIncrementedCopies(position.Simplices, number, 1);
    this->Mesh.SetSimplexOrigins(position.Simplices, number, item, row.FirstCell + i);
    position.Simplices += static_cast<vtkIdType>(number);
  }

  // Returns the end of the range of cells that starts at \a first and in which the corner ids
  // increase by 1 from cell to cell.
  static vtkIdType FindRunEnd(const CellRow& row, vtkIdType first, vtkIdType last)
  {
    // Vertices 0, 2, 4 and 6 are at column i, one in each of the four rows of points.
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
    // A cell also uses the points of the next column.
    return std::max(first + 1, i - 1);
  }

  // Writes the cells [first, last), which follow the cell \a before inside the interval. The corner
  // ids increase by 1 from cell to cell.
  void WriteRun(const CellRow& row, vtkIdType first, vtkIdType last, int item, std::size_t number,
    InsideCell& before, RowCount& position)
  {
    const vtkIdType length = last - first;
    if (length == 0)
    {
      return;
    }
    this->Mesh.Simplices.WriteIncrementedCopies(position.Simplices, number, length);
    this->Mesh.SetRunOrigins(position.Simplices, number, length, item, row.FirstCell + first);
    position.Simplices += static_cast<vtkIdType>(number) * length;
    before.Column += length;
    // The last cell also uses the points of the next column. Each row of points contains two
    // corners of a cell.
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
  std::vector<SlotLocation> SlotLocations;
  CellOrientation Orientation;
  int SimplexSize;
  bool MarksUsed = false;
};

}

#endif
