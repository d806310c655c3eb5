// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredCells_h
#define interlume_UnstructuredCells_h

#include "Common/GridCells.h"
#include "Grid/CellCorners.h"
#include "Unstructured/PointMarks.h"

#include "vtkCellArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   UnstructuredCells
 * @brief   reads the corners of the cells of an unstructured grid from its arrays
 *
 * \a Stored is the integer type of the offsets and connectivity arrays.
 */
template <typename Stored>
class UnstructuredCells
{
public:
  using Mark = PointMarks::Mark;

  /// \a offsets and \a ids are the offsets and the connectivity of the cells of \a grid. Cells of
  /// another dimension than \a dimension have no table.
  UnstructuredCells(
    vtkUnstructuredGrid* grid, const Stored* offsets, const Stored* ids, int dimension = 3)
    : TypeArray(GridCells::GetTypes(grid))
    , Types(this->TypeArray->GetPointer(0))
    , Offsets(offsets)
    , Ids(ids)
    , Dimension(dimension)
  {
    // If all cells have the same type, and the connectivity array has no extra ids, the cells are
    // stored at a constant stride.
    const vtkIdType cells = grid->GetNumberOfCells();
    const CellCorners& first = this->GetCorners(0);
    const bool isUniform = this->HasTable(first) && first.Kind != CellCorners::HIGHER_ORDER &&
      grid->GetCells()->GetNumberOfConnectivityIds() == cells * first.NumberOfCorners &&
      GridCells::AreTypesEqual(this->Types, cells);
    this->Stride = isUniform ? first.NumberOfCorners : 0;
  }

  /// Returns true if all cells have the same linear type.
  bool IsUniform() const { return this->Stride > 0; }

  const CellCorners& GetCorners(vtkIdType cell) const
  {
    return this->CornersOfType[this->Types[cell]];
  }

  bool HasTable(const CellCorners& corners) const { return corners.HasTable(this->Dimension); }

  /// Returns the bitwise OR of the marks of a cell's corners.
  Mark GetMarks(vtkIdType cell, int corners, const Mark* marks) const
  {
    const Stored* ids = this->GetFirst(cell);
    unsigned all = 0;
    for (int v = 0; v < corners; ++v)
    {
      all |= marks[ids[v]];
    }
    return static_cast<Mark>(all);
  }

  /// Calls visit(cell, all) for the cells in [first, last) of a uniform grid, where all is the
  /// bitwise OR of the marks of the cell's corners.
  template <typename Visitor>
  void ForEachMarkUnion(vtkIdType first, vtkIdType last, const Mark* marks, Visitor&& visit) const
  {
    switch (this->Stride)
    {
      case 3:
        return this->template UniteAll<3>(first, last, marks, visit);
      case 4:
        return this->template UniteAll<4>(first, last, marks, visit);
      case 5:
        return this->template UniteAll<5>(first, last, marks, visit);
      case 6:
        return this->template UniteAll<6>(first, last, marks, visit);
      default:
        return this->template UniteAll<8>(first, last, marks, visit);
    }
  }

  /// Gets the point ids of a cell's corners in the order of the case table.
  void GetIds(vtkIdType cell, const CellCorners& corners, vtkIdType* ids) const
  {
    const Stored* from = this->GetFirst(cell);
    for (int v = 0; v < corners.NumberOfCorners; ++v)
    {
      ids[v] = from[v];
    }
    if (corners.Turned)
    {
      std::swap(ids[2], ids[3]);
      std::swap(ids[6], ids[7]);
    }
  }

  /// Calls visit(point) for every second corner of a cell. This suffices for prefetching, because
  /// in most grids the next corner is adjacent in memory.
  template <typename Visitor>
  void ForEachSecondPoint(vtkIdType cell, Visitor&& visit) const
  {
    const Stored* ids = this->GetFirst(cell);
    const int corners = this->GetCorners(cell).NumberOfCorners;
    for (int v = 0; v < corners; v += 2)
    {
      visit(ids[v]);
    }
  }

  /// Gets all points of a cell in storage order.
  void GetStored(vtkIdType cell, std::vector<vtkIdType>& points) const
  {
    points.assign(this->Ids + this->Offsets[cell], this->Ids + this->Offsets[cell + 1]);
  }

  unsigned char GetType(vtkIdType cell) const { return this->Types[cell]; }

private:
  static const CellCorners* GetCornersByType()
  {
    static const std::array<CellCorners, 256> corners = []()
    {
      std::array<CellCorners, 256> made;
      for (int type = 0; type < 256; ++type)
      {
        made[type] = CellCorners::Of(type);
      }
      return made;
    }();
    return corners.data();
  }

  const Stored* GetFirst(vtkIdType cell) const
  {
    return this->Ids +
      (this->Stride > 0 ? cell * this->Stride : static_cast<vtkIdType>(this->Offsets[cell]));
  }

  template <int Number, typename Visitor>
  void UniteAll(vtkIdType first, vtkIdType last, const Mark* marks, Visitor&& visit) const
  {
    const Stored* ids = this->Ids + first * Number;
    for (vtkIdType cell = first; cell < last; ++cell, ids += Number)
    {
      unsigned all = marks[ids[0]];
      for (int v = 1; v < Number; ++v)
      {
        all |= marks[ids[v]];
      }
      visit(cell, static_cast<Mark>(all));
    }
  }

  vtkSmartPointer<GridCells::Types> TypeArray;
  const unsigned char* Types;
  const Stored* Offsets;
  const Stored* Ids;
  int Dimension;
  // Number of corners of each cell of a uniform grid, otherwise 0.
  int Stride = 0;
  const CellCorners* CornersOfType = GetCornersByType();
};

template <typename Array, typename Visitor>
bool VisitCellArraysAs(vtkCellArray* cells, Visitor&& visit)
{
  const auto offsets = ArrayViews::Get<Array>(cells->GetOffsetsArray());
  const auto ids = ArrayViews::Get<Array>(cells->GetConnectivityArray());
  return visit(offsets->GetPointer(0), ids->GetPointer(0));
}

/// Calls visit(offsets, ids) with the offsets and connectivity arrays of a grid in their storage
/// type. Returns the result of the call.
template <typename Visitor>
bool VisitCellArrays(vtkUnstructuredGrid* grid, Visitor&& visit)
{
  vtkCellArray* cells = grid->GetCells();
  return GridCells::IsNarrow(cells->GetConnectivityArray())
    ? VisitCellArraysAs<GridCells::NarrowIds>(cells, visit)
    : VisitCellArraysAs<GridCells::WideIds>(cells, visit);
}

}

#endif
