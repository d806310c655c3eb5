// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/SurfaceTriangles.h"

#include "Common/ParallelFor.h"
#include "Volumes/SimplexPoints.h"
#include "Volumes/SurfaceLevels.h"
#include "Volumes/TriangleIndex.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkIntervalVolume.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace interlume
{

namespace
{
constexpr vtkIdType NoTetrahedron = std::numeric_limits<vtkIdType>::max();

// Faces of a tetrahedron opposite each corner, counterclockwise as seen from outside.
constexpr int Faces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

int* GetIntegers(vtkDataSetAttributes* attributes, const char* name)
{
  return vtkIntArray::SafeDownCast(attributes->GetArray(name))->GetPointer(0);
}

// Returns the face of a tetrahedron opposite a corner, counterclockwise as seen from outside.
SurfaceTriangles::Triangle GetFace(const SimplexPoints& tetrahedra, vtkIdType cell, int out)
{
  return { { tetrahedra.Get(cell, Faces[out][0]), tetrahedra.Get(cell, Faces[out][1]),
    tetrahedra.Get(cell, Faces[out][2]) } };
}

// Returns whether two triangles with the same points have the same orientation.
bool IsRotation(const SurfaceTriangles::Triangle& a, const SurfaceTriangles::Triangle& b)
{
  const auto first = std::find(a.begin(), a.end(), b[0]) - a.begin();
  return a[(first + 1) % 3] == b[1];
}

// Returns the index of the first tetrahedron of each cell. Tetrahedra are sorted by cell.
std::vector<vtkIdType> FindFirsts(
  const vtkIdType* origins, vtkIdType tetrahedra, vtkIdType numberOfCells)
{
  std::vector<vtkIdType> firsts(numberOfCells + 1, 0);
  for (vtkIdType t = 0; t < tetrahedra; ++t)
  {
    ++firsts[origins[t]];
  }
  vtkIdType sum = 0;
  for (vtkIdType& first : firsts)
  {
    sum += std::exchange(first, sum);
  }
  return firsts;
}
}

void SurfaceTriangles::Take(vtkUnstructuredGrid* boundary, const SurfaceLevels& levels)
{
  const SimplexPoints simplices(boundary, 3);
  const vtkIdType number = simplices.GetNumber();
  this->Triangles.resize(number);
  this->Surfaces.resize(number);
  if (number == 0)
  {
    return;
  }
  const int* items = GetIntegers(boundary->GetCellData(), "IntervalId");
  const int* sides = GetIntegers(boundary->GetCellData(), "BoundarySide");
  for (vtkIdType t = 0; t < number; ++t)
  {
    // Boundary triangles face outward from their interval.
    const bool isUpper = sides[t] == vtkIntervalVolume::UPPER_SIDE;
    this->Triangles[t] = { { simplices.Get(t, 0), simplices.Get(t, isUpper ? 2 : 1),
      simplices.Get(t, isUpper ? 1 : 2) } };
    this->Surfaces[t] = levels.GetSurface(items[t], sides[t]);
  }
  if (levels.HasSharedSurfaces())
  {
    this->RemoveCopies(boundary->GetNumberOfPoints());
  }
}

template <typename Keep>
void SurfaceTriangles::Filter(const Keep& keep)
{
  std::size_t retained = 0;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    // A triangle is moved only to its own index or a lower one, so none is lost.
    if (keep(static_cast<vtkIdType>(t)))
    {
      this->Triangles[retained] = this->Triangles[t];
      this->Surfaces[retained] = this->Surfaces[t];
      ++retained;
    }
  }
  this->Triangles.resize(retained);
  this->Surfaces.resize(retained);
}

void SurfaceTriangles::RemoveCopies(vtkIdType numberOfPoints)
{
  const TriangleIndex index(this->Triangles, numberOfPoints);
  this->Filter(
    [&](vtkIdType t)
    {
      vtkIdType first = t;
      index.ForEach(this->Triangles[t], [&](vtkIdType same) { first = std::min(first, same); });
      return first == t;
    });
}

void SurfaceTriangles::RemoveTrianglesNotInMesh(vtkUnstructuredGrid* mesh)
{
  const std::vector<vtkIdType> owners = this->FindOwners(mesh);
  this->Filter([&](vtkIdType t) { return owners[t] >= 0; });
}

