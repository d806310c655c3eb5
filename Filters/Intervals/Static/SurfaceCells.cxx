// SPDX-License-Identifier: BSD-3-Clause
#include "Static/SurfaceCells.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/Vectors.h"
#include "Grid/CellCorners.h"
#include "Static/ExtractionLinearizer.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
using Ids = std::vector<vtkIdType>;

class Converter
{
public:
  Converter(vtkDataSet* input, ExtractionIndex::LinearGrid& surface)
    : Input(input)
    , Surface(surface)
  {
    surface.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }

  void Execute()
  {
    this->Surface.Grid->Allocate(this->Input->GetNumberOfCells());
    this->SetPoints();
    int dimensions[3];
    ExtractionArrays::GetRowDimensions(this->Input, dimensions) ? this->AddRows(dimensions)
                                                                : this->AddCells();
    if (vtkUnsignedCharArray* ghosts = this->Input->GetCellGhostArray())
    {
      vtkNew<vtkUnsignedCharArray> copy;
      copy->SetName(vtkDataSetAttributes::GhostArrayName());
      for (const vtkIdType cell : this->Surface.CellIds)
      {
        copy->InsertNextValue(ghosts->GetValue(cell));
      }
      this->Surface.Grid->GetCellData()->AddArray(copy);
    }
  }

private:
  void SetPoints()
  {
    if (vtkPointSet* set = vtkPointSet::SafeDownCast(this->Input))
    {
      this->Surface.Grid->SetPoints(set->GetPoints());
    }
    else
    {
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->SetNumberOfPoints(this->Input->GetNumberOfPoints());
      for (vtkIdType p = 0; p < this->Input->GetNumberOfPoints(); ++p)
      {
        points->SetPoint(p, this->Input->GetPoint(p));
      }
      this->Surface.Grid->SetPoints(points);
    }
    this->Surface.Grid->GetPointData()->ShallowCopy(this->Input->GetPointData());
  }

  // Adds the cells of a structured grid with one flat axis. VTK reports blanked cells as empty
  // cells, so the points are computed instead of read.
  void AddRows(const int dimensions[3])
  {
    const vtkIdType columns = dimensions[0] > 1 ? dimensions[0] : dimensions[1];
    vtkIdType cell = 0;
    for (vtkIdType row = 0; row + columns < this->Input->GetNumberOfPoints(); row += columns)
    {
      for (vtkIdType p = row; p + 1 < row + columns; ++p)
      {
        this->AddQuadrilateral(cell++, { p, p + 1, p + columns + 1, p + columns });
      }
    }
  }

  void AddCells()
  {
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      const int type = this->Input->GetCellType(cell);
      const CellCorners corners = CellCorners::Of(type);
      if (corners.Kind != CellCorners::SURFACE)
      {
        this->Surface.NumberOfLowerDimensional += corners.IsLowerDimensional();
        continue;
      }
      this->Input->GetCellPoints(cell, points);
      Ids ids(points->begin(), points->end());
      if (type == VTK_TRIANGLE_STRIP)
      {
        this->AddStrip(cell, ids);
        continue;
      }
      if (type == VTK_PIXEL)
      {
        std::swap(ids[2], ids[3]);
      }
      const std::size_t number = type == VTK_QUADRATIC_POLYGON ? ids.size() / 2
        : corners.NumberOfCorners > 0                          ? corners.NumberOfCorners
                                                               : ids.size();
      this->Surface.NumberOfHigherOrder += number < ids.size();
      ids.resize(number);
      this->AddPolygon(cell, ids);
    }
  }

  void AddCell(vtkIdType cell, int type, const Ids& ids)
  {
    this->Surface.Grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    this->Surface.CellIds.push_back(cell);
  }

  void AddStrip(vtkIdType cell, const Ids& ids)
  {
    for (std::size_t i = 0; i + 2 < ids.size(); ++i)
    {
      // The triangles of a strip alternate in orientation.
      const std::size_t first = i + i % 2;
      this->AddCell(cell, VTK_TRIANGLE, { ids[first], ids[2 * i + 1 - first], ids[i + 2] });
    }
  }

  void AddPolygon(vtkIdType cell, const Ids& ids)
  {
    if (ids.size() == 3)
    {
      this->AddCell(cell, VTK_TRIANGLE, ids);
    }
    else if (ids.size() == 4)
    {
      this->AddQuadrilateral(cell, ids);
    }
    else
    {
      this->Triangulate(cell, ids);
    }
  }

  // Adds a quadrilateral with its corners in cyclic order.
  void AddQuadrilateral(vtkIdType cell, const Ids& ids)
  {
    if (this->IsConcave(ids))
    {
      this->Triangulate(cell, ids);
    }
    else
    {
      this->AddCell(cell, VTK_PIXEL, { ids[0], ids[1], ids[3], ids[2] });
    }
  }

  glm::dvec3 GetPoint(vtkIdType point) const
  {
    glm::dvec3 x;
    this->Surface.Grid->GetPoint(point, glm::value_ptr(x));
    return x;
  }

  bool IsConcave(const Ids& ids) const
  {
    glm::dvec3 x[4];
    std::transform(ids.begin(), ids.end(), x, [this](vtkIdType id) { return this->GetPoint(id); });
    const glm::dvec3 normal = glm::cross(x[2] - x[0], x[3] - x[1]);
    for (int v = 0; v < 4; ++v)
    {
      const glm::dvec3& before = x[(v + 3) % 4];
      if (glm::dot(glm::cross(x[v] - before, x[(v + 1) % 4] - x[v]), normal) < 0.0)
      {
        return true;
      }
    }
    return false;
  }

  void Triangulate(vtkIdType cell, const Ids& ids)
  {
    const vtkIdType number = static_cast<vtkIdType>(ids.size());
    vtkCell* polygon = this->Polygon;
    polygon->PointIds->SetNumberOfIds(number);
    polygon->Points->SetNumberOfPoints(number);
    bool isFinite = true;
    for (vtkIdType v = 0; v < number; ++v)
    {
      const glm::dvec3 x = this->GetPoint(ids[v]);
      isFinite = isFinite && Vectors::IsFinite(x);
      polygon->PointIds->SetId(v, ids[v]);
      polygon->Points->SetPoint(v, glm::value_ptr(x));
    }
    if (isFinite && polygon->Triangulate(0, this->Triangles, this->TrianglePoints))
    {
      for (vtkIdType at = 0; at + 2 < this->Triangles->GetNumberOfIds(); at += 3)
      {
        const vtkIdType* corners = this->Triangles->GetPointer(at);
        this->AddCell(cell, VTK_TRIANGLE, { corners, corners + 3 });
      }
      return;
    }
    this->Surface.NumberOfFolded += isFinite;
    for (std::size_t v = 1; v + 1 < ids.size(); ++v)
    {
      this->AddCell(cell, VTK_TRIANGLE, { ids[0], ids[v], ids[v + 1] });
    }
  }

  vtkDataSet* Input;
  ExtractionIndex::LinearGrid& Surface;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Triangles;
  vtkNew<vtkPoints> TrianglePoints;
};
}

