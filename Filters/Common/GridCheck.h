// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridCheck_h
#define interlume_GridCheck_h

#include "Common/ArrayCheck.h"
#include "Common/GridCells.h"
#include "Common/StoredIds.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <mutex>
#include <string>
#include <type_traits>

namespace interlume
{

/**
 * Checks that the arrays of a grid are consistent, so that no code reads past their ends. A damaged
 * file may contain inconsistent arrays. These grids fail the check:
 * - unstructured grids with point ids out of range, decreasing offsets, cells with fewer points
 *   than their type requires, or polyhedra without faces
 * - structured grids whose number of points does not match the extent
 * - rectilinear grids with fewer coordinates than the extent requires
 */
namespace GridCheck
{
/// Returns the minimum number of points of a cell type that allows different numbers, such as
/// VTK_POLYGON or VTK_LAGRANGE_WEDGE. Returns 0 for other types.
inline int GetMinimumCorners(unsigned char type)
{
  switch (type)
  {
    case VTK_POLY_VERTEX:
      return 1;
    case VTK_POLY_LINE:
    case VTK_HIGHER_ORDER_EDGE:
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return 2;
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
    case VTK_HIGHER_ORDER_TRIANGLE:
    case VTK_HIGHER_ORDER_POLYGON:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return 3;
    case VTK_HIGHER_ORDER_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
    case VTK_HIGHER_ORDER_TETRAHEDRON:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
    case VTK_CONVEX_POINT_SET:
    case VTK_POLYHEDRON:
      return 4;
    case VTK_HIGHER_ORDER_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
    case VTK_BEZIER_PYRAMID:
      return 5;
    case VTK_HIGHER_ORDER_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
    case VTK_QUADRATIC_POLYGON:
      return 6;
    case VTK_HIGHER_ORDER_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return 8;
    default:
      return 0;
  }
}

/// Returns the minimum number of points of a cell type. Each type is examined on first use, since
/// instantiating a cell of every type takes longer than checking a small grid.
inline vtkIdType GetMinimumSize(unsigned char type)
{
  // The minimum size plus one, or 0 if the type has not been examined yet.
  static std::array<std::atomic<int>, 256> known{};
  int found = known[type].load(std::memory_order_relaxed);
  if (found == 0)
  {
    const int corners = GetMinimumCorners(type);
    const bool isVariable = corners > 0 || type >= VTK_CONVEX_POINT_SET;
    const auto cell =
      vtkSmartPointer<vtkCell>::Take(isVariable ? nullptr : vtkGenericCell::InstantiateCell(type));
    found = 1 + (cell ? static_cast<int>(cell->GetNumberOfPoints()) : corners);
    known[type].store(found, std::memory_order_relaxed);
  }
  return found - 1;
}

/**
 * @class   CheckedArrays
 * @brief   remembers which cells and points passed a check
 *
 * Arrays are identified by their modification times and sizes. Filters that share a grid, and a
 * filter that executes again, check the arrays only once.
 */
class CheckedArrays
{
public:
  using Key = std::array<vtkMTimeType, 7>;

  static Key MakeKey(vtkUnstructuredGrid* grid)
  {
    vtkCellArray* cells = grid->GetCells();
    vtkDataArray* types = GridCells::GetStoredTypes(grid);
    return { cells->GetConnectivityArray()->GetMTime(), cells->GetOffsetsArray()->GetMTime(),
      types ? types->GetMTime() : 0, GridCells::GetFaceTime(grid),
      static_cast<vtkMTimeType>(grid->GetNumberOfCells()),
      static_cast<vtkMTimeType>(cells->GetNumberOfConnectivityIds()),
      static_cast<vtkMTimeType>(grid->GetNumberOfPoints()) };
  }

  static Key MakeKey(vtkPoints* points)
  {
    return { points->GetMTime(), static_cast<vtkMTimeType>(points->GetNumberOfPoints()) };
  }

  static bool Has(const Key& key)
  {
    Store& store = GetStore();
    const std::lock_guard<std::mutex> lock(store.Guard);
    return std::find(store.Keys.begin(), store.Keys.end(), key) != store.Keys.end();
  }

