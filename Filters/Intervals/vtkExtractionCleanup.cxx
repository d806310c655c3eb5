#include "vtkExtractionCleanup.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <atomic>
#include <map>

namespace
{
using Triple = std::array<vtkIdType, 3>;

// Sorts three ids; returns whether it took an odd number of exchanges.
bool SortTriple(Triple& ids)
{
  bool odd = false;
  const auto order = [&](int a, int b)
  {
    if (ids[b] < ids[a])
    {
      std::swap(ids[a], ids[b]);
      odd = !odd;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return odd;
}

void AddTriangle(vtkExtractionMesh& mesh, const Triple& points, int item, int side)
{
  mesh.Triangles.push_back(points);
  mesh.TriangleItemIds->InsertNextValue(item);
  mesh.TriangleSides->InsertNextValue(side);
}
}

void vtkExtractionCleanup::RemoveUnusedPoints(vtkExtractionMesh& mesh)
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

void vtkExtractionCleanup::RemoveOppositeTriangles(vtkExtractionMesh& mesh)
{
  // For each triangle of an interval, the indices that wait for one of opposite orientation.
  std::map<std::pair<int, Triple>, std::vector<std::size_t>> waiting[2];
  std::vector<bool> removed(mesh.Triangles.size(), false);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    Triple points = mesh.Triangles[t];
    const bool odd = SortTriple(points);
    const std::pair<int, Triple> key(mesh.TriangleItemIds->GetValue(t), points);
    auto& opposite = waiting[!odd][key];
    if (opposite.empty())
    {
      waiting[odd][key].push_back(t);
    }
    else
    {
      removed[t] = removed[opposite.back()] = true;
      opposite.pop_back();
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < removed.size(); ++t)
  {
    if (!removed[t])
    {
      mesh.Triangles[kept] = mesh.Triangles[t];
      mesh.TriangleItemIds->SetValue(kept, mesh.TriangleItemIds->GetValue(t));
      mesh.TriangleSides->SetValue(kept, mesh.TriangleSides->GetValue(t));
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

void vtkExtractionCleanup::CutBoundary(
  vtkDataSet* input, vtkUnstructuredGrid* inputBoundary, vtkExtractionMesh& mesh)
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
    SortTriple(points);
    sideOf[{ static_cast<int>(itemIds->GetComponent(t, 0)), points }] =
      static_cast<int>(sides->GetComponent(t, 0));
  }
  // Faces of a tetrahedron, counterclockwise from outside, by the vertex they leave out.
  constexpr int faces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  for (std::size_t simplex = 0; simplex < mesh.CellIds.GetSize(); ++simplex)
  {
    const vtkIdType cell = mesh.CellIds[simplex];
    const int item = static_cast<int>(itemOfCell->GetComponent(cell, 0));
    input->GetCellPoints(cell, ids);
    for (int out = 0; out < 4; ++out)
    {
      Triple whole{ { ids->GetId(faces[out][0]), ids->GetId(faces[out][1]),
        ids->GetId(faces[out][2]) } };
      SortTriple(whole);
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
        const vtkExtractionPoint& point = mesh.Points[p];
        return point.Near != ids->GetId(out) && point.Far != ids->GetId(out);
      };
      for (const auto& face : faces)
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
