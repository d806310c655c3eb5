// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/ExtractionCleanup.h"

#include "Arrays/PointArrays.h"
#include "Common/ParallelFor.h"
#include "Grid/InteriorCellFilter.h"
#include "Output/OppositePairs.h"
#include "Pass/InteriorFaces.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <tuple>
#include <utility>

namespace interlume
{

namespace
{
using Triple = std::array<vtkIdType, 3>;

// Faces of a tetrahedron, counterclockwise as seen from outside, and sides of a triangle with the
// triangle to their left. A side contains its second vertex twice. Face i does not contain vertex
// i.
constexpr int TetrahedronFaces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
constexpr int TriangleSides[3][3] = { { 1, 2, 2 }, { 2, 0, 0 }, { 0, 1, 1 } };

using FaceVertices = const int[3];

// Returns the faces of a simplex with \a corners + 1 points.
FaceVertices* GetFaces(int corners)
{
  return corners == 3 ? TetrahedronFaces : TriangleSides;
}

// Returns a face with its \a corners points in ascending order.
Triple MakeKey(Triple face, int corners)
{
  OppositePairs::Sort(face.data(), corners);
  face[2] = corners == 3 ? face[2] : face[1];
  return face;
}

template <typename Visitor>
void ForEachTriple(const vtkIdType* ids, int number, Visitor&& visit)
{
  for (int a = 0; a < number; ++a)
  {
    for (int b = 0; b < a; ++b)
    {
      for (int c = 0; c < b; ++c)
      {
        visit(Triple{ { ids[a], ids[b], ids[c] } });
      }
    }
  }
}

// Removes the simplices with the given indices, which must be in increasing order.
void RemoveSimplices(ExtractionMesh& mesh, const std::vector<vtkIdType>& removed)
{
  const RetainedIdRanges retained(removed, mesh.Simplices.GetNumber());
  mesh.Simplices.Keep(retained);
  if (mesh.HasSeveralItems)
  {
    retained.Compact(mesh.ItemIds->GetPointer(0), 1);
  }
  if (mesh.CellIds.GetSize() > 0)
  {
    retained.Compact(mesh.CellIds.GetData(), 1);
  }
  mesh.TruncateSimplices(retained.GetNumber());
}

// Removes the marked interior cells. \a removedSimplices simplices were removed before.
void RemoveInteriorCells(
  ExtractionMesh& mesh, const std::vector<bool>& isRemoved, vtkIdType removedSimplices)
{
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  std::vector<vtkIdType> newIndices(isRemoved.size(), -1);
  vtkIdType retained = simplices;
  for (std::size_t cell = 0; cell < isRemoved.size(); ++cell)
  {
    if (!isRemoved[cell])
    {
      const vtkIdType from = simplices + static_cast<vtkIdType>(cell);
      mesh.ItemIds->SetValue(retained, mesh.ItemIds->GetValue(from));
      mesh.InteriorCellTypes[retained - simplices] = mesh.InteriorCellTypes[cell];
      if (mesh.CellIds.GetSize() > 0)
      {
        mesh.CellIds[retained] = mesh.CellIds[from];
      }
      newIndices[cell] = retained++;
    }
  }
  mesh.Simplices.RemoveInteriorCells(isRemoved);
  OutputAllocation::Shorten(mesh.ItemIds, retained);
  mesh.InteriorCellTypes.Truncate(retained - simplices);
  mesh.CellIds.Truncate(mesh.CellIds.GetSize() > 0 ? retained : 0);
  for (vtkIdType& whole : mesh.TriangleInteriorCells)
  {
    whole = whole < 0 ? whole : newIndices[whole - simplices - removedSimplices];
  }
}

// Removes the marked boundary triangles.
void RemoveTriangles(ExtractionMesh& mesh, const std::vector<bool>& isRemoved)
{
  std::vector<vtkIdType> removed;
  for (std::size_t t = 0; t < isRemoved.size(); ++t)
  {
    if (isRemoved[t])
    {
      removed.push_back(static_cast<vtkIdType>(t));
    }
  }
  const RetainedIdRanges retained(removed, static_cast<vtkIdType>(isRemoved.size()));
  const auto keep = [&retained](auto& values)
  {
    if (!values.empty())
    {
      retained.Compact(values.data(), 1);
      values.resize(static_cast<std::size_t>(retained.GetNumber()));
    }
  };
  keep(mesh.Triangles);
  keep(mesh.TriangleCellIds);
  keep(mesh.TriangleInteriorCells);
  for (vtkIntArray* array : { mesh.TriangleItemIds.Get(), mesh.TriangleSides.Get() })
  {
    retained.Compact(array->GetPointer(0), 1);
    array->SetNumberOfValues(retained.GetNumber());
  }
}

// Recomputes \a mesh.Used, the marks of the points that cells use.
void MarkUsed(ExtractionMesh& mesh)
{
  // If the mesh has no list of points, the existing marks define the number of points.
  const std::size_t listed = mesh.Points.GetSize();
  mesh.Used.AllocateZeros(listed > 0 ? listed : mesh.Used.GetSize());
  const auto use = [used = mesh.Used.GetData()](vtkIdType id)
  { used[id].store(1, std::memory_order_relaxed); };
  mesh.Simplices.ForEachId(use);
  for (const Triple& triangle : mesh.Triangles)
  {
    std::for_each(triangle.begin(), triangle.end(), use);
  }
}

// Marks the points of the tied simplices that are not in \a removed.
void MarkTied(ExtractionMesh& mesh, const std::vector<vtkIdType>& removed, int size)
{
  auto nextRemoved = removed.begin();
  for (const vtkIdType simplex : mesh.TiedSimplices)
  {
    if (nextRemoved != removed.end() && *nextRemoved == simplex)
    {
      ++nextRemoved;
      continue;
    }
    for (int p = 0; p < size; ++p)
    {
      mesh.Used[mesh.Simplices.GetId(simplex, p)].store(1, std::memory_order_relaxed);
    }
  }
}

void AddTriangle(ExtractionMesh& mesh, const Triple& points, int item, int side)
{
  mesh.Triangles.push_back(points);
  mesh.TriangleItemIds->InsertNextValue(item);
  mesh.TriangleSides->InsertNextValue(side);
}

// The boundary of a mesh of simplices, except for the triangles of interior cells.
class BoundaryFaces
{
public:
  BoundaryFaces(
    vtkDataSet* input, vtkUnstructuredGrid* boundary, int corners, const InteriorCellPass* whole)
    : Corners(corners)
    , Near(input->GetNumberOfPoints(), false)
  {
    vtkDataArray* itemIds = boundary->GetCellData()->GetArray("IntervalId");
    vtkDataArray* sides = boundary->GetCellData()->GetArray("BoundarySide");
    const bool hasInterior = whole && !whole->TriangleInteriorCells.empty();
    vtkNew<vtkIdList> ids;
    for (vtkIdType t = 0; t < boundary->GetNumberOfCells(); ++t)
    {
      if (hasInterior && whole->TriangleInteriorCells[t] >= 0)
      {
        continue;
      }
      boundary->GetCellPoints(t, ids);
      std::for_each(ids->begin(), ids->end(), [this](vtkIdType id) { this->Near[id] = true; });
      const Triple points{ { ids->GetId(0), ids->GetId(1), ids->GetId(corners - 1) } };
      this->Faces.push_back({ static_cast<int>(itemIds->GetComponent(t, 0)),
        MakeKey(points, corners), static_cast<int>(sides->GetComponent(t, 0)) });
    }
    std::sort(this->Faces.begin(), this->Faces.end());
  }

