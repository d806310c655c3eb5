// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/CellRefinement.h"

#include "Cells/CellShape.h"
#include "Common/Blanking.h"
#include "Samples/BeyondSamples.h"
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
// The corners of a cell in the order of its shape; null for a cell that stays as it is.
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

  // Calls visit(face, corners) for each face.
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

  // Marks the edges of mixed cells, and returns the number of these.
  vtkIdType Mark(const ImplicitFlowArrays& arrays)
  {
    const BeyondSamples beyond(this->Grid);
    const std::vector<unsigned char> mixed = this->FindCells(
      [&](const Cell& cell)
      {
        // A flow volume cuts these at their surface.
        if (!beyond.IsEmpty() &&
          beyond.GetParts(arrays, cell.Begin(), cell.End() - cell.Begin()).IsResolved)
        {
          return false;
        }
        const auto isOther = [&](vtkIdType corner)
        { return !arrays.AreAlike(corner, *cell.Begin()); };
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
    this->FindMiddles();
    vtkNew<vtkUnstructuredGrid> cut;
    this->AddPoints(cut);
    this->AddCells(cut);
    cut->GetFieldData()->ShallowCopy(this->Grid->GetFieldData());
    return cut;
  }

private:
  // Sets 1 for each cell for which \a test says so; by threads.
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

  // Calls visit(cell, loaded cell) for the cells of FindCells, in order.
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

  // Finds which cells are cut, and the middles of quadrilaterals and cells that are needed.
  void FindMiddles()
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
        this->Centres.push_back(id);
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
  vtkIdType GetFirstCentre() const
  {
    return this->GetFirstFace() + static_cast<vtkIdType>(this->Faces.size());
  }

  // Returns the middle of a quadrilateral, -1 where it has none.
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
    const vtkIdType after = this->GetFirstCentre() + static_cast<vtkIdType>(this->Centres.size());
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
      this->AddMiddle(this->Edges.Get(edge).data(), 2, next++, cut);
    }
    for (const Face& face : this->Faces)
    {
      this->AddMiddle(face.data(), 4, next++, cut);
    }
    Cell cell;
    for (const vtkIdType id : this->Centres)
    {
      cell.Load(this->Grid, id, this->Ids);
      this->AddMiddle(cell.Begin(), cell.Shape->NumberOfCorners, next++, cut);
    }
  }

  void AddMiddle(const vtkIdType* corners, int number, vtkIdType place, vtkUnstructuredGrid* cut)
  {
    std::array<double, 8> weights{};
    weights.fill(1.0 / number);
    double middle[3] = { 0.0, 0.0, 0.0 };
    this->Ids->SetNumberOfIds(number);
    int shared = 255;
    vtkUnsignedCharArray* ghosts = this->Grid->GetPointGhostArray();
    for (int i = 0; i < number; ++i)
    {
      double x[3];
      this->Grid->GetPoint(corners[i], x);
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] += x[axis] / number;
      }
      this->Ids->SetId(i, corners[i]);
      shared &= ghosts ? ghosts->GetValue(corners[i]) : 0;
    }
    cut->GetPoints()->SetPoint(place, middle);
    cut->GetPointData()->InterpolatePoint(
      this->Grid->GetPointData(), place, this->Ids, weights.data());
    if (ghosts)
    {
      cut->GetPointGhostArray()->SetValue(place, static_cast<unsigned char>(shared));
    }
  }

  void AddCells(vtkUnstructuredGrid* cut)
  {
    cut->AllocateEstimate(this->Grid->GetNumberOfCells(), 8);
    std::vector<vtkIdType> parents;
    Cell cell;
    vtkIdType centre = this->GetFirstCentre();
    for (vtkIdType id = 0; id < this->Grid->GetNumberOfCells(); ++id)
    {
      if (!this->IsCut[static_cast<std::size_t>(id)])
      {
        this->Keep(id, cut);
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
            { this->AddFan(corners, number, centre, cut); });
          ++centre;
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

  void Keep(vtkIdType id, vtkUnstructuredGrid* cut)
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

  void Bisect(const MarkedBisection::Tetrahedron& whole, vtkUnstructuredGrid* cut) const
  {
    MarkedBisection(this->Edges, this->Before)
      .Split(whole,
        [cut](const MarkedBisection::Tetrahedron& part)
        { cut->InsertNextCell(VTK_TETRA, 4, part.data()); });
  }

  // Adds the cells between a face and the middle of its cell.
  void AddFan(Face corners, std::size_t number, vtkIdType centre, vtkUnstructuredGrid* cut) const
  {
    double x[4][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      cut->GetPoint(corners[i], x[i]);
    }
    cut->GetPoint(centre, x[3]);
    // Orders of corners differ among the kinds of cells, and among writers of files.
    if (vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]) < 0.0)
    {
      std::reverse(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(number));
    }
    if (number == 3)
    {
      this->Bisect({ { corners[0], corners[1], corners[2], centre } }, cut);
      return;
    }
    const vtkIdType middle = this->FindFace(corners);
    if (middle < 0)
    {
      const vtkIdType pyramid[5] = { corners[0], corners[1], corners[2], corners[3], centre };
      cut->InsertNextCell(VTK_PYRAMID, 5, pyramid);
      return;
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Bisect({ { corners[i], corners[(i + 1) % 4], middle, centre } }, cut);
    }
  }

  vtkUnstructuredGrid* Grid;
  vtkIdType Before;
  vtkNew<vtkIdList> Ids;
  MarkedEdges Edges;
  std::vector<unsigned char> IsCut;
  // The quadrilaterals with a middle, their corners ascending; the cells with one.
  std::vector<Face> Faces;
  std::vector<vtkIdType> Centres;
};

// Returns the type of a cell of a grid of rows, which gives hidden ones the empty type.
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
  const bool hasRows = isAligned || vtkStructuredGrid::SafeDownCast(data);
  grid->AllocateEstimate(data->GetNumberOfCells(), 8);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    const int type =
      hasRows ? GetTypeByCorners(corners->GetNumberOfIds(), isAligned) : data->GetCellType(cell);
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