std::vector<vtkIdType> SurfaceTriangles::FindOwners(vtkUnstructuredGrid* before) const
{
  const TriangleIndex index(this->Triangles, before->GetNumberOfPoints());
  std::vector<unsigned char> isOnSurface(before->GetNumberOfPoints(), 0);
  for (const Triangle& triangle : this->Triangles)
  {
    for (const vtkIdType p : triangle)
    {
      isOnSurface[p] = 1;
    }
  }
  const SimplexPoints tetrahedra(before, 4);
  std::vector<std::atomic<vtkIdType>> owners(this->Triangles.size());
  for (std::atomic<vtkIdType>& owner : owners)
  {
    owner.store(NoTetrahedron, std::memory_order_relaxed);
  }
  const auto addFace = [&](vtkIdType cell, const Triangle& face)
  {
    index.ForEach(face,
      [&](vtkIdType t)
      {
        // The smallest owner wins, so the result does not depend on the order of the threads.
        vtkIdType owner = owners[t].load(std::memory_order_relaxed);
        while (
          cell < owner && !owners[t].compare_exchange_weak(owner, cell, std::memory_order_relaxed))
        {
        }
      });
  };
  ParallelFor(0, tetrahedra.GetNumber(),
    [&](vtkIdType cell)
    {
      int outside = 0;
      for (int corner = 0; corner < 4; ++corner)
      {
        outside += isOnSurface[tetrahedra.Get(cell, corner)] ? 0 : 1;
      }
      for (int out = 0; outside < 2 && out < 4; ++out)
      {
        if (outside == 0 || !isOnSurface[tetrahedra.Get(cell, out)])
        {
          addFace(cell, GetFace(tetrahedra, cell, out));
        }
      }
    });
  std::vector<vtkIdType> found(owners.size());
  std::transform(owners.begin(), owners.end(), found.begin(),
    [](const std::atomic<vtkIdType>& owner)
    {
      const vtkIdType cell = owner.load(std::memory_order_relaxed);
      return cell == NoTetrahedron ? -1 : cell;
    });
  return found;
}

void SurfaceTriangles::Cut(vtkUnstructuredGrid* before, vtkUnstructuredGrid* after)
{
  const vtkIdType number = static_cast<vtkIdType>(this->Triangles.size());
  if (number == 0 || after->GetNumberOfCells() == 0)
  {
    this->Triangles.clear();
    this->Surfaces.clear();
    return;
  }
  const std::vector<vtkIdType> owners = this->FindOwners(before);
  const SimplexPoints parents(before, 4);
  const SimplexPoints tetrahedra(after, 4);
  const vtkIdType* ends = GetOrigins(after->GetPointData(), "OriginPoints");
  const std::vector<vtkIdType> firsts = FindFirsts(
    GetOrigins(after->GetCellData(), "OriginCell"), tetrahedra.GetNumber(), parents.GetNumber());
  // Calls \a emit for each part of a triangle.
  const auto forEachPart = [&](vtkIdType t, auto&& emit)
  {
    const vtkIdType owner = owners[t];
    if (owner < 0)
    {
      return;
    }
    const Triangle& triangle = this->Triangles[t];
    int corner = 0;
    while (
      std::find(triangle.begin(), triangle.end(), parents.Get(owner, corner)) != triangle.end())
    {
      ++corner;
    }
    const vtkIdType out = parents.Get(owner, corner);
    const bool isOutward = IsRotation(GetFace(parents, owner, corner), triangle);
    for (vtkIdType cell = firsts[owner]; cell < firsts[owner + 1]; ++cell)
    {
      for (int face = 0; face < 4; ++face)
      {
        Triangle part = GetFace(tetrahedra, cell, face);
        // A part is on the triangle if all its points are on edges of the triangle.
        if (std::all_of(part.begin(), part.end(),
              [&](vtkIdType p) { return ends[2 * p] != out && ends[2 * p + 1] != out; }))
        {
          if (!isOutward)
          {
            std::swap(part[1], part[2]);
          }
          emit(part);
        }
      }
    }
  };
  std::vector<vtkIdType> offsets(number + 1, 0);
  ParallelFor(
    0, number, [&](vtkIdType t) { forEachPart(t, [&](const Triangle&) { ++offsets[t]; }); });
  vtkIdType sum = 0;
  for (vtkIdType& offset : offsets)
  {
    sum += std::exchange(offset, sum);
  }
  std::vector<Triangle> parts(sum);
  std::vector<int> surfaces(sum);
  ParallelFor(0, number,
    [&](vtkIdType t)
    {
      vtkIdType offset = offsets[t];
      forEachPart(t,
        [&](const Triangle& part)
        {
          parts[offset] = part;
          surfaces[offset] = this->Surfaces[t];
          ++offset;
        });
    });
  this->Triangles = std::move(parts);
  this->Surfaces = std::move(surfaces);
}

void SurfaceTriangles::Renumber(const std::vector<vtkIdType>& ids)
{
  for (Triangle& triangle : this->Triangles)
  {
    for (vtkIdType& p : triangle)
    {
      p = ids[static_cast<std::size_t>(p)];
    }
  }
}

void SurfaceTriangles::Append(const SurfaceTriangles& other)
{
  this->Triangles.insert(this->Triangles.end(), other.Triangles.begin(), other.Triangles.end());
  this->Surfaces.insert(this->Surfaces.end(), other.Surfaces.begin(), other.Surfaces.end());
}

}
