// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceSkin.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

namespace reference
{

vtkSmartPointer<vtkPolyData> MakeSkin(
  vtkDataSet* grid, const std::function<bool(const Vector& center)>& isWanted, int type)
{
  // Maps the sorted point ids of a face to the ids in the cell's order and the number of cells that
  // share the face.
  using Ids = std::vector<vtkIdType>;
  std::map<Ids, std::pair<Ids, int>> faces;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    vtkCell* cell = grid->GetCell(id);
    for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
    {
      vtkIdList* points = cell->GetFace(i)->GetPointIds();
      Ids own(points->begin(), points->end());
      Ids sorted = own;
      std::sort(sorted.begin(), sorted.end());
      auto& faceAndCount = faces[sorted];
      faceAndCount.first = own;
      ++faceAndCount.second;
    }
  }
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  vtkNew<vtkDoubleArray> texture;
  texture->SetNumberOfComponents(2);
  texture->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    points->SetPoint(id, grid->GetPoint(id));
    texture->SetTuple2(id, 0.25, 0.75);
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& face : faces)
  {
    const Ids& ids = face.second.first;
    Vector center{};
    for (const vtkIdType id : ids)
    {
      Vector x;
      grid->GetPoint(id, x.data());
      center += (1.0 / static_cast<double>(ids.size())) * x;
    }
    if (face.second.second == 1 && isWanted(center))
    {
      polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  boundary->SetPoints(points);
  boundary->SetPolys(polygons);
  boundary->GetPointData()->SetTCoords(texture);
  return boundary;
}

}
