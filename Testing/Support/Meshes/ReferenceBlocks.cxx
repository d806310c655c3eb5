// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceBlocks.h"

#include "Support/Meshes/ReferenceTransform.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace reference
{

namespace
{
vtkSmartPointer<vtkDataArray> MakeIds(const IdStorage& storage, const std::vector<vtkIdType>& ids)
{
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(storage.IsInColumns ? vtkSOADataArrayTemplate<long long>::New()
                                          : vtkDataArray::CreateDataArray(storage.Type));
  array->SetName("ids");
  array->SetNumberOfComponents(1);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    array->SetTuple1(static_cast<vtkIdType>(i), static_cast<double>(ids[i]));
  }
  return array;
}

// Returns the cells of a mesh on one side of the plane between the blocks, with only the points
// they use.
vtkSmartPointer<vtkUnstructuredGrid> Cut(vtkUnstructuredGrid* mesh, int axis, int side)
{
  auto block = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  std::map<vtkIdType, vtkIdType> idOf;
  const auto number = [&](vtkIdType id)
  {
    const auto found = idOf.emplace(id, static_cast<vtkIdType>(idOf.size()));
    if (found.second)
    {
      points->InsertNextPoint(mesh->GetPoint(id));
    }
    return found.first->second;
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    mesh->GetCellBounds(cell, bounds);
    if ((bounds[2 * axis] + bounds[2 * axis + 1] > 2.0) != (side == 1))
    {
      continue;
    }
    if (mesh->GetCellType(cell) == VTK_POLYHEDRON)
    {
      mesh->GetFaceStream(cell, ids);
      for (vtkIdType* id = ids->begin() + 1; id < ids->end(); id += 1 + *id)
      {
        std::transform(id + 1, id + 1 + *id, id + 1, number);
      }
    }
    else
    {
      mesh->GetCellPoints(cell, ids);
      std::transform(ids->begin(), ids->end(), ids->begin(), number);
    }
    block->InsertNextCell(mesh->GetCellType(cell), ids);
  }
  block->SetPoints(points);
  return block;
}
}

std::vector<IdStorage> AllIdStorages()
{
  std::vector<IdStorage> all = { { VTK_LONG_LONG, true } };
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    all.push_back({ type, false });
  }
  return all;
}

std::array<vtkSmartPointer<vtkUnstructuredGrid>, 2> MakeBlocks(
  MeshKind kind, int axis, unsigned int seed, const IdStorage& ids)
{
  const auto mesh = MakeMesh(kind, { 2, 2, 2 });
  std::map<std::array<double, 3>, vtkIdType> idOf;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x;
    mesh->GetPoint(p, x.data());
    idOf[x] = p;
  }
  std::array<vtkSmartPointer<vtkUnstructuredGrid>, 2> blocks;
  for (int side = 0; side < 2; ++side)
  {
    blocks[side] = RenumberPoints(Cut(mesh, axis, side), 2 * seed + side);
    vtkUnstructuredGrid* block = blocks[side];
    std::vector<vtkIdType> globalIds;
    vtkNew<vtkDoubleArray> distance;
    distance->SetName("f");
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      std::array<double, 3> x;
      block->GetPoint(p, x.data());
      globalIds.push_back(idOf.at(x));
      distance->InsertNextValue(std::abs(x[axis] - 1.0));
    }
    block->GetPointData()->SetScalars(distance);
    if (ids.Type != VTK_VOID)
    {
      block->GetPointData()->SetGlobalIds(MakeIds(ids, globalIds));
    }
  }
  return blocks;
}

std::multiset<std::vector<std::array<double, 4>>> FacesBetweenBlocks(
  vtkUnstructuredGrid* simplices, int axis)
{
  std::multiset<std::vector<std::array<double, 4>>> faces;
  vtkDataArray* times = simplices->GetPointData()->GetArray("Time");
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < simplices->GetNumberOfCells(); ++cell)
  {
    simplices->GetCellPoints(cell, ids);
    std::vector<std::array<double, 4>> face;
    for (const vtkIdType id : *ids)
    {
      std::array<double, 4> x = { { 0, 0, 0, times ? times->GetTuple1(id) : 0.0 } };
      simplices->GetPoint(id, x.data());
      if (x[axis] == 1.0)
      {
        face.push_back(x);
      }
    }
    if (static_cast<vtkIdType>(face.size()) + 1 == ids->GetNumberOfIds())
    {
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  return faces;
}

}