  // Sets \a sides to the BoundarySide of each face of a simplex, or to -1 if the face is not in the
  // boundary. Returns whether any face is.
  bool FindSides(int item, const vtkIdType* ids, int* sides) const
  {
    bool isAny = false;
    const bool isNear = std::count_if(ids, ids + this->Corners + 1,
                          [this](vtkIdType id) { return this->Near[id]; }) >= this->Corners;
    for (int out = 0; isNear && out <= this->Corners; ++out)
    {
      const int* const face = GetFaces(this->Corners)[out];
      const Face sought{ item,
        MakeKey({ { ids[face[0]], ids[face[1]], ids[face[2]] } }, this->Corners), -1 };
      const auto found = std::lower_bound(this->Faces.begin(), this->Faces.end(), sought);
      const bool isFound =
        found != this->Faces.end() && found->Item == item && found->Key == sought.Key;
      sides[out] = isFound ? found->Side : -1;
      isAny |= isFound;
    }
    return isAny;
  }

private:
  struct Face
  {
    int Item;
    Triple Key;
    int Side;

    bool operator<(const Face& other) const
    {
      return std::tie(this->Item, this->Key, this->Side) <
        std::tie(other.Item, other.Key, other.Side);
    }
  };

  int Corners;
  // A mark per point, true if a boundary face has the point.
  std::vector<bool> Near;
  std::vector<Face> Faces;
};

// Adds the faces of a simplex that lie in a boundary face of the input's cell with points \a ids.
// \a sides contains the side of each face of the cell, or -1.
void AddFaces(
  ExtractionMesh& mesh, vtkIdType simplex, const vtkIdType* ids, const int* sides, int corners)
{
  vtkIdType points[4];
  for (int p = 0; p <= corners; ++p)
  {
    points[p] = mesh.Simplices.GetId(simplex, p);
  }
  for (int out = 0; out <= corners; ++out)
  {
    const auto isOnFace = [&](int p)
    {
      const ExtractionPoint& point = mesh.Points[points[p]];
      return point.Near != ids[out] && point.Far != ids[out];
    };
    for (int f = 0; sides[out] >= 0 && f <= corners; ++f)
    {
      const int* const face = GetFaces(corners)[f];
      if (std::all_of(face, face + 3, isOnFace))
      {
        AddTriangle(mesh, { { points[face[0]], points[face[1]], points[face[2]] } },
          mesh.ItemIds->GetValue(simplex), sides[out]);
        mesh.TriangleCellIds.push_back(mesh.CellIds[simplex]);
      }
    }
  }
}

// Copies the boundary triangles of interior cells, which remain unchanged.
void CopyInteriorBoundary(vtkDataSet* input, vtkUnstructuredGrid* inputBoundary,
  const InteriorCellPass& whole, ExtractionMesh& mesh)
{
  std::vector<vtkIdType> newIds(input->GetNumberOfPoints(), -1);
  for (std::size_t p = 0; p < mesh.Points.GetSize(); ++p)
  {
    if (mesh.Points[p].Near == mesh.Points[p].Far)
    {
      newIds[mesh.Points[p].Near] = static_cast<vtkIdType>(p);
    }
  }
  vtkDataArray* itemIds = inputBoundary->GetCellData()->GetArray("IntervalId");
  vtkDataArray* sides = inputBoundary->GetCellData()->GetArray("BoundarySide");
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < inputBoundary->GetNumberOfCells(); ++t)
  {
    const vtkIdType cell = whole.TriangleInteriorCells[t];
    if (cell >= 0)
    {
      inputBoundary->GetCellPoints(t, ids);
      AddTriangle(mesh, { { newIds[ids->GetId(0)], newIds[ids->GetId(1)], newIds[ids->GetId(2)] } },
        static_cast<int>(itemIds->GetComponent(t, 0)), static_cast<int>(sides->GetComponent(t, 0)));
      mesh.TriangleCellIds.push_back(cell);
      mesh.TriangleInteriorCells.push_back(cell - whole.First + mesh.Simplices.GetNumber());
    }
  }
}

// Removes those of the first \a number boundary triangles that coincide with another one of the
// same interval. \a corners is the number of their points.
void RemoveCoincident(ExtractionMesh& mesh, std::size_t number, int corners)
{
  const auto getKey = [&](std::size_t t)
  {
    return std::make_pair(mesh.TriangleItemIds->GetValue(static_cast<vtkIdType>(t)),
      MakeKey(mesh.Triangles[t], corners));
  };
  std::set<std::pair<int, Triple>> keys;
  for (std::size_t t = number; t < mesh.Triangles.size(); ++t)
  {
    keys.insert(getKey(t));
  }
  std::vector<bool> isRemoved(mesh.Triangles.size(), false);
  for (std::size_t t = 0; t < number; ++t)
  {
    isRemoved[t] = keys.count(getKey(t)) > 0;
  }
  RemoveTriangles(mesh, isRemoved);
}
}

