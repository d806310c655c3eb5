// SPDX-License-Identifier: BSD-3-Clause
#include "Static/ExtractionCleanup.h"

#include "Output/OppositePairs.h"
#include "Output/TiedFaces.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <map>

namespace interlume
{

namespace
{
using Triple = std::array<vtkIdType, 3>;

// Faces of a tetrahedron, counterclockwise from outside, by the vertex they leave out.
constexpr int FacesOutward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

// Leaves out the simplices that are marked.
void RemoveSimplices(ExtractionMesh& mesh, const std::vector<bool>& isRemoved)
{
  const vtkIdType number = mesh.ItemIds->GetNumberOfValues();
  // Those before the first one stay where they are.
  vtkIdType kept =
    static_cast<vtkIdType>(std::find(isRemoved.begin(), isRemoved.end(), true) - isRemoved.begin());
  for (vtkIdType simplex = kept; simplex < number; ++simplex)
  {
    if (!isRemoved[simplex])
    {
      mesh.Simplices.Move(simplex, kept);
      mesh.ItemIds->SetValue(kept, mesh.ItemIds->GetValue(simplex));
      if (mesh.CellIds.GetSize() > 0)
      {
        mesh.CellIds[kept] = mesh.CellIds[simplex];
      }
      ++kept;
    }
  }
  mesh.Simplices.Truncate(kept);
  mesh.ItemIds->SetNumberOfValues(kept);
  mesh.CellIds.Truncate(mesh.CellIds.GetSize() > 0 ? kept : 0);
}

// Leaves out the boundary triangles that are marked.
void RemoveTriangles(ExtractionMesh& mesh, const std::vector<bool>& isRemoved)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < isRemoved.size(); ++t)
  {
    if (!isRemoved[t])
    {
      const vtkIdType to = static_cast<vtkIdType>(kept);
      const vtkIdType from = static_cast<vtkIdType>(t);
      mesh.Triangles[kept] = mesh.Triangles[t];
      mesh.TriangleItemIds->SetValue(to, mesh.TriangleItemIds->GetValue(from));
      mesh.TriangleSides->SetValue(to, mesh.TriangleSides->GetValue(from));
      if (!mesh.TriangleCellIds.empty())
      {
        mesh.TriangleCellIds[kept] = mesh.TriangleCellIds[t];
      }
      ++kept;
    }
  }
  mesh.Triangles.resize(kept);
  mesh.TriangleItemIds->SetNumberOfValues(static_cast<vtkIdType>(kept));
  mesh.TriangleSides->SetNumberOfValues(static_cast<vtkIdType>(kept));
  mesh.TriangleCellIds.resize(mesh.TriangleCellIds.empty() ? 0 : kept);
}

// Marks the points in use anew; simplices have \a size.
void MarkUsed(ExtractionMesh& mesh, int size)
{
  mesh.Used.AllocateZeros(mesh.Points.GetSize());
  const auto use = [&mesh](vtkIdType id) { mesh.Used[id].store(1, std::memory_order_relaxed); };
  vtkSMPTools::For(0, mesh.ItemIds->GetNumberOfValues(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType simplex = first; simplex < last; ++simplex)
      {
        for (int p = 0; p < size; ++p)
        {
          use(mesh.Simplices.GetId(simplex, p));
        }
      }
    });
  for (const Triple& triangle : mesh.Triangles)
  {
    std::for_each(triangle.begin(), triangle.end(), use);
  }
}

void AddTriangle(ExtractionMesh& mesh, const Triple& points, int item, int side)
{
  mesh.Triangles.push_back(points);
  mesh.TriangleItemIds->InsertNextValue(item);
  mesh.TriangleSides->InsertNextValue(side);
}
}

void ExtractionCleanup::RemoveUnusedPoints(ExtractionMesh& mesh)
{
  const std::size_t number = mesh.Points.GetSize();
  const std::atomic<unsigned char>* used = mesh.Used.GetData();
  if (std::find(used, used + number, 0) == used + number)
  {
    return;
  }
  std::vector<vtkIdType> newIds(mesh.Triangles.empty() ? 0 : number);
  vtkIdType kept = 0;
  mesh.Simplices.RemovePoints(used, static_cast<vtkIdType>(number),
    [&](vtkIdType p, vtkIdType before)
    {
      mesh.Points[before] = mesh.Points[p];
      kept = before + used[p].load(std::memory_order_relaxed);
      if (!newIds.empty())
      {
        newIds[p] = before;
      }
    });
  mesh.Points.Truncate(kept);
  for (auto& triangle : mesh.Triangles)
  {
    for (vtkIdType& id : triangle)
    {
      id = newIds[id];
    }
  }
}

