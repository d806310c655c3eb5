// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/CellRefinement.h"

#include "Cells/CellShape.h"
#include "Common/Blanking.h"
#include "Samples/FarSideSamples.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Samples/MarkedBisection.h"
#include "Samples/MarkedEdges.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace interlume
{

namespace
{
// A cell's corners in the order of its CellShape, which is null if the cell remains unchanged.
struct Cell
{
  const CellShape* Shape = nullptr;
  std::array<vtkIdType, 8> Corners{};

  void Load(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* ids)
  {
    const int type = grid->GetCellType(cell);
    this->Shape = GetShape(type);
    if (!this->Shape)
    {
      return;
    }
    grid->GetCellPoints(cell, ids);
    std::copy_n(ids->GetPointer(0), this->Shape->NumberOfCorners, this->Corners.begin());
    if (type == VTK_HEXAHEDRON)
    {
      std::swap(this->Corners[2], this->Corners[3]);
      std::swap(this->Corners[6], this->Corners[7]);
    }
  }

  bool IsTetrahedron() const { return this->Shape->Kind == CellShape::TETRAHEDRON; }

  const vtkIdType* Begin() const { return this->Corners.data(); }
  const vtkIdType* End() const { return this->Corners.data() + this->Shape->NumberOfCorners; }

  // Calls visit(corners, number of corners) for each face.
  template <typename Visit>
  void ForEachFace(Visit&& visit) const
  {
    for (int f = 0; f < this->Shape->NumberOfFaces; ++f)
    {
      const CellShape::Face& face = this->Shape->Faces[f];
      std::array<vtkIdType, 4> corners{};
      for (int i = 0; i < face.NumberOfCorners; ++i)
      {
        corners[static_cast<std::size_t>(i)] =
          this->Corners[static_cast<std::size_t>(face.Corners[i])];
      }
      visit(corners, static_cast<std::size_t>(face.NumberOfCorners));
    }
  }

private:
  static const CellShape* GetShape(int type)
  {
    switch (type)
    {
      case VTK_TETRA:
        return &CellShape::Of(CellShape::TETRAHEDRON);
      case VTK_VOXEL:
      case VTK_HEXAHEDRON:
        return &CellShape::Of(CellShape::HEXAHEDRON);
      case VTK_WEDGE:
        return &CellShape::Of(CellShape::WEDGE);
      case VTK_PYRAMID:
        return &CellShape::Of(CellShape::PYRAMID);
      default:
        return nullptr;
    }
  }
};

using Face = std::array<vtkIdType, 4>;

class Refiner
{
public:
  explicit Refiner(vtkUnstructuredGrid* grid)
    : Grid(grid)
    , Before(grid->GetNumberOfPoints())
  {
  }

  // Marks the edges of mixed cells. Returns the number of mixed cells.
  vtkIdType Mark(const ImplicitFlowArrays& arrays)
  {
    const FarSideSamples farSide(this->Grid);
    const std::vector<unsigned char> mixed = this->FindCells(
      [&](const Cell& cell)
      {
        // vtkFlowVolume cuts these cells at the surface, so they need no refinement.
        if (!farSide.IsEmpty() &&
          farSide.GetParts(arrays, cell.Begin(), cell.End() - cell.Begin()).IsResolved)
        {
          return false;
        }
        const auto isOther = [&](vtkIdType corner)
        { return !arrays.HaveSameEnd(corner, *cell.Begin()); };
        return std::any_of(cell.Begin(), cell.End(), isOther) ||
          (arrays.IsReached(*cell.Begin()) && arrays.HasSides() &&
            arrays.IsAcrossSurface(cell.Begin(), cell.End() - cell.Begin()));
      });
    std::vector<MarkedEdges::Edge> edges;
    this->ForEachCell(mixed,
      [&](vtkIdType, const Cell& cell)
      {
        cell.ForEachFace(
          [&](const Face& corners, std::size_t number)
          {
            for (std::size_t i = 0; i < number; ++i)
            {
              edges.push_back(MarkedEdges::Make(corners[i], corners[(i + 1) % number]));
            }
          });
      });
    this->Edges.Build(std::move(edges), this->Grid->GetPoints());
    return std::count(mixed.begin(), mixed.end(), 1);
  }

  vtkSmartPointer<vtkUnstructuredGrid> Cut()
  {
    this->FindCenters();
    vtkNew<vtkUnstructuredGrid> cut;
    this->AddPoints(cut);
    this->AddCells(cut);
    cut->GetFieldData()->ShallowCopy(this->Grid->GetFieldData());
    return cut;
  }

private:
  // Returns an array that contains 1 for each cell that satisfies \a test. Threads may call \a test
  // concurrently.
  template <typename Test>
  std::vector<unsigned char> FindCells(const Test& test) const
  {
    Blanking blanking;
    blanking.SetBlanking(this->Grid);
    std::vector<unsigned char> found(static_cast<std::size_t>(this->Grid->GetNumberOfCells()), 0);
    vtkSMPThreadLocalObject<vtkIdList> lists;
    vtkSMPTools::For(0, this->Grid->GetNumberOfCells(),
      [&](vtkIdType first, vtkIdType last)
      {
        Cell cell;
        for (vtkIdType id = first; id < last; ++id)
        {
          cell.Load(this->Grid, id, lists.Local());
          const auto isHidden = [&](vtkIdType corner) { return blanking.IsPointBlanked(corner); };
          found[static_cast<std::size_t>(id)] = cell.Shape && !blanking.IsCellHidden(id) &&
            std::none_of(cell.Begin(), cell.End(), isHidden) && test(cell);
        }
      });
    return found;
  }

  // Loads each cell that FindCells has marked and calls visit(id, cell), in ascending order of ids.
  template <typename Visit>
  void ForEachCell(const std::vector<unsigned char>& found, Visit&& visit)
  {
    Cell cell;
    for (std::size_t id = 0; id < found.size(); ++id)
    {
      if (found[id])
      {
        cell.Load(this->Grid, static_cast<vtkIdType>(id), this->Ids);
        visit(static_cast<vtkIdType>(id), cell);
      }
    }
  }

  bool HasMarkedEdge(const Face& corners, std::size_t number) const
  {
    for (std::size_t i = 0; i < number; ++i)
    {
      if (this->Edges.Find(corners[i], corners[(i + 1) % number]) >= 0)
      {
        return true;
      }
    }
    return false;
  }

  // Finds the cells to cut, and the quadrilaterals and cells that need a new point at their center.
  void FindCenters()
  {
    std::vector<unsigned char> isEnd(static_cast<std::size_t>(this->Before), 0);
    for (vtkIdType edge = 0; edge < this->Edges.GetNumber(); ++edge)
    {
      for (const vtkIdType end : this->Edges.Get(edge))
      {
        isEnd[static_cast<std::size_t>(end)] = 1;
      }
    }
    this->IsCut = this->FindCells(
      [&](const Cell& cell)
      {
        const auto isMarked = [&](vtkIdType p) { return isEnd[static_cast<std::size_t>(p)] != 0; };
        bool isCut = false;
        if (std::count_if(cell.Begin(), cell.End(), isMarked) > 1)
        {
          cell.ForEachFace([&](const Face& corners, std::size_t number)
            { isCut = isCut || this->HasMarkedEdge(corners, number); });
        }
        return isCut;
      });
    this->ForEachCell(this->IsCut,
      [&](vtkIdType id, const Cell& cell)
      {
        if (cell.IsTetrahedron())
        {
          return;
        }
        this->Centers.push_back(id);
        cell.ForEachFace(
          [&](Face corners, std::size_t number)
          {
            if (number == 4 && this->HasMarkedEdge(corners, number))
            {
              std::sort(corners.begin(), corners.end());
              this->Faces.push_back(corners);
            }
          });
      });
    std::sort(this->Faces.begin(), this->Faces.end());
    this->Faces.erase(std::unique(this->Faces.begin(), this->Faces.end()), this->Faces.end());
  }

  vtkIdType GetFirstFace() const { return this->Before + this->Edges.GetNumber(); }
  vtkIdType GetFirstCenter() const
  {
    return this->GetFirstFace() + static_cast<vtkIdType>(this->Faces.size());
  }

  // Returns the id of the new point at the center of a quadrilateral, or -1 if there is none.
  vtkIdType FindFace(Face corners) const
  {
    std::sort(corners.begin(), corners.end());
    const auto found = std::lower_bound(this->Faces.begin(), this->Faces.end(), corners);
    return found != this->Faces.end() && *found == corners
      ? this->GetFirstFace() + (found - this->Faces.begin())
      : -1;
  }

  void AddPoints(vtkUnstructuredGrid* cut)
  {
    const vtkIdType after = this->GetFirstCenter() + static_cast<vtkIdType>(this->Centers.size());
    vtkNew<vtkPoints> points;
    points->SetDataType(this->Grid->GetPoints()->GetDataType());
    points->SetNumberOfPoints(after);
    points->GetData()->InsertTuples(0, this->Before, 0, this->Grid->GetPoints()->GetData());
    cut->SetPoints(points);
    vtkPointData* data = cut->GetPointData();
    data->InterpolateAllocate(this->Grid->GetPointData(), after);
    data->CopyData(this->Grid->GetPointData(), 0, this->Before, 0);
    vtkIdType next = this->Before;
    for (vtkIdType edge = 0; edge < this->Edges.GetNumber(); ++edge)
    {
      this->AddMidpoint(this->Edges.Get(edge).data(), 2, next++, cut);
    }
    for (const Face& face : this->Faces)
    {
      this->AddMidpoint(face.data(), 4, next++, cut);
    }
    Cell cell;
    for (const vtkIdType id : this->Centers)
    {
      cell.Load(this->Grid, id, this->Ids);
      this->AddMidpoint(cell.Begin(), cell.Shape->NumberOfCorners, next++, cut);
    }
  }

  void AddMidpoint(const vtkIdType* corners, int number, vtkIdType index, vtkUnstructuredGrid* cut)
  {
    std::array<double, 8> weights{};
    weights.fill(1.0 / number);
    double midpoint[3] = { 0.0, 0.0, 0.0 };
    this->Ids->SetNumberOfIds(number);
    int commonGhosts = 255;
    vtkUnsignedCharArray* ghosts = this->Grid->GetPointGhostArray();
    for (int i = 0; i < number; ++i)
    {
      double x[3];
      this->Grid->GetPoint(corners[i], x);
      for (int axis = 0; axis < 3; ++axis)
      {
        midpoint[axis] += x[axis] / number;
      }
      this->Ids->SetId(i, corners[i]);
      commonGhosts &= ghosts ? ghosts->GetValue(corners[i]) : 0;
    }
    cut->GetPoints()->SetPoint(index, midpoint);
    cut->GetPointData()->InterpolatePoint(
      this->Grid->GetPointData(), index, this->Ids, weights.data());
    if (ghosts)
    {
      cut->GetPointGhostArray()->SetValue(index, static_cast<unsigned char>(commonGhosts));
    }
  }

  void AddCells(vtkUnstructuredGrid* cut)
  {
    cut->AllocateEstimate(this->Grid->GetNumberOfCells(), 8);
    std::vector<vtkIdType> parents;
    Cell cell;
    vtkIdType center = this->GetFirstCenter();
    for (vtkIdType id = 0; id < this->Grid->GetNumberOfCells(); ++id)
    {
      if (!this->IsCut[static_cast<std::size_t>(id)])
      {
        this->CopyCell(id, cut);
      }
      else
      {
        cell.Load(this->Grid, id, this->Ids);
        if (cell.IsTetrahedron())
        {
          this->Bisect(
            { { cell.Corners[0], cell.Corners[1], cell.Corners[2], cell.Corners[3] } }, cut);
        }
        else
        {
          cell.ForEachFace([&](const Face& corners, std::size_t number)
            { this->AddFan(corners, number, center, cut); });
          ++center;
        }
      }
      parents.resize(static_cast<std::size_t>(cut->GetNumberOfCells()), id);
    }
    vtkNew<vtkIdList> from;
    vtkNew<vtkIdList> to;
    from->SetNumberOfIds(static_cast<vtkIdType>(parents.size()));
    std::copy(parents.begin(), parents.end(), from->begin());
    to->SetNumberOfIds(from->GetNumberOfIds());
    std::iota(to->begin(), to->end(), 0);
    cut->GetCellData()->CopyAllocate(this->Grid->GetCellData(), from->GetNumberOfIds());
    cut->GetCellData()->CopyData(this->Grid->GetCellData(), from, to);
  }

  void CopyCell(vtkIdType id, vtkUnstructuredGrid* cut)
  {
    const int type = this->Grid->GetCellType(id);
    if (type == VTK_POLYHEDRON)
    {
      this->Grid->GetFaceStream(id, this->Ids);
    }
    else
    {
      this->Grid->GetCellPoints(id, this->Ids);
    }
    cut->InsertNextCell(type, this->Ids);
  }

  void Bisect(const MarkedBisection::Tetrahedron& tetrahedron, vtkUnstructuredGrid* cut) const
  {
    MarkedBisection(this->Edges, this->Before)
      .Split(tetrahedron,
        [cut](const MarkedBisection::Tetrahedron& piece)
        { cut->InsertNextCell(VTK_TETRA, 4, piece.data()); });
  }

  // Adds the cells between a face and the point \a center of its cell.
  void AddFan(Face corners, std::size_t number, vtkIdType center, vtkUnstructuredGrid* cut) const
  {
    double x[4][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      cut->GetPoint(corners[i], x[i]);
    }
    cut->GetPoint(center, x[3]);
    // The orientation of a cell depends on its type and on the program that wrote the file.
    if (vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]) < 0.0)
    {
      std::reverse(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(number));
    }
    if (number == 3)
    {
      this->Bisect({ { corners[0], corners[1], corners[2], center } }, cut);
      return;
    }
    const vtkIdType midpoint = this->FindFace(corners);
    if (midpoint < 0)
    {
      const vtkIdType pyramid[5] = { corners[0], corners[1], corners[2], corners[3], center };
      cut->InsertNextCell(VTK_PYRAMID, 5, pyramid);
      return;
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Bisect({ { corners[i], corners[(i + 1) % 4], midpoint, center } }, cut);
    }
  }

  vtkUnstructuredGrid* Grid;
  vtkIdType Before;
  vtkNew<vtkIdList> Ids;
  MarkedEdges Edges;
  std::vector<unsigned char> IsCut;
  // Corners, in ascending order, of each quadrilateral with a new point at its center.
  std::vector<Face> Faces;
  // Ids of the cells with a new point at their center.
  std::vector<vtkIdType> Centers;
};