void ExtractionCleanup::SplitPoints(ExtractionMesh& mesh)
{
  const vtkIdType triangles = mesh.Simplices.GetNumber();
  ExtractionBuffer<ExtractionPoint> corners;
  corners.Allocate(3 * triangles);
  ParallelFor(0, 3 * triangles,
    [&](vtkIdType corner) { corners[corner] = mesh.Points[mesh.Simplices.GetIdAt(corner)]; });
  mesh.Points = std::move(corners);
  mesh.Simplices.Allocate(triangles, 3, 3 * triangles);
  mesh.Simplices.NumberConsecutively();
}

void ExtractionCleanup::RemoveUnusedPoints(ExtractionMesh& mesh, PointArrays* arrays)
{
  const std::size_t number = mesh.Used.GetSize();
  const std::atomic<unsigned char>* used = mesh.Used.GetData();
  if (std::find(used, used + number, 0) == used + number)
  {
    return;
  }
  const vtkIdType points = static_cast<vtkIdType>(number);
  const RetainedIdRanges retained(used, points);
  mesh.Simplices.RemovePoints(retained, points);
  if (arrays)
  {
    arrays->Keep(retained);
  }
  else
  {
    retained.Compact(mesh.Points.GetData(), 1);
    mesh.Points.Truncate(static_cast<std::size_t>(retained.GetNumber()));
  }
  std::vector<vtkIdType> newIds(mesh.Triangles.empty() ? 0 : number);
  if (!newIds.empty())
  {
    retained.FillIds(newIds.data());
  }
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
  std::vector<vtkIdType> removed;
  OppositePairs::Find(
    entries, [&](std::size_t index) { removed.push_back(static_cast<vtkIdType>(index)); });
  std::sort(removed.begin(), removed.end());
  const bool hasMarks = mesh.Used.GetSize() > 0;
  if (hasMarks)
  {
    MarkTied(mesh, removed, size);
  }
  if (!removed.empty())
  {
    RemoveSimplices(mesh, removed);
    if (!hasMarks)
    {
      MarkUsed(mesh);
    }
  }
}

