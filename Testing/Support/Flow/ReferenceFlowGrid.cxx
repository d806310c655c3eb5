// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkTerminationPlane.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reference
{

namespace
{

constexpr double Pi = 3.14159265358979324;

constexpr double LinearRows[3][4] = { { 0.3, -0.7, 0.45, 0.2 }, { 0.9, 0.15, -0.35, -0.6 },
  { -0.25, 0.55, 0.8, 0.4 } };

}

Vector GetLinearVector(const Vector& x)
{
  Vector v{};
  for (int i = 0; i < 3; ++i)
  {
    const double* row = LinearRows[i];
    v[i] = row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
  }
  return v;
}

std::array<double, 9> GetLinearGradient()
{
  std::array<double, 9> gradient{};
  for (int i = 0; i < 9; ++i)
  {
    gradient[i] = LinearRows[i / 3][i % 3];
  }
  return gradient;
}

vtkSmartPointer<vtkDataArray> AddVectors(vtkDataSet* data, const VectorField& field, int type)
{
  vtkSmartPointer<vtkDataArray> vectors;
  vectors.TakeReference(vtkDataArray::CreateDataArray(type));
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    Vector x;
    data->GetPoint(point, x.data());
    vectors->SetTuple(point, field(x).data());
  }
  data->GetPointData()->AddArray(vectors);
  data->GetPointData()->SetActiveVectors("velocity");
  return vectors;
}

vtkSmartPointer<vtkDataArray> AddRandomVectors(vtkDataSet* data, unsigned int seed, int type)
{
  Random random(seed);
  return AddVectors(
    data, [&random](const Vector&) { return random.GetPoint(1.0); }, type);
}

void MovePoints(vtkPointSet* grid, const VectorField& position)
{
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    Vector x;
    grid->GetPoint(point, x.data());
    moved->InsertNextPoint(position(x).data());
  }
  grid->SetPoints(moved);
}

VectorField MakeDisplacement(const std::array<int, 3>& cells, double bend)
{
  return [cells, bend](const Vector& x)
  {
    double inside = bend;
    for (int i = 0; i < 3; ++i)
    {
      // On the boundary the factor must be exactly 0, but the computed sine of pi is not.
      inside *= x[i] <= 0.0 || x[i] >= cells[i] ? 0.0 : std::sin(Pi * x[i] / cells[i]);
    }
    return Vector{ { x[0] + inside * std::sin(2.9 * x[1] + 1.7 * x[2]),
      x[1] + inside * std::cos(2.3 * x[2] + 2.6 * x[0]),
      x[2] + inside * std::sin(3.1 * x[0] - 1.3 * x[1] + 0.5) } };
  };
}

vtkSmartPointer<vtkStructuredGrid> MakeStructuredGrid(const std::array<int, 3>& cells)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i)
      {
        points->InsertNextPoint(i, j, k);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  grid->SetPoints(points);
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> MakeRing(const std::array<int, 3>& cells)
{
  auto grid = MakeStructuredGrid(cells);
  MovePoints(grid,
    [&](const Vector& index)
    {
      const double radius = 1.0 + index[0] / cells[0];
      const double angle = index[1] < cells[1] ? 2.0 * Pi * index[1] / cells[1] : 0.0;
      return Vector{ { radius * std::cos(angle), radius * std::sin(angle), index[2] } };
    });
  return grid;
}

const std::vector<MeshKind>& FlowMeshKinds()
{
  static const std::vector<MeshKind> kinds = { MeshKind::Hexahedra, MeshKind::Voxels,
    MeshKind::Wedges, MeshKind::Pyramids, MeshKind::Tetrahedra5, MeshKind::Tetrahedra6,
    MeshKind::Tetrahedra12, MeshKind::Mixed };
  return kinds;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeFlowMesh(
  MeshKind kind, const std::array<int, 3>& cells, bool hasVoxels, unsigned int seed)
{
  auto mesh = MakeMesh(kind, cells, seed);
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(mesh->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    int type = mesh->GetCellType(cell);
    if (type == VTK_POLYHEDRON)
    {
      // Point ids increase along x, y and z, so sorted ids have the point order of a voxel or a
      // wedge.
      std::sort(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds());
      type = ids->GetNumberOfIds() == 8 ? VTK_VOXEL : VTK_WEDGE;
    }
    if (type == VTK_VOXEL && !hasVoxels)
    {
      std::swap(ids->GetPointer(0)[2], ids->GetPointer(0)[3]);
      std::swap(ids->GetPointer(0)[6], ids->GetPointer(0)[7]);
      type = VTK_HEXAHEDRON;
    }
    result->InsertNextCell(type, ids);
  }
  return result;
}

CellSample SampleCell(
  vtkDataSet* data, vtkDataArray* vectors, vtkIdType cell, Random& random, bool hasGradient)
{
  vtkNew<vtkGenericCell> one;
  data->GetCell(cell, one);
  constexpr double inside = 0.01;
  double p[3];
  for (double& c : p)
  {
    c = random.Get(inside, 1.0 - inside);
  }
  const int type = one->GetCellType();
  if (type == VTK_TETRA || type == VTK_WEDGE)
  {
    const int number = type == VTK_TETRA ? 3 : 2;
    const double sum = std::accumulate(p, p + number, 0.0);
    for (int i = 0; i < number; ++i)
    {
      p[i] *= sum > 1.0 - inside ? (1.0 - inside) / sum : 1.0;
    }
  }
  CellSample sample;
  sample.Cell = cell;
  double weights[8];
  int subId = 0;
  one->EvaluateLocation(subId, p, sample.Position.data(), weights);
  sample.Velocity.fill(0.0);
  std::array<Vector, 8> values{};
  for (vtkIdType v = 0; v < one->GetNumberOfPoints(); ++v)
  {
    vectors->GetTuple(one->GetPointId(v), values[v].data());
    sample.Velocity += weights[v] * values[v];
  }
  sample.Gradient.fill(0.0);
  if (hasGradient)
  {
    one->Derivatives(subId, p, values[0].data(), 3, sample.Gradient.data());
  }
  return sample;
}

std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> MakeFlowGrids()
{
  std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> grids;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 5, 5);
  grids.emplace_back("image", image);
  auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> coordinates;
  for (const double x : { 0.0, 0.3, 1.7, 2.0, 4.0 })
  {
    coordinates->InsertNextValue(x);
  }
  rectilinear->SetDimensions(5, 5, 5);
  rectilinear->SetXCoordinates(coordinates);
  rectilinear->SetYCoordinates(coordinates);
  rectilinear->SetZCoordinates(coordinates);
  grids.emplace_back("rectilinear grid", rectilinear);
  auto structured = MakeStructuredGrid({ { 4, 4, 4 } });
  MovePoints(structured, MakeDisplacement({ { 4, 4, 4 } }, 0.2));
  grids.emplace_back("structured grid", structured);
  for (const MeshKind kind : FlowMeshKinds())
  {
    grids.emplace_back(
      "mesh " + std::to_string(static_cast<int>(kind)), MakeFlowMesh(kind, { { 4, 4, 4 } }));
  }
  return grids;
}

vtkSmartPointer<vtkImageData> MakeFlowImage(int points, const VectorField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  const double spacing = 4.0 / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  AddVectors(image, field);
  return image;
}

vtkSmartPointer<vtkTerminationPlane> MakeFlowPlane(double position)
{
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(position, 0.0, 0.0);
  plane->SetPoint1(position, 4.0, 0.0);
  plane->SetPoint2(position, 0.0, 4.0);
  return plane;
}

}
