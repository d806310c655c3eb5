// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace reference
{

namespace
{

using Order = std::vector<int>;
using Faces = std::vector<std::vector<vtkIdType>>;

/// Symmetries of a cell type as permutations of its points: generators of all rotations, and one
/// reflection.
struct Symmetry
{
  std::vector<Order> Rotations;
  Order Reflection;
};

const Symmetry& GetSymmetry(int type)
{
  static const Symmetry tetrahedron = { { { 1, 2, 0, 3 }, { 0, 2, 3, 1 } }, { 1, 0, 2, 3 } };
  static const Symmetry pyramid = { { { 1, 2, 3, 0, 4 } }, { 3, 2, 1, 0, 4 } };
  static const Symmetry wedge = { { { 1, 2, 0, 4, 5, 3 }, { 3, 5, 4, 0, 2, 1 } },
    { 3, 4, 5, 0, 1, 2 } };
  static const Symmetry hexahedron = { { { 1, 2, 3, 0, 5, 6, 7, 4 }, { 1, 5, 6, 2, 0, 4, 7, 3 } },
    { 4, 5, 6, 7, 0, 1, 2, 3 } };
  // A rotated voxel would not have its points in the order that its type requires.
  static const Symmetry voxel = { {}, { 0, 1, 2, 3, 4, 5, 6, 7 } };
  switch (type)
  {
    case VTK_TETRA:
      return tetrahedron;
    case VTK_PYRAMID:
      return pyramid;
    case VTK_WEDGE:
      return wedge;
    case VTK_HEXAHEDRON:
      return hexahedron;
    case VTK_VOXEL:
      return voxel;
    default:
      throw std::invalid_argument("no rotations are defined for cell type " + std::to_string(type));
  }
}

std::vector<vtkIdType> Permuted(const std::vector<vtkIdType>& ids, const Order& order)
{
  std::vector<vtkIdType> result;
  for (int i : order)
  {
    result.push_back(ids[i]);
  }
  return result;
}

Faces GetFaces(vtkUnstructuredGrid* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> stream;
  mesh->GetFaceStream(cell, stream);
  Faces faces;
  for (vtkIdType at = 1; at < stream->GetNumberOfIds();)
  {
    const vtkIdType size = stream->GetId(at);
    faces.emplace_back(stream->begin() + at + 1, stream->begin() + at + 1 + size);
    at += size + 1;
  }
  return faces;
}

void InsertPolyhedron(
  vtkUnstructuredGrid* mesh, const std::vector<vtkIdType>& ids, const Faces& faces)
{
  std::vector<vtkIdType> stream;
  for (const auto& face : faces)
  {
    stream.push_back(static_cast<vtkIdType>(face.size()));
    stream.insert(stream.end(), face.begin(), face.end());
  }
  mesh->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(ids.size()), ids.data(),
    static_cast<vtkIdType>(faces.size()), stream.data());
}

using CellChange = std::function<void(int type, std::vector<vtkIdType>& ids, Faces& faces)>;

vtkSmartPointer<vtkUnstructuredGrid> ChangeCells(
  vtkUnstructuredGrid* mesh, vtkPoints* points, const CellChange& change)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(points);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    vtkNew<vtkIdList> list;
    mesh->GetCellPoints(cell, list);
    std::vector<vtkIdType> ids(list->begin(), list->end());
    Faces faces;
    if (type == VTK_POLYHEDRON)
    {
      faces = GetFaces(mesh, cell);
    }
    change(type, ids, faces);
    if (type == VTK_POLYHEDRON)
    {
      InsertPolyhedron(result, ids, faces);
    }
    else
    {
      result->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  return result;
}

}

vtkSmartPointer<vtkUnstructuredGrid> RotateCellPointOrder(
  vtkUnstructuredGrid* mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  return ChangeCells(mesh, mesh->GetPoints(),
    [&](int type, std::vector<vtkIdType>& ids, Faces& faces)
    {
      if (type == VTK_POLYHEDRON)
      {
        std::shuffle(ids.begin(), ids.end(), random);
        std::shuffle(faces.begin(), faces.end(), random);
        for (auto& face : faces)
        {
          std::rotate(face.begin(), face.begin() + random() % face.size(), face.end());
        }
        return;
      }
      // A random product of generators, long enough to reach every rotation.
      const auto& rotations = GetSymmetry(type).Rotations;
      for (int i = 0; i < 12; ++i)
      {
        const unsigned int choice = random() % (rotations.size() + 1);
        if (choice < rotations.size())
        {
          ids = Permuted(ids, rotations[choice]);
        }
      }
    });
}

vtkSmartPointer<vtkUnstructuredGrid> InvertCells(vtkUnstructuredGrid* mesh)
{
  return ChangeCells(mesh, mesh->GetPoints(),
    [](int type, std::vector<vtkIdType>& ids, Faces&)
    {
      if (type != VTK_POLYHEDRON)
      {
        ids = Permuted(ids, GetSymmetry(type).Reflection);
      }
    });
}

vtkSmartPointer<vtkUnstructuredGrid> RenumberPoints(vtkUnstructuredGrid* mesh, unsigned int seed)
{
  std::vector<vtkIdType> number(mesh->GetNumberOfPoints());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(seed);
  std::shuffle(number.begin(), number.end(), random);
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(number[i], mesh->GetPoint(i));
  }
  return ChangeCells(mesh, points,
    [&](int, std::vector<vtkIdType>& ids, Faces& faces)
    {
      auto renumber = [&](vtkIdType& id) { id = number[id]; };
      std::for_each(ids.begin(), ids.end(), renumber);
      for (auto& face : faces)
      {
        std::for_each(face.begin(), face.end(), renumber);
      }
    });
}

vtkSmartPointer<vtkUnstructuredGrid> MapProjectively(vtkUnstructuredGrid* mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> small(-0.25, 0.25);
  const double* bounds = mesh->GetBounds();
  std::array<std::array<double, 3>, 3> matrix;
  std::array<double, 3> perspective;
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      matrix[a][b] = (a == b ? 1.0 : 0.0) + small(random);
    }
    // The denominator is between 1/4 and 7/4 in the mesh, so the map is regular there.
    perspective[a] = small(random) / (bounds[2 * a + 1] - bounds[2 * a]) * 2.0;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    double denominator = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      x[a] -= 0.5 * (bounds[2 * a] + bounds[2 * a + 1]);
      denominator += perspective[a] * x[a];
    }
    double y[3];
    for (int a = 0; a < 3; ++a)
    {
      y[a] = (matrix[a][0] * x[0] + matrix[a][1] * x[1] + matrix[a][2] * x[2]) / denominator;
    }
    points->SetPoint(i, y);
  }
  return ChangeCells(mesh, points, [](int, std::vector<vtkIdType>&, Faces&) {});
}

}