void ExtractionCleanup::RemoveMarked(
  ExtractionMesh& mesh, const std::vector<bool>& cells, const std::vector<bool>& triangles)
{
  RemoveTriangles(mesh, triangles);
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  std::vector<vtkIdType> removed;
  for (vtkIdType simplex = 0; simplex < simplices; ++simplex)
  {
    if (cells[simplex])
    {
      removed.push_back(simplex);
    }
  }
  RemoveSimplices(mesh, removed);
  if (mesh.Simplices.GetNumberOfInteriorCells() > 0)
  {
    RemoveInteriorCells(
      mesh, { cells.begin() + simplices, cells.end() }, static_cast<vtkIdType>(removed.size()));
  }
  MarkUsed(mesh);
}

template <int Corners>
void ExtractionCleanup::CountFaces(const ExtractionMesh& mesh, TiedFaces<Corners>& faces)
{
  constexpr int size = Corners + 1;
  ParallelFor(0, faces.IsEmpty() ? 0 : mesh.Simplices.GetNumber(),
    [&](vtkIdType simplex)
    {
      vtkIdType ids[size];
      for (int p = 0; p < size; ++p)
      {
        ids[p] = mesh.Simplices.GetId(simplex, p);
      }
      for (int f = 0; f < size && faces.IsNear(ids, size); ++f)
      {
        const int* face = GetFaces(Corners)[f];
        const Triple points{ { ids[face[0]], ids[face[1]], ids[face[2]] } };
        faces.Count(mesh.ItemIds->GetValue(simplex), points.data(), simplex);
      }
    });
}

template void ExtractionCleanup::CountFaces<3>(const ExtractionMesh& mesh, TiedFaces<3>& faces);

void ExtractionCleanup::ResolveTiedTriangles(const ExtractionContext& context, ExtractionMesh& mesh)
{
  context.Dimension == 2 ? ResolveTied<2>(context, mesh) : ResolveTied<3>(context, mesh);
}