  static void Add(const Key& key)
  {
    Store& store = GetStore();
    const std::lock_guard<std::mutex> lock(store.Guard);
    store.Keys[store.Next++ % store.Keys.size()] = key;
  }

private:
  struct Store
  {
    std::mutex Guard;
    std::array<Key, 64> Keys{};
    std::size_t Next = 0;
  };

  static Store& GetStore()
  {
    static Store store;
    return store;
  }
};

/// Returns whether the cells in [\a first, \a last) are valid. \a all is the size of the
/// connectivity array. Sets \a hasPolyhedra if a cell is a polyhedron.
template <typename Offset, typename Id>
bool AreValid(vtkIdType first, vtkIdType last, const unsigned char* types, const Offset* offsets,
  const Id* ids, vtkIdType all, vtkIdType points, std::atomic<bool>& hasPolyhedra)
{
  using Bits = std::make_unsigned_t<Id>;
  bool isValid = offsets[first] >= 0 && offsets[last] <= all;
  int type = -1;
  std::uint64_t minimum = 0;
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    if (types[cell] != type)
    {
      type = types[cell];
      minimum = static_cast<std::uint64_t>(GetMinimumSize(types[cell]));
      if (type == VTK_POLYHEDRON)
      {
        hasPolyhedra = true;
      }
    }
    const Offset begin = offsets[cell];
    const Offset end = offsets[cell + 1];
    isValid &= (begin <= end) &
      (static_cast<std::uint64_t>(end) - static_cast<std::uint64_t>(begin) >= minimum);
  }
  if (!isValid)
  {
    return false;
  }
  // The highest bit is set in a negative id, and in the largest valid id minus an id that is too
  // large. Without branches, the loop vectorizes.
  const Bits largest =
    static_cast<Bits>(std::min(points - 1, static_cast<vtkIdType>(std::numeric_limits<Id>::max())));
  Bits bits = 0;
  for (Offset i = offsets[first]; i < offsets[last]; ++i)
  {
    const Bits id = static_cast<Bits>(ids[i]);
    bits |= id | (largest - id);
  }
  return static_cast<Id>(bits) >= 0;
}

/// Returns an error if a cell is invalid. \a all is the size of the connectivity array.
inline Error FindCellError(vtkUnstructuredGrid* grid, vtkIdType cell, const StoredIds& offsets,
  const StoredIds& ids, vtkIdType all)
{
  const int type = grid->GetCellType(cell);
  const auto describe = [&](const std::string& part) {
    return "cell " + std::to_string(cell) + " (" + GridCells::GetClassName(type) + ") has " + part;
  };
  const vtkIdType first = offsets.Get(cell);
  const vtkIdType last = offsets.Get(cell + 1);
  if (first < 0 || last < first || last > all)
  {
    return describe("the entries " + std::to_string(first) + " to " + std::to_string(last) +
      " of " + ArrayCheck::Count(all, "point id"));
  }
  const vtkIdType minimum = GetMinimumSize(static_cast<unsigned char>(type));
  if (last - first < minimum)
  {
    return describe(ArrayCheck::Count(last - first, "point") + "; " + std::to_string(minimum) +
      (minimum == 1 ? " is needed" : " are needed"));
  }
  for (vtkIdType i = first; i < last; ++i)
  {
    if (ids.Get(i) < 0 || ids.Get(i) >= grid->GetNumberOfPoints())
    {
      return describe("the point " + std::to_string(ids.Get(i)) + "; the grid has " +
        ArrayCheck::Count(grid->GetNumberOfPoints(), "point"));
    }
  }
  return {};
}

/// Returns an error if the faces of a polyhedron are invalid.
inline Error FindFaceError(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  constexpr vtkIdType minimumFaces = 4;
  const auto describe = [cell](const std::string& part)
  { return "cell " + std::to_string(cell) + " (vtkPolyhedron) has " + part; };
  if (!GridCells::HasFaces(grid, cell))
  {
    return describe("no faces in the grid's arrays of faces. Set the faces with the cells");
  }
  vtkNew<vtkIdList> stream;
  grid->GetFaceStream(cell, stream);
  const vtkIdType faces = stream->GetNumberOfIds() > 0 ? stream->GetId(0) : 0;
  if (faces < minimumFaces)
  {
    return describe(
      ArrayCheck::Count(faces, "face") + "; " + std::to_string(minimumFaces) + " are needed");
  }
  // The stream contains the number of faces and, for each face, the number of points and their ids.
  for (vtkIdType i = 1; i < stream->GetNumberOfIds(); i += stream->GetId(i) + 1)
  {
    const vtkIdType end = std::min(i + 1 + stream->GetId(i), stream->GetNumberOfIds());
    for (vtkIdType j = i + 1; j < end; ++j)
    {
      if (stream->GetId(j) < 0 || stream->GetId(j) >= grid->GetNumberOfPoints())
      {
        return describe("a face with the point " + std::to_string(stream->GetId(j)) +
          "; the grid has " + ArrayCheck::Count(grid->GetNumberOfPoints(), "point"));
      }
    }
  }
  return {};
}

/// Returns an error for the first polyhedron with invalid faces.
inline Error FindPolyhedronError(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    Error error = grid->GetCellType(cell) == VTK_POLYHEDRON ? FindFaceError(grid, cell) : Error();
    if (error)
    {
      return error;
    }
  }
  return {};
}

