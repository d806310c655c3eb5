// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InteriorCells_h
#define interlume_InteriorCells_h

#include "Grid/WholeCells.h"
#include "Unstructured/CellReader.h"
#include "Unstructured/CrossingLists.h"
#include "Unstructured/UnstructuredChunk.h"
#include "Unstructured/WholePolyhedra.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   InteriorCells
 * @brief   the cells of an unstructured grid that are inside of an interval and passed on as they
 *          are
 *
 * \a Stored is the type of the cell array's numbers. \a points is a buffer of the calling thread.
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
    , Whole(*context.Whole)
    , Reader(reader)
    , Cells(reader.GetCells())
    , Polyhedra(context, Cells)
  {
  }

  /// Finds the ranges of polyhedra; call it first. Returns false if the user aborted.
  bool FindRanges(vtkIdType numberOfCells)
  {
    return this->Polyhedra.FindRanges(this->Reader.GetCodes(), numberOfCells, 0.05, 0.05);
  }

  /// Returns the first of the cells that the pass before has passed on.
  vtkIdType GetFirstPassed() const { return this->Whole.GetFirstPassed(); }

  /// Returns whether a cell whose codes are least ... greatest is passed on. A tetrahedron is not:
  /// its case is that tetrahedron.
  bool IsInside(vtkIdType cell, const Item& item, Code least, Code greatest) const
  {
    if (this->Whole.IsPart(cell))
    {
      return this->Polyhedra.IsInside(cell, item);
    }
    const CellCorners& corners = this->Cells.GetCorners(cell);
    if (corners.Shape == vtkIsotable::TETRAHEDRON || !item.IsInside(least, greatest))
    {
      return false;
    }
    vtkIdType ids[8];
    this->Cells.GetIds(cell, corners, ids);
    return std::all_of(ids, ids + corners.NumberOfCorners,
      [this](vtkIdType point) { return this->Whole.MayHave(point); });
  }

  /// Counts a cell that is passed on in each interval that it touches. Returns false, and counts
  /// nothing, if it is not.
  bool Count(vtkIdType id, vtkIdType position, Chunk& chunk, CrossingLists& lists,
    CrossingLists::Arena& arena, std::vector<vtkIdType>& points) const
  {
    if (this->Whole.IsPassed(id))
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
    const auto [least, greatest] = this->Reader.ReadCodes(cell);
    const auto& items = this->Values.GetItems();
    for (const Item& item : items)
    {
      if (!this->Values.IsOutside(item, least, greatest) &&
        !this->IsInside(id, item, least, greatest))
      {
        return false;
      }
    }
    const vtkIdType before = chunk.GetOutput();
    for (std::size_t number = 0; number < items.size(); ++number)
    {
      if (!this->Values.IsOutside(items[number], least, greatest))
      {
        this->Enter(id, position, number, chunk, lists, arena, points);
      }
    }
    this->Reader.CountOutput(cell, chunk.GetOutput() != before, chunk.Report);
    return true;
  }

  /// Notes a cell that is passed on in an item, and enters its points.
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

  /// Writes the cells of a chunk that are passed on; its first one is \a begin.
  void Write(vtkIdType begin, const Chunk& chunk, const CrossingLists& lists, ExtractionMesh& mesh,
    std::vector<vtkIdType>& points) const
  {
    vtkIdType cell = chunk.Interior;
    vtkIdType place = chunk.InteriorIds;
    for (const Chunk::InteriorCell& found : chunk.InteriorCells)
    {
      const vtkIdType id = begin + found.Position;
      const unsigned char type = this->GetPoints(id, points);
      for (vtkIdType& point : points)
      {
        point = lists.GetId(point, {});
      }
      const int number = static_cast<int>(points.size());
      mesh.WriteWhole(cell++, place, type, points.data(), number, found.Item, id);
      place += number;
    }
  }

private:
  // Gives the points of a cell that is passed on, in their order in the input; none of a part of a
  // polyhedron but the first. Returns its type.
  unsigned char GetPoints(vtkIdType cell, std::vector<vtkIdType>& points) const
  {
    if (this->Whole.IsPassed(cell))
    {
      this->Cells.GetStored(cell, points);
      return this->Cells.GetType(cell);
    }
    if (this->Whole.IsPart(cell))
    {
      points.clear();
      if (this->Whole.IsFirstPart(cell))
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
  const WholeCells& Whole;
  const CellReader<Stored>& Reader;
  const UnstructuredCells<Stored>& Cells;
  WholePolyhedra<Stored> Polyhedra;
};

}

#endif