template <int Corners>
void ExtractionCleanup::ResolveTied(const ExtractionContext& context, ExtractionMesh& mesh)
{
  TiedFaces<Corners> faces(mesh.Points.GetSize());
  for (const vtkIdType t : mesh.TiedTriangles)
  {
    faces.Add(mesh.TriangleItemIds->GetValue(t), mesh.Triangles[t].data(), t);
  }
  std::vector<bool> isRemoved(mesh.Triangles.size(), false);
  faces.Cancel([&](std::size_t index) { isRemoved[index] = true; });
  const vtkIdType simplices = mesh.Simplices.GetNumber();
  CountFaces(mesh, faces);
  if (context.InteriorFilter && !faces.IsEmpty())
  {
    const InteriorFaces whole(context, mesh);
    const bool isFurther =
      context.InteriorFilter->GetFirstPassedCell() < context.Input->GetNumberOfCells();
    mesh.Simplices.ForEachInteriorCell(
      [&](vtkIdType cell, const vtkIdType* ids, int number)
      {
        const vtkIdType index = simplices + cell;
        const vtkIdType item = mesh.ItemIds->GetValue(index);
        if (!faces.IsNear(ids, number))
        {
          return;
        }
        if (isFurther)
        {
          // The first pass triangulated the face, so any three of its points may be a triangle.
          ForEachTriple(ids, number,
            [&](const Triple& triple) { faces.Count(item, triple.data(), index, false); });
          return;
        }
        whole.Visit(cell, ids, number,
          [&](const Triple& triangle, const InteriorFaces::Polygon&)
          { faces.Count(item, triangle.data(), index); });
      });
    mesh.TriangleInteriorCells.assign(mesh.Triangles.size(), -1);
  }
  faces.Visit(
    [&](std::size_t index, bool isFace, vtkIdType simplex)
    {
      isRemoved[index] = !isFace;
      if (isFace && simplex >= simplices)
      {
        mesh.TriangleInteriorCells[index] = simplex;
      }
      if (isFace && !mesh.TriangleCellIds.empty())
      {
        mesh.TriangleCellIds[index] = mesh.CellIds[simplex];
      }
    });
  if (std::find(isRemoved.begin(), isRemoved.end(), true) != isRemoved.end())
  {
    RemoveTriangles(mesh, isRemoved);
    MarkUsed(mesh);
  }
}

void ExtractionCleanup::CutBoundary(const ExtractionContext& context,
  vtkUnstructuredGrid* inputBoundary, const InteriorCellPass* whole, ExtractionMesh& mesh)
{
  vtkDataSet* const input = context.Input;
  const int corners = context.Dimension;
  const std::size_t number = mesh.Triangles.size();
  const BoundaryFaces boundary(input, inputBoundary, corners, whole);
  const vtkIdType simplices = mesh.CellIds.GetSize() > 0 ? mesh.Simplices.GetNumber() : 0;
  vtkIdType last = -1;
  vtkNew<vtkIdList> ids;
  int sides[4];
  bool hasFace = false;
  for (vtkIdType simplex = 0; simplex < simplices; ++simplex)
  {
    // The simplices of a cell are consecutive.
    const vtkIdType cell = mesh.CellIds[simplex];
    if (cell != last)
    {
      last = cell;
      input->GetCellPoints(cell, ids);
      hasFace = boundary.FindSides(mesh.ItemIds->GetValue(simplex), ids->GetPointer(0), sides);
    }
    if (hasFace)
    {
      AddFaces(mesh, simplex, ids->GetPointer(0), sides, corners);
    }
  }
  const bool hasInterior = whole && !whole->TriangleInteriorCells.empty();
  if (hasInterior || !mesh.TriangleInteriorCells.empty())
  {
    mesh.TriangleInteriorCells.resize(mesh.Triangles.size(), -1);
  }
  if (hasInterior)
  {
    CopyInteriorBoundary(input, inputBoundary, *whole, mesh);
  }
  if (number > 0 && !mesh.TiedTriangles.empty())
  {
    RemoveCoincident(mesh, number, corners);
  }
}

}