// Returns the type of a structured grid's cell from its number of corners, because VTK returns
// VTK_EMPTY_CELL for hidden cells.
int GetTypeByCorners(vtkIdType corners, bool isAligned)
{
  switch (corners)
  {
    case 8:
      return isAligned ? VTK_VOXEL : VTK_HEXAHEDRON;
    case 4:
      return isAligned ? VTK_PIXEL : VTK_QUAD;
    case 2:
      return VTK_LINE;
    default:
      return VTK_VERTEX;
  }
}
}

vtkSmartPointer<vtkUnstructuredGrid> CellRefinement::MakeGrid(vtkDataSet* data)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (vtkUnstructuredGrid::SafeDownCast(data))
  {
    grid->ShallowCopy(data);
    return grid;
  }
  vtkNew<vtkPoints> points;
  if (auto* set = vtkPointSet::SafeDownCast(data))
  {
    points->ShallowCopy(set->GetPoints());
  }
  else
  {
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(data->GetNumberOfPoints());
    for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
    {
      points->SetPoint(id, data->GetPoint(id));
    }
  }
  grid->SetPoints(points);
  const bool isAligned = vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data);
  const bool isStructured = isAligned || vtkStructuredGrid::SafeDownCast(data);
  grid->AllocateEstimate(data->GetNumberOfCells(), 8);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    const int type = isStructured ? GetTypeByCorners(corners->GetNumberOfIds(), isAligned)
                                  : data->GetCellType(cell);
    grid->InsertNextCell(type, corners);
  }
  grid->GetPointData()->ShallowCopy(data->GetPointData());
  grid->GetCellData()->ShallowCopy(data->GetCellData());
  grid->GetFieldData()->ShallowCopy(data->GetFieldData());
  return grid;
}

CellRefinement::Result CellRefinement::Refine(vtkUnstructuredGrid* grid)
{
  Result result;
  ImplicitFlowArrays arrays;
  if (arrays.Find(grid))
  {
    return result;
  }
  Refiner refiner(grid);
  result.MixedCells = refiner.Mark(arrays);
  result.Grid = result.MixedCells > 0 ? refiner.Cut() : vtkSmartPointer<vtkUnstructuredGrid>(grid);
  return result;
}

}