SurfaceCells::Dimensions SurfaceCells::FindDimensions(vtkDataSet* input)
{
  int dimensions[3];
  if (ExtractionArrays::GetRowDimensions(input, dimensions))
  {
    const auto number = std::count_if(dimensions, dimensions + 3, [](int n) { return n > 1; });
    return { number == 3, number == 2 };
  }
  const ExtractionLinearizer::TypeSet types = ExtractionLinearizer::FindTypes(input);
  Dimensions found;
  for (int type = 0; type < 256; ++type)
  {
    const CellCorners corners = CellCorners::Of(type);
    found.HasSolids |= types[type] && !corners.IsLowerDimensional();
    found.HasSurfaces |= types[type] && corners.Kind == CellCorners::SURFACE;
  }
  return found;
}

bool SurfaceCells::IsNeeded(vtkDataSet* input)
{
  return !vtkUnstructuredGrid::SafeDownCast(input) ||
    ExtractionLinearizer::FindTypes(input).reset(VTK_TRIANGLE).any();
}

void SurfaceCells::Convert(vtkDataSet* input, ExtractionIndex::LinearGrid& surface)
{
  Converter(input, surface).Execute();
}

void SurfaceCells::Append(const Grids& parts, vtkUnstructuredGrid* output)
{
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(output->GetFieldData());
  vtkNew<vtkUnstructuredGrid> before;
  before->ShallowCopy(output);
  Grids grids{ before.GetPointer() };
  grids.insert(grids.end(), parts.begin(), parts.end());
  grids.erase(std::remove_if(grids.begin(), grids.end(),
                [](vtkUnstructuredGrid* grid) { return grid->GetNumberOfPoints() == 0; }),
    grids.end());
  if (grids.size() == 1)
  {
    output->ShallowCopy(grids[0]);
    output->SetFieldData(fields);
  }
  if (grids.size() < 2)
  {
    return;
  }
  vtkNew<vtkAppendFilter> append;
  for (vtkUnstructuredGrid* grid : grids)
  {
    append->AddInputData(grid);
  }
  append->SetOutputPointsPrecision(grids[0]->GetPoints()->GetDataType() == VTK_DOUBLE
      ? vtkAlgorithm::DOUBLE_PRECISION
      : vtkAlgorithm::SINGLE_PRECISION);
  append->Update();
  output->ShallowCopy(append->GetOutput());
  output->SetFieldData(fields);
}

void SurfaceCells::Append(const Grids& parts, const Grids& boundaries, vtkUnstructuredGrid* output,
  vtkUnstructuredGrid* boundary)
{
  Append(parts, output);
  if (boundary->GetPoints())
  {
    Append(boundaries, boundary);
    boundary->SetPoints(output->GetPoints());
    boundary->GetPointData()->ShallowCopy(output->GetPointData());
  }
}

}
