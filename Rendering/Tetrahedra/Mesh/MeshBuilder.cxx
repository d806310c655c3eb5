// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshBuilder.h"

#include "Common/ParallelFor.h"
#include "Common/ThreadLocals.h"

#include "vtkArrayDispatch.h"
#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
// Reasons to skip a tetrahedron, or DRAWN if it is not skipped.
enum Reasons : unsigned char
{
  DRAWN,
  FLAT,
  NON_FINITE,
  GHOST
};

// Calls work(first, last) in parallel for subranges of [0, number) until a call returns false.
// Returns true if all calls returned true.
template <typename Work>
bool HoldsForAll(vtkIdType number, const Work& work)
{
  constexpr vtkIdType grain = 16384;
  std::atomic<bool> holds{ true };
  vtkSMPTools::For(0, number, grain,
    [&](vtkIdType first, vtkIdType last)
    {
      if (holds && !work(first, last))
      {
        holds = false;
      }
    });
  return holds;
}

// Returns the index of the first cell that is not a tetrahedron, or -1.
vtkIdType FindNonTetrahedron(vtkUnstructuredGrid* grid)
{
  std::atomic<vtkIdType> found{ std::numeric_limits<vtkIdType>::max() };
  HoldsForAll(grid->GetNumberOfCells(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        if (grid->GetCellType(cell) != VTK_TETRA)
        {
          vtkIdType current = found;
          while (cell < current && !found.compare_exchange_weak(current, cell))
          {
          }
          break;
        }
      }
      return true;
    });
  return found == std::numeric_limits<vtkIdType>::max() ? -1 : found.load();
}

// Calls visit(cell, corners) in parallel for the cells of a grid until a call returns false.
struct CellVisit
{
  template <typename Array, typename Visit>
  void operator()(Array* connectivity, vtkIdType cells, const Visit& visit, bool& holds) const
  {
    const auto ids = vtk::DataArrayValueRange(connectivity);
    holds = HoldsForAll(cells,
      [&](vtkIdType first, vtkIdType last)
      {
        bool succeeded = true;
        for (vtkIdType cell = first; cell < last && succeeded; ++cell)
        {
          std::array<std::uint32_t, 4> corners;
          for (int k = 0; k < 4; ++k)
          {
            corners[k] = static_cast<std::uint32_t>(ids[4 * cell + k]);
          }
          succeeded = visit(cell, corners);
        }
        return succeeded;
      });
  }
};

template <typename Visit>
bool VisitCells(vtkUnstructuredGrid* grid, const Visit& visit)
{
  bool holds = true;
  const CellVisit worker;
  vtkDataArray* connectivity = grid->GetCells()->GetConnectivityArray();
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(
        connectivity, worker, grid->GetNumberOfCells(), visit, holds))
  {
    worker(connectivity, grid->GetNumberOfCells(), visit, holds);
  }
  return holds;
}

// The points of a grid. A point is valid if its coordinates and its array values are finite.
class Points
{
public:
  Points(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays)
    : Coordinates(grid->GetPoints()->GetData())
    , Arrays(arrays)
  {
  }

  vtkIdType GetNumber() const { return this->Coordinates->GetNumberOfTuples(); }

  bool Get(vtkIdType point, double* position) const
  {
    this->Coordinates->GetTuple(point, position);
    return std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]) &&
      this->Arrays.HasPoint(point);
  }

  // Sets the mesh's origin and scale so that mesh coordinates are in [-1, 1].
  void Measure(TetrahedraMesh& mesh) const
  {
    ThreadLocals<vtkBoundingBox> boxes;
    vtkSMPTools::For(0, this->GetNumber(),
      [&](vtkIdType first, vtkIdType last)
      {
        vtkBoundingBox& box = boxes.Local();
        double position[3];
        for (vtkIdType p = first; p < last; ++p)
        {
          if (this->Get(p, position))
          {
            box.AddPoint(position);
          }
        }
      });
    vtkBoundingBox all;
    for (const vtkBoundingBox& box : boxes)
    {
      all.AddBox(box);
    }
    mesh.Scale = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double low = all.IsValid() ? all.GetBound(2 * i) : 0.0;
      const double high = all.IsValid() ? all.GetBound(2 * i + 1) : 0.0;
      mesh.Origin[i] = 0.5 * low + 0.5 * high;
      mesh.Scale = std::max(mesh.Scale, high - mesh.Origin[i]);
    }
    mesh.Scale = mesh.Scale > 0.0 ? mesh.Scale : 1.0;
  }

  // Computes the mesh coordinates of a point. Returns true if the point is valid.
  bool Transform(const TetrahedraMesh& mesh, vtkIdType point, double* position) const
  {
    const bool isValid = this->Get(point, position);
    for (int i = 0; i < 3; ++i)
    {
      position[i] = isValid ? (position[i] - mesh.Origin[i]) / mesh.Scale : 0.0;
    }
    return isValid;
  }

