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
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <mutex>
#include <string>

namespace interlume
{

/**
 * Says where the arrays that a grid is made of contradict each other, as those of a damaged file
 * do, before anyone follows them beyond their ends: cells that name points which are not there,
 * that have fewer points than their type, or whose offsets decrease; fewer points or coordinates
 * than the extent has. The lengths of the streams of polyhedral faces are taken as they are.
 */
namespace GridCheck
{
/// Returns the least number of points that a cell of each type has.
inline const std::array<vtkIdType, 256>& GetLeastSizes()
{
  static const std::array<vtkIdType, 256> sizes = []()
  {
    std::array<vtkIdType, 256> found{};
    for (int type = VTK_VERTEX; type < VTK_CONVEX_POINT_SET; ++type)
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      const bool isAnySize = type == VTK_POLY_VERTEX || type == VTK_POLY_LINE ||
        type == VTK_TRIANGLE_STRIP || type == VTK_POLYGON;
      found[static_cast<std::size_t>(type)] = cell && !isAnySize ? cell->GetNumberOfPoints() : 0;
    }
    return found;
  }();
  return sizes;
}

/**
 * @class   CheckedCells
 * @brief   remembers the cells that were found whole, by when their arrays were modified, so that
 *          filters of one grid, and one filter that executes again, look through them once
 */
class CheckedCells
{
public:
  using Key = std::array<vtkMTimeType, 6>;

  static Key MakeKey(vtkUnstructuredGrid* grid)
  {
    vtkCellArray* cells = grid->GetCells();
    vtkDataArray* types = GridCells::GetStoredTypes(grid);
    return { cells->GetConnectivityArray()->GetMTime(), cells->GetOffsetsArray()->GetMTime(),
      types ? types->GetMTime() : 0, static_cast<vtkMTimeType>(grid->GetNumberOfCells()),
      static_cast<vtkMTimeType>(cells->GetNumberOfConnectivityIds()),
      static_cast<vtkMTimeType>(grid->GetNumberOfPoints()) };
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

/// Returns what is wrong with a cell, or nothing. \a last is that of the connectivity array.
inline std::string DescribeCell(vtkUnstructuredGrid* grid, vtkIdType cell, const StoredIds& offsets,
  const StoredIds& ids, vtkIdType all)
{
  const int type = grid->GetCellType(cell);
  const std::string what =
    "cell " + std::to_string(cell) + " (" + GridCells::GetClassName(type) + ") ";
  const vtkIdType first = offsets.Get(cell);
  const vtkIdType last = offsets.Get(cell + 1);
  if (first < 0 || last < first || last > all)
  {
    return what + "has the entries " + std::to_string(first) + " to " + std::to_string(last) +
      " of " + ArrayCheck::Count(all, "point id");
  }
  const vtkIdType least = GetLeastSizes()[static_cast<std::size_t>(type)];
  if (last - first < least)
  {
    return what + "has " + ArrayCheck::Count(last - first, "point") + "; " + std::to_string(least) +
      " are needed";
  }
  for (vtkIdType i = first; i < last; ++i)
  {
    if (ids.Get(i) < 0 || ids.Get(i) >= grid->GetNumberOfPoints())
    {
      return what + "has the point " + std::to_string(ids.Get(i)) + "; the grid has " +
        ArrayCheck::Count(grid->GetNumberOfPoints(), "point");
    }
  }
  return {};
}

/// Returns the first polyhedron that has a face with a point which is not there, and what it is.
inline std::string FindPolyhedronFault(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkIdList> stream;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != VTK_POLYHEDRON)
    {
      continue;
    }
    grid->GetFaceStream(cell, stream);
    // After the number of faces each begins with the number of its points.
    for (vtkIdType i = 1; i < stream->GetNumberOfIds(); i += stream->GetId(i) + 1)
    {
      const vtkIdType end = std::min(i + 1 + stream->GetId(i), stream->GetNumberOfIds());
      for (vtkIdType j = i + 1; j < end; ++j)
      {
        if (stream->GetId(j) < 0 || stream->GetId(j) >= grid->GetNumberOfPoints())
        {
          return "cell " + std::to_string(cell) + " (vtkPolyhedron) has a face with the point " +
            std::to_string(stream->GetId(j)) + "; the grid has " +
            ArrayCheck::Count(grid->GetNumberOfPoints(), "point");
        }
      }
    }
  }
  return {};
}

inline std::string FindUnstructuredFault(vtkUnstructuredGrid* grid)
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
  const CheckedCells::Key key = CheckedCells::MakeKey(grid);
  if (CheckedCells::Has(key))
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
  const std::array<vtkIdType, 256>& least = GetLeastSizes();
  std::atomic<vtkIdType> firstWrong(cells);
  std::atomic<bool> hasPolyhedra(false);
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end && cell < firstWrong; ++cell)
      {
        const vtkIdType first = offsets.Get(cell);
        const vtkIdType last = offsets.Get(cell + 1);
        bool isRight = first >= 0 && last <= all && last - first >= least[type[cell]];
        for (vtkIdType i = first; isRight && i < last; ++i)
        {
          isRight = ids.Get(i) >= 0 && ids.Get(i) < points;
        }
        if (!isRight)
        {
          vtkIdType before = firstWrong;
          while (cell < before && !firstWrong.compare_exchange_weak(before, cell))
          {
          }
        }
        if (type[cell] == VTK_POLYHEDRON)
        {
          hasPolyhedra = true;
        }
      }
    });
  std::string fault;
  if (firstWrong < cells)
  {
    fault = DescribeCell(grid, firstWrong, offsets, ids, all);
  }
  else if (hasPolyhedra)
  {
    fault = FindPolyhedronFault(grid);
  }
  if (fault.empty())
  {
    CheckedCells::Add(key);
  }
  return fault;
}

/// Returns what is wrong, a part of a sentence, or nothing.
inline std::string Find(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return FindUnstructuredFault(grid);
  }
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    int size[3];
    grid->GetDimensions(size);
    const vtkIdType needed = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
    return grid->GetNumberOfPoints() == needed
      ? std::string()
      : "the grid has " + ArrayCheck::Count(grid->GetNumberOfPoints(), "point") +
        "; its extent has " + std::to_string(needed);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    int size[3];
    grid->GetDimensions(size);
    vtkDataArray* const axes[] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType has = axes[axis] ? axes[axis]->GetNumberOfTuples() : 0;
      if (has < size[axis])
      {
        return "the grid has " + ArrayCheck::Count(has, "coordinate") + " along axis " +
          std::to_string(axis) + "; its extent has " + std::to_string(size[axis]);
      }
    }
  }
  return {};
}
}

}

#endif
