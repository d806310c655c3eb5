// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Drawing/ImageCases.h"

#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference
{

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> WithField(vtkSmartPointer<vtkUnstructuredGrid> grid)
{
  AddLinearArray(grid, "f", 0.1, { { 0.5, 0.3, 0.1 } });
  grid->GetPointData()->SetActiveScalars("f");
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> UnitMesh(MeshKind kind, const std::array<int, 3>& cells)
{
  auto grid = MakeMesh(kind, cells);
  MovePoints(
    grid, { { 0.0, 0.0, 0.0 } }, 1.0, { { 1.0 / cells[0], 1.0 / cells[1], 1.0 / cells[2] } });
  return WithField(grid);
}

}

vtkSmartPointer<vtkUnstructuredGrid> MakeCube(int cells)
{
  return UnitMesh(MeshKind::Tetrahedra5, { { cells, cells, cells } });
}

vtkSmartPointer<vtkUnstructuredGrid> MakeBox(const std::array<int, 3>& cells)
{
  return UnitMesh(MeshKind::Tetrahedra6, cells);
}

vtkSmartPointer<vtkUnstructuredGrid> MakeLayers(int cells, const std::vector<double>& z)
{
  const int layers = static_cast<int>(z.size()) - 1;
  auto grid = MakeMesh(MeshKind::Tetrahedra5, { { cells, cells, layers } });
  MovePoints(grid, { { 0.0, 0.0, 0.0 } }, 1.0, { { 1.0 / cells, 1.0 / cells, 1.0 } });
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double x[3];
    grid->GetPoint(id, x);
    x[2] = z[static_cast<std::size_t>(std::lround(x[2]))];
    grid->GetPoints()->SetPoint(id, x);
  }
  grid->GetPoints()->Modified();
  return WithField(grid);
}

void MovePoints(
  vtkUnstructuredGrid* grid, const Point3& origin, double scale, const Point3& stretch)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double x[3];
    grid->GetPoint(id, x);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = origin[axis] + scale * stretch[axis] * x[axis];
    }
    points->SetPoint(id, x);
  }
  grid->SetPoints(points);
}

void AddLinearArray(
  vtkUnstructuredGrid* grid, const std::string& name, double constant, const Point3& gradient)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name.c_str());
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double x[3];
    grid->GetPoint(id, x);
    values->InsertNextValue(constant + vtkMath::Dot(gradient.data(), x));
  }
  grid->GetPointData()->AddArray(values);
}

void AddSlabIndices(vtkUnstructuredGrid* grid, const std::string& name, int axis, int slabs)
{
  const double* bounds = grid->GetBounds();
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(name.c_str());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double box[6];
    grid->GetCellBounds(cell, box);
    const double midpoint = 0.5 * (box[2 * axis] + box[2 * axis + 1]);
    const double fraction =
      (midpoint - bounds[2 * axis]) / (bounds[2 * axis + 1] - bounds[2 * axis]);
    numbers->InsertNextValue(std::min(static_cast<int>(fraction * slabs), slabs - 1));
  }
  grid->GetCellData()->AddArray(numbers);
}

double GetChordLength(vtkUnstructuredGrid* grid, const Ray& ray)
{
  const double* bounds = grid->GetBounds();
  Real entry = 0;
  Real exit = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const Real a = (bounds[2 * axis] - ray.Origin[axis]) / ray.Direction[axis];
    const Real b = (bounds[2 * axis + 1] - ray.Origin[axis]) / ray.Direction[axis];
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return static_cast<double>(std::max(exit - entry, Real(0)));
}

}