void ExtractionCleanup::RemoveOppositeSimplices(ExtractionMesh& mesh, int size)
{
  using Entry = OppositePairs::Entry<vtkIdType, 5>;
  std::vector<Entry> entries;
  for (const vtkIdType simplex : mesh.TiedSimplices)
  {
    Entry entry{ { { mesh.ItemIds->GetValue(simplex) } }, false,
      static_cast<std::size_t>(simplex) };
    for (int p = 0; p < size; ++p)
    {
      entry.Key[1 + p] = mesh.Simplices.GetId(simplex, p);
    }
    entry.IsOdd = OppositePairs::Sort(entry.Key.data() + 1, size);
    entries.push_back(entry);
  }
  const vtkIdType number = mesh.ItemIds->GetNumberOfValues();
  std::vector<bool> isRemoved;
  OppositePairs::Find(entries,
    [&](std::size_t place)
    {
      isRemoved.resize(number, false);
      isRemoved[place] = true;
    });
  if (!isRemoved.empty())
  {
    RemoveSimplices(mesh, isRemoved);
    MarkUsed(mesh, size);
  }
}

void ExtractionCleanup::RemoveMarked(ExtractionMesh& mesh, int size,
  const std::vector<bool>& simplices, const std::vector<bool>& triangles)
{
  RemoveSimplices(mesh, simplices);
  RemoveTriangles(mesh, triangles);
  MarkUsed(mesh, size);
}

void ExtractionCleanup::SettleTiedTriangles(ExtractionMesh& mesh)
{
  TiedFaces<3> faces(mesh.Points.GetSize());
  for (const vtkIdType t : mesh.TiedTriangles)
  {
    faces.Add(mesh.TriangleItemIds->GetValue(t), mesh.Triangles[t].data(), t);
  }
  std::vector<bool> isRemoved(mesh.Triangles.size(), false);
  faces.Cancel([&](std::size_t place) { isRemoved[place] = true; });
  vtkSMPTools::For(0, faces.IsEmpty() ? 0 : mesh.ItemIds->GetNumberOfValues(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType simplex = first; simplex < last; ++simplex)
      {
        vtkIdType ids[4];
        for (int p = 0; p < 4; ++p)
        {
          ids[p] = mesh.Simplices.GetId(simplex, p);
        }
        for (int f = 0; f < 4 && faces.IsNear(ids, 4); ++f)
        {
          const int* face = FacesOutward[f];
          const Triple points{ { ids[face[0]], ids[face[1]], ids[face[2]] } };
          faces.Count(mesh.ItemIds->GetValue(simplex), points.data(), simplex);
        }
      }
    });
  faces.Visit(
    [&](std::size_t place, bool isFace, vtkIdType simplex)
    {
      isRemoved[place] = !isFace;
      if (isFace && !mesh.TriangleCellIds.empty())
      {
        mesh.TriangleCellIds[place] = mesh.CellIds[simplex];
      }
    });
  if (std::find(isRemoved.begin(), isRemoved.end(), true) != isRemoved.end())
  {
    RemoveTriangles(mesh, isRemoved);
    MarkUsed(mesh, 4);
  }
}

void ExtractionCleanup::CutBoundary(
  vtkDataSet* input, vtkUnstructuredGrid* inputBoundary, ExtractionMesh& mesh)
{
  vtkDataArray* itemIds = inputBoundary->GetCellData()->GetArray("IntervalId");
  vtkDataArray* sides = inputBoundary->GetCellData()->GetArray("BoundarySide");
  vtkDataArray* itemOfCell = input->GetCellData()->GetArray("IntervalId");
  vtkNew<vtkIdList> ids;
  std::map<std::pair<int, Triple>, int> sideOf;
  for (vtkIdType t = 0; t < inputBoundary->GetNumberOfCells(); ++t)
  {
    inputBoundary->GetCellPoints(t, ids);
    Triple points{ { ids->GetId(0), ids->GetId(1), ids->GetId(2) } };
    OppositePairs::Sort(points.data(), 3);
    sideOf[{ static_cast<int>(itemIds->GetComponent(t, 0)), points }] =
      static_cast<int>(sides->GetComponent(t, 0));
  }
  for (std::size_t simplex = 0; simplex < mesh.CellIds.GetSize(); ++simplex)
  {
    const vtkIdType cell = mesh.CellIds[simplex];
    const int item = static_cast<int>(itemOfCell->GetComponent(cell, 0));
    input->GetCellPoints(cell, ids);
    for (int out = 0; out < 4; ++out)
    {
      Triple whole{ { ids->GetId(FacesOutward[out][0]), ids->GetId(FacesOutward[out][1]),
        ids->GetId(FacesOutward[out][2]) } };
      OppositePairs::Sort(whole.data(), 3);
      const auto side = sideOf.find({ item, whole });
      if (side == sideOf.end())
      {
        continue;
      }
      vtkIdType points[4];
      for (int p = 0; p < 4; ++p)
      {
        points[p] = mesh.Simplices.GetId(simplex, p);
      }
      const auto isOnFace = [&](vtkIdType p)
      {
        const ExtractionPoint& point = mesh.Points[p];
        return point.Near != ids->GetId(out) && point.Far != ids->GetId(out);
      };
      for (const auto& face : FacesOutward)
      {
        if (isOnFace(points[face[0]]) && isOnFace(points[face[1]]) && isOnFace(points[face[2]]))
        {
          AddTriangle(
            mesh, { { points[face[0]], points[face[1]], points[face[2]] } }, item, side->second);
          mesh.TriangleCellIds.push_back(cell);
        }
      }
    }
  }
}

}
