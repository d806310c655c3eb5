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
 * @brief   gives the storage of an unstructured grid's cells as arrays in memory
 *
 * The differences between VTK's versions are known here alone:
 * - types of cells: up to 9.5 always an array, vtkUnstructuredGrid::GetCellTypesArray; from 9.6 on
 *   GetCellTypes, which may be a formula, as SetCells makes it where all cells are of one type;
 * - offsets and point ids: up to 9.5 a vtkTypeInt32Array or vtkTypeInt64Array; later a
 *   vtkAOSDataArrayTemplate of either, any array, or for offsets of equal cells a formula;
 * - faces of polyhedra: up to 9.3 a stream of numbers, and where each cell's part begins; from 9.4
 *   on two vtkCellArray, the faces of cells and the points of faces.
 */
class GridCells
{
public:
  using Types = vtkAOSDataArrayTemplate<unsigned char>;
  using NarrowIds = vtkAOSDataArrayTemplate<vtkTypeInt32>;
  using WideIds = vtkAOSDataArrayTemplate<vtkTypeInt64>;

  /// Returns the array of cell types, possibly a formula; null where there are no cells.
  static vtkDataArray* GetStoredTypes(vtkUnstructuredGrid* grid)
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
    return grid->GetCellTypes();
#else
    return grid->GetCellTypesArray();
#endif
  }

  /// Returns the type of each cell: the grid's own array, or a copy where that is a formula.
  static vtkSmartPointer<Types> GetTypes(vtkUnstructuredGrid* grid)
  {
    vtkDataArray* stored = GetStoredTypes(grid);
    return stored ? ArrayViews::Get<Types>(stored) : vtkSmartPointer<Types>::New();
  }

  /// Returns the time of the last change of the faces of polyhedra.
  static vtkMTimeType GetFaceTime(vtkUnstructuredGrid* grid)
  {
    vtkMTimeType time = 0;
    for (vtkObject* array : GetFaceArrays(grid))
    {
      time = array ? std::max(time, array->GetMTime()) : time;
    }
    return time;
  }

  /// Returns true if the arrays of \a grid hold all faces of the polyhedron \a cell, so that
  /// vtkUnstructuredGrid::GetFaceStream can read them.
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
    // Each face begins with the number of its points.
    vtkIdType left = faces->GetValue(at++);
    for (; left > 0 && at < size && faces->GetValue(at) >= 0; --left)
    {
      const vtkIdType points = faces->GetValue(at++);
      at = points <= size - at ? at + points : size + 1;
    }
    return left == 0 && at <= size;
#endif
  }

  /// Gives \a grid cells of one type. Where VTK keeps a type for each cell, \a allocate(types,
  /// number) sets the size of their array, which several threads then fill, \a grain cells at a
  /// time.
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
    // Without arrays of faces VTK looks for polyhedra among all types.
    grid->SetCells(types, cells, nullptr, nullptr);
#endif
  }

  /// Returns whether all of \a number cells are of one type; there is at least one.
  static bool AreOfOneType(const unsigned char* types, vtkIdType number)
  {
    // Each is compared with the next one, which is done many at a time.
    return std::equal(types + 1, types + number, types);
  }

  /// Returns whether ids are stored in 32 bits.
  static bool IsNarrow(vtkDataArray* ids)
  {
    return NarrowIds::FastDownCast(ids) != nullptr;
  }

  /// Returns the name of the class of a type of cells, such as vtkTetra.
  static std::string GetClassName(int type)
  {
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    return cell ? cell->GetClassName() : "cell of unknown type";
  }

private:
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  using Faces = vtkCellArray;

  static std::array<Faces*, 2> GetFaceArrays(vtkUnstructuredGrid* grid)
  {
    return { grid->GetPolyhedronFaces(), grid->GetPolyhedronFaceLocations() };
  }

  /// Returns true if the ids of a cell, or face, of \a cells lie within its arrays.
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
#else
  using Faces = vtkIdTypeArray;

  static std::array<Faces*, 2> GetFaceArrays(vtkUnstructuredGrid* grid)
  {
    return { grid->GetFaces(), grid->GetFaceLocations() };
  }
#endif
};

}

#endif
