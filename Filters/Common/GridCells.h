// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridCells_h
#define interlume_GridCells_h

#include "Common/ArrayViews.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersion.h"

#include <algorithm>
#include <array>
#include <string>

namespace interlume
{

/**
 * @class   GridCells
 * @brief   access to the cell storage of an unstructured grid, for all supported VTK versions
 *
 * Handles these differences between VTK versions:
 * - Cell types: up to VTK 9.5, GetCellTypesArray returns a vtkUnsignedCharArray. From 9.6,
 *   GetCellTypes returns an array that may be implicit if all cells have the same type.
 * - Offsets and point ids: up to 9.5, both are vtkTypeInt32Array or both are vtkTypeInt64Array.
 *   From 9.6, they may be of any array class, and offsets of cells of equal size may be implicit.
 * - Faces of polyhedra: up to 9.3, a face stream and the index in it at which each cell starts.
 *   From 9.4, two vtkCellArray: the faces of each cell and the points of each face.
 */
class GridCells
{
public:
  using Types = vtkAOSDataArrayTemplate<unsigned char>;
  using NarrowIds = vtkAOSDataArrayTemplate<vtkTypeInt32>;
  using WideIds = vtkAOSDataArrayTemplate<vtkTypeInt64>;

  /// Returns the array of cell types, which may be implicit, or null if there are no cells.
  static vtkDataArray* GetStoredTypes(vtkUnstructuredGrid* grid)
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
    return grid->GetCellTypes();
#else
    return grid->GetCellTypesArray();
#endif
  }

  /// Returns the cell types as a contiguous array: the grid's array, or a copy if it is implicit.
  static vtkSmartPointer<Types> GetTypes(vtkUnstructuredGrid* grid)
  {
    vtkDataArray* stored = GetStoredTypes(grid);
    return stored ? ArrayViews::Get<Types>(stored) : vtkSmartPointer<Types>::New();
  }

  /// Returns the arrays of polyhedron faces and their locations. They are null without polyhedra.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  static std::array<vtkCellArray*, 2> GetFaceArrays(vtkUnstructuredGrid* grid)
  {
    return { grid->GetPolyhedronFaces(), grid->GetPolyhedronFaceLocations() };
  }
#else
  static std::array<vtkIdTypeArray*, 2> GetFaceArrays(vtkUnstructuredGrid* grid)
  {
    return { grid->GetFaces(), grid->GetFaceLocations() };
  }
#endif

  /// Returns the latest modification time of the arrays of polyhedron faces.
  static vtkMTimeType GetFaceTime(vtkUnstructuredGrid* grid)
  {
    vtkMTimeType time = 0;
    for (vtkObject* array : GetFaceArrays(grid))
    {
      time = array ? std::max(time, array->GetMTime()) : time;
    }
    return time;
  }

  /// Returns whether the arrays of \a grid contain all faces of the polyhedron \a cell, so that
  /// vtkUnstructuredGrid::GetFaceStream does not read past their ends.
  static bool HasFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
  {
    const auto [faces, locations] = GetFaceArrays(grid);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
    if (!faces || !locations || !IsWithin(locations, cell))
    {
      return false;
    }
    vtkNew<vtkIdList> ids;
    locations->GetCellAtId(cell, ids);
    return std::all_of(ids->begin(), ids->end(),
      [points = faces](vtkIdType face) { return IsWithin(points, face); });
#else
    const vtkIdType size = faces ? faces->GetNumberOfValues() : 0;
    vtkIdType at =
      locations && cell < locations->GetNumberOfValues() ? locations->GetValue(cell) : size;
    if (at < 0 || at >= size || faces->GetValue(at) < 0)
    {
      return false;
    }
    // The stream of a cell contains its number of faces and, for each face, the number of points
    // and the point ids.
    vtkIdType left = faces->GetValue(at++);
    for (; left > 0 && at < size && faces->GetValue(at) >= 0; --left)
    {
      const vtkIdType points = faces->GetValue(at++);
      at = points <= size - at ? at + points : size + 1;
    }
    return left == 0 && at <= size;
#endif
  }

  /// Sets the cells of \a grid, all of the same type. If VTK stores a type for each cell, \a
  /// allocate(types, number) allocates the array of types, which is filled in parallel with \a
  /// grain cells per task.
  template <class Allocate>
  static void SetCellsOfOneType(vtkUnstructuredGrid* grid, unsigned char type, vtkCellArray* cells,
    vtkIdType grain, Allocate allocate)
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
    static_cast<void>(grain);
    static_cast<void>(allocate);
    grid->SetCells(type, cells);
#else
    vtkNew<vtkUnsignedCharArray> types;
    const vtkIdType number = cells->GetNumberOfCells();
    allocate(types.Get(), number);
    unsigned char* const values = types->GetPointer(0);
    vtkSMPTools::For(0, number, grain,
      [values, type](vtkIdType first, vtkIdType last)
      { std::fill(values + first, values + last, type); });
    // The overload without face arguments would search all types for polyhedra.
    grid->SetCells(types, cells, nullptr, nullptr);
#endif
  }

  /// Returns whether all \a number cells have the same type. \a number must be positive.
  static bool AreTypesEqual(const unsigned char* types, vtkIdType number)
  {
    // Comparing adjacent types vectorizes.
    return std::equal(types + 1, types + number, types);
  }

  /// Returns whether ids are stored as 32-bit integers.
  static bool IsNarrow(vtkDataArray* ids)
  {
    return NarrowIds::FastDownCast(ids) != nullptr;
  }

  /// Returns the class name of a cell type, such as vtkTetra.
  static std::string GetClassName(int type)
  {
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    return cell ? cell->GetClassName() : "cell of unknown type";
  }

private:
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  /// Returns whether \a cells contains \a cell and all ids that its offsets refer to.
  static bool IsWithin(vtkCellArray* cells, vtkIdType cell)
  {
    if (cell < 0 || cell >= cells->GetNumberOfCells())
    {
      return false;
    }
    const vtkIdType size = cells->GetCellSize(cell);
    const vtkIdType first = cells->GetOffset(cell);
    return first >= 0 && size >= 0 && size <= cells->GetNumberOfConnectivityIds() - first;
  }
#endif
};

}

#endif
