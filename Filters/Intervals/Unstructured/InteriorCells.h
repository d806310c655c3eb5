// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InteriorCells_h
#define interlume_InteriorCells_h

#include "Grid/InteriorCellFilter.h"
#include "Unstructured/CellReader.h"
#include "Unstructured/CrossingLists.h"
#include "Unstructured/UnstructuredChunk.h"
#include "Unstructured/InteriorPolyhedra.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   InteriorCells
 * @brief   copies the cells inside an interval to the output without cutting them
 *
 * \a Stored is the integer type of the offsets and connectivity arrays. In all methods, \a points
 * is a buffer of the calling thread.
 */
template <typename Stored>
class InteriorCells
{
public:
  using Cell = TableCell<1>;
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;
  using Chunk = UnstructuredChunk;

  InteriorCells(const ExtractionContext& context, const CellReader<Stored>& reader)
    : Values(*context.Values)
    , Filter(*context.InteriorFilter)
    , Reader(reader)
    , Cells(reader.GetCells())
    , Polyhedra(context, Cells)
  {
  }

  /// Computes the ranges of the codes of polyhedra. Call this first. Returns false if the user
  /// aborted.
  bool FindRanges(vtkIdType numberOfCells)
  {
    return this->Polyhedra.FindRanges(this->Reader.GetCodes(), numberOfCells, 0.05, 0.05);
  }

  /// Returns the first cell that the previous pass copied uncut.
  vtkIdType GetFirstPassedCell() const { return this->Filter.GetFirstPassedCell(); }

  /// Returns true if a cell with codes from \a minimum to \a maximum is copied uncut for \a item.
  /// Tetrahedra are not, because cutting them yields the same tetrahedra.
  bool IsInside(vtkIdType cell, const Item& item, Code minimum, Code maximum) const
  {
    if (this->Filter.IsPart(cell))
    {
      return this->Polyhedra.IsInside(cell, item);
    }
    const CellCorners& corners = this->Cells.GetCorners(cell);
    if (corners.Shape == vtkIsotable::TETRAHEDRON || !item.IsInside(minimum, maximum))
    {
      return false;
    }
    vtkIdType ids[8];
    this->Cells.GetIds(cell, corners, ids);
    return std::all_of(ids, ids + corners.NumberOfCorners,
      [this](vtkIdType point) { return this->Filter.SatisfiesCriteria(point); });
  }

  /// Counts a cell that is copied uncut for every interval that it intersects. If the cell has to
  /// be cut for any interval, returns false and counts nothing.
  bool Count(vtkIdType id, vtkIdType position, Chunk& chunk, CrossingLists& lists,
    CrossingLists::Arena& arena, std::vector<vtkIdType>& points) const
  {
    if (this->Filter.IsPassedThrough(id))
    {
      this->Enter(id, position, 0, chunk, lists, arena, points);
      ++chunk.Report.CellsWithOutput;
      return true;
    }
    Cell cell;
    const CellCorners& corners = this->Cells.GetCorners(id);
    cell.Shape = corners.Shape;
    cell.NumberOfCorners = corners.NumberOfCorners;
    this->Cells.GetIds(id, corners, cell.Ids);
    const auto [minimum, maximum] = this->Reader.ReadCodes(cell);
    const auto& items = this->Values.GetItems();
    for (const Item& item : items)
    {
      if (!this->Values.IsOutside(item, minimum, maximum) &&
        !this->IsInside(id, item, minimum, maximum))
      {
        return false;
      }
    }
    const vtkIdType before = chunk.GetOutput();
    for (std::size_t number = 0; number < items.size(); ++number)
    {
      if (!this->Values.IsOutside(items[number], minimum, maximum))
      {
        this->Enter(id, position, number, chunk, lists, arena, points);
      }
    }
    this->Reader.CountOutput(cell, chunk.GetOutput() != before, chunk.Report);
    return true;
  }

  /// Records that a cell is copied uncut for an item, and enters its points.
  void Enter(vtkIdType id, vtkIdType position, std::size_t item, Chunk& chunk, CrossingLists& lists,
    CrossingLists::Arena& arena, std::vector<vtkIdType>& points) const
  {
    this->GetPoints(id, points);
    if (points.empty())
    {
      return;
    }
    for (const vtkIdType point : points)
    {
      lists.Enter(point, {}, arena);
    }
    ++chunk.Interior;
    chunk.InteriorIds += static_cast<vtkIdType>(points.size());
    chunk.InteriorCells.push_back(
      { static_cast<std::uint16_t>(position), static_cast<std::uint16_t>(item) });
  }

  /// Writes the interior cells of a chunk. \a begin is the id of the first cell of the chunk.
  void Write(vtkIdType begin, const Chunk& chunk, const CrossingLists& lists, ExtractionMesh& mesh,
    std::vector<vtkIdType>& points) const
  {
    vtkIdType cell = chunk.Interior;
    vtkIdType firstId = chunk.InteriorIds;
    for (const Chunk::InteriorCell& found : chunk.InteriorCells)
    {
      const vtkIdType id = begin + found.Position;
      const unsigned char type = this->GetPoints(id, points);
      for (vtkIdType& point : points)
      {
        point = lists.GetId(point, {});
      }
      const int number = static_cast<int>(points.size());
      mesh.WriteInteriorCell(cell++, firstId, type, points.data(), number, found.Item, id);
      firstId += number;
    }
  }

private:
  // Returns the type of an interior cell, and gets its points in the order of the input. The points
  // of a polyhedron are returned for its first part only.
  unsigned char GetPoints(vtkIdType cell, std::vector<vtkIdType>& points) const
  {
    if (this->Filter.IsPassedThrough(cell))
    {
      this->Cells.GetStored(cell, points);
      return this->Cells.GetType(cell);
    }
    if (this->Filter.IsPart(cell))
    {
      points.clear();
      if (this->Filter.IsFirstPart(cell))
      {
        this->Polyhedra.GetPoints(cell, points);
      }
      return this->Polyhedra.GetType(cell);
    }
    this->Cells.GetStored(cell, points);
    const CellCorners& corners = this->Cells.GetCorners(cell);
    points.resize(corners.NumberOfCorners);
    return corners.Kind == CellCorners::LINEAR ? this->Cells.GetType(cell)
                                               : corners.GetLinearType();
  }

  const ExtractionValues& Values;
  const InteriorCellFilter& Filter;
  const CellReader<Stored>& Reader;
  const UnstructuredCells<Stored>& Cells;
  InteriorPolyhedra<Stored> Polyhedra;
};

}

#endif