inline Error FindUnstructuredGridError(vtkUnstructuredGrid* grid)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells == 0)
  {
    return {};
  }
  vtkDataArray* types = GridCells::GetStoredTypes(grid);
  if (!types || types->GetNumberOfTuples() < cells)
  {
    return "the grid has " + ArrayCheck::Count(cells, "cell") + " and " +
      ArrayCheck::Count(types ? types->GetNumberOfTuples() : 0, "type");
  }
  const CheckedArrays::Key key = CheckedArrays::MakeKey(grid);
  if (CheckedArrays::Has(key))
  {
    return {};
  }
  StoredIds offsets;
  StoredIds ids;
  offsets.Build(grid->GetCells()->GetOffsetsArray());
  ids.Build(grid->GetCells()->GetConnectivityArray());
  const auto typesOfCells = GridCells::GetTypes(grid);
  const unsigned char* type = typesOfCells->GetPointer(0);
  const vtkIdType all = grid->GetCells()->GetConnectivityArray()->GetNumberOfValues();
  const vtkIdType points = grid->GetNumberOfPoints();
  std::atomic<bool> areValid(true);
  std::atomic<bool> hasPolyhedra(false);
  const auto check = [&](const auto* firstOffset, const auto* firstId)
  {
    vtkSMPTools::For(0, cells,
      [&](vtkIdType begin, vtkIdType end)
      {
        if (!AreValid(begin, end, type, firstOffset, firstId, all, points, hasPolyhedra))
        {
          areValid = false;
        }
      });
  };
  offsets.Visit([&](const auto* firstOffset)
    { ids.Visit([&](const auto* firstId) { check(firstOffset, firstId); }); });
  for (vtkIdType cell = 0; cell < cells && !areValid; ++cell)
  {
    if (Error error = FindCellError(grid, cell, offsets, ids, all))
    {
      return error;
    }
  }
  if (hasPolyhedra)
  {
    if (Error error = FindPolyhedronError(grid))
    {
      return error;
    }
  }
  CheckedArrays::Add(key);
  return {};
}

/// Returns an error if the arrays of a dataset are inconsistent. The message is a clause.
inline Error FindError(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return FindUnstructuredGridError(grid);
  }
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    int size[3];
    grid->GetDimensions(size);
    const vtkIdType needed = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
    return grid->GetNumberOfPoints() == needed
      ? Error()
      : "the grid has " + ArrayCheck::Count(grid->GetNumberOfPoints(), "point") +
        "; its extent requires " + std::to_string(needed);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    int size[3];
    grid->GetDimensions(size);
    vtkDataArray* const axes[] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType actual = axes[axis] ? axes[axis]->GetNumberOfTuples() : 0;
      if (actual < size[axis])
      {
        return "the grid has " + ArrayCheck::Count(actual, "coordinate") + " along axis " +
          std::to_string(axis) + "; its extent requires " + std::to_string(size[axis]);
      }
    }
  }
  return {};
}
}

}

#endif