private:
  vtkDataArray* Coordinates;
  const TetrahedraArrays& Arrays;
};

// Finds the reason to skip a cell.
class SkipReason
{
public:
  SkipReason(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, const TetrahedraMesh& mesh,
    const std::vector<unsigned char>& badPoints)
    : Arrays(arrays)
    , Mesh(mesh)
    , BadPoints(badPoints)
    , Ghosts(vtkUnsignedCharArray::SafeDownCast(
        grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())))
  {
  }

  // Returns the reason to skip a cell, or DRAWN. Does not check the points of the cell.
  Reasons GetCellReason(vtkIdType cell) const
  {
    const bool isGhost = this->Ghosts &&
      (this->Ghosts->GetValue(cell) &
        (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL));
    return isGhost ? GHOST : this->Arrays.HasCell(cell) ? DRAWN : NON_FINITE;
  }

  Reasons Get(vtkIdType cell, const std::array<std::uint32_t, 4>& corners) const
  {
    const Reasons cellReason = this->GetCellReason(cell);
    if (cellReason != DRAWN)
    {
      return cellReason;
    }
    const bool isBad = !this->BadPoints.empty() &&
      std::any_of(corners.begin(), corners.end(),
        [this](std::uint32_t id) { return this->BadPoints[id] != 0; });
    return isBad ? NON_FINITE : this->Mesh.GetVolumeTimesSix(corners.data()) == 0.0 ? FLAT : DRAWN;
  }

private:
  const TetrahedraArrays& Arrays;
  const TetrahedraMesh& Mesh;
  const std::vector<unsigned char>& BadPoints;
  vtkUnsignedCharArray* Ghosts;
};

// Frees the marks if all of them are 0.
void ClearIfAllZero(std::vector<unsigned char>& marks)
{
  if (std::find_if(marks.begin(), marks.end(), [](unsigned char mark) { return mark != 0; }) ==
    marks.end())
  {
    std::vector<unsigned char>().swap(marks);
  }
}
}

Error MeshBuilder::Build(
  vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, TetrahedraMesh& mesh)
{
  *this = MeshBuilder();
  mesh = TetrahedraMesh();
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells == 0 || !grid->GetPoints())
  {
    return {};
  }
  const vtkIdType invalidCell = FindNonTetrahedron(grid);
  if (invalidCell >= 0)
  {
    const auto type = vtkSmartPointer<vtkCell>::Take(
      vtkGenericCell::InstantiateCell(grid->GetCellType(invalidCell)));
    return "cell " + std::to_string(invalidCell) + " is a " +
      (type ? type->GetClassName() : "cell of unknown type") +
      ", but only tetrahedra can be drawn; convert the cells to tetrahedra with "
      "vtkDataSetTriangleFilter, vtkIntervalVolume without KeepInteriorCells and SurfaceCells, "
      "or vtkTetrahedralMesher";
  }
  if (std::max(cells, grid->GetNumberOfPoints()) >= std::numeric_limits<std::uint32_t>::max())
  {
    return "the grid has more than 4294967294 points or cells, which 32-bit indices cannot "
           "address; draw it "
           "in pieces";
  }

  const Points points(grid, arrays);
  points.Measure(mesh);
  mesh.Points.resize(3 * static_cast<std::size_t>(points.GetNumber()));
  this->BadPoints.resize(points.GetNumber());
  ParallelFor(0, points.GetNumber(),
    [&](vtkIdType p) { this->BadPoints[p] = !points.Transform(mesh, p, &mesh.Points[3 * p]); });
  ClearIfAllZero(this->BadPoints);

  mesh.Corners.resize(4 * static_cast<std::size_t>(cells));
  this->Marks.resize(cells);
  const SkipReason reason(grid, arrays, mesh, this->BadPoints);
  VisitCells(grid,
    [&](vtkIdType cell, const std::array<std::uint32_t, 4>& corners)
    {
      std::copy(corners.begin(), corners.end(), &mesh.Corners[4 * cell]);
      this->Marks[cell] = reason.Get(cell, corners);
      return true;
    });
  ClearIfAllZero(this->Marks);
  if (!this->Marks.empty())
  {
    this->RemoveSkipped(mesh);
  }
  return {};
}

void MeshBuilder::RemoveSkipped(TetrahedraMesh& mesh)
{
  this->Flat = std::count(this->Marks.begin(), this->Marks.end(), FLAT);
  this->NonFinite = std::count(this->Marks.begin(), this->Marks.end(), NON_FINITE);
  const auto drawn =
    static_cast<std::size_t>(std::count(this->Marks.begin(), this->Marks.end(), DRAWN));
  std::vector<std::uint32_t> retained;
  retained.reserve(4 * drawn);
  mesh.Cells.reserve(drawn);
  for (std::size_t cell = 0; cell < this->Marks.size(); ++cell)
  {
    if (this->Marks[cell] == DRAWN)
    {
      const std::uint32_t* corners = mesh.GetCorners(static_cast<std::uint32_t>(cell));
      retained.insert(retained.end(), corners, corners + 4);
      mesh.Cells.push_back(static_cast<std::uint32_t>(cell));
    }
  }
  mesh.Corners = std::move(retained);
}

bool MeshBuilder::IsSame(
  vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, const TetrahedraMesh& mesh) const
{
  const auto cells =
    static_cast<vtkIdType>(this->Marks.empty() ? mesh.GetNumberOfTetrahedra() : this->Marks.size());
  if (cells == 0 || grid->GetNumberOfCells() != cells || !grid->GetPoints() ||
    3 * static_cast<std::size_t>(grid->GetNumberOfPoints()) != mesh.Points.size() ||
    FindNonTetrahedron(grid) >= 0)
  {
    return false;
  }
  const Points points(grid, arrays);
  TetrahedraMesh measured;
  points.Measure(measured);
  const bool hasSamePoints = measured.Origin == mesh.Origin && measured.Scale == mesh.Scale &&
    HoldsForAll(points.GetNumber(),
      [&](vtkIdType first, vtkIdType last)
      {
        bool succeeded = true;
        std::array<double, 3> position;
        for (vtkIdType p = first; p < last && succeeded; ++p)
        {
          const bool isBad = !points.Transform(mesh, p, position.data());
          succeeded = isBad == (!this->BadPoints.empty() && this->BadPoints[p] != 0) &&
            std::equal(
              position.begin(), position.end(), mesh.GetPoint(static_cast<std::uint32_t>(p)));
        }
        return succeeded;
      });
  if (!hasSamePoints)
  {
    return false;
  }
  const SkipReason reason(grid, arrays, mesh, this->BadPoints);
  return VisitCells(grid,
    [&](vtkIdType cell, const std::array<std::uint32_t, 4>& corners)
    {
      auto tetrahedron = static_cast<std::size_t>(cell);
      if (!this->Marks.empty())
      {
        if (this->Marks[cell] != DRAWN)
        {
          return this->Marks[cell] == reason.Get(cell, corners);
        }
        tetrahedron =
          std::lower_bound(mesh.Cells.begin(), mesh.Cells.end(), cell) - mesh.Cells.begin();
      }
      return reason.GetCellReason(cell) == DRAWN &&
        std::equal(corners.begin(), corners.end(), &mesh.Corners[4 * tetrahedron]);
    });
}

}
