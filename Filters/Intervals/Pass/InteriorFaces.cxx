// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/InteriorFaces.h"

#include "Common/ThreadLocals.h"
#include "Common/Vectors.h"
#include "Output/TiedFaces.h"
#include "Pass/ExtractionCleanup.h"

#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
using Face = std::pair<InteriorFaces::Triangle, vtkIdType>;

// Returns whether four points deviate from a plane by more than rounding errors.
template <typename T>
bool IsNonPlanar(const T* points, const InteriorFaces::Polygon& polygon)
{
  glm::dvec3 x[4];
  double largest = 0.0;
  for (int v = 0; v < 4; ++v)
  {
    x[v] = glm::dvec3(glm::make_vec3(points + 3 * polygon[v]));
    largest = std::max({ largest, std::abs(x[v].x), std::abs(x[v].y), std::abs(x[v].z) });
  }
  const glm::dvec3 normal = glm::cross(x[1] - x[0], x[2] - x[0]);
  constexpr double rounding = static_cast<double>(std::numeric_limits<T>::epsilon());
  constexpr double steps = 8.0;
  return std::abs(glm::dot(normal, x[3] - x[0])) > steps * rounding * largest * glm::length(normal);
}

template <typename T>
vtkIdType Count(const ExtractionContext& context, const ExtractionMesh& mesh, const T* points)
{
  const SimplexList& cells = mesh.Simplices;
  // Consider only faces with at least three points that tetrahedra use. Three are enough because,
  // if values equal a bound, a tetrahedron may cover only one of the two triangles of a face.
  ExtractionBuffer<std::atomic<unsigned char>> isCut;
  isCut.AllocateZeros(mesh.Points.GetSize());
  cells.Visit(
    [&](const auto* ids)
    {
      vtkSMPTools::For(0, cells.GetNumber() * 4,
        [&](vtkIdType first, vtkIdType last)
        {
          std::for_each(ids + first, ids + last,
            [&isCut](vtkIdType id) { isCut[id].store(1, std::memory_order_relaxed); });
        });
    });
  const auto isNear = [&isCut](vtkIdType id)
  { return id >= 0 && isCut[id].load(std::memory_order_relaxed) != 0; };
  const auto mayMeet = [&](const InteriorFaces::Polygon& polygon)
  {
    return polygon[3] >= 0 && std::count_if(polygon.begin(), polygon.end(), isNear) >= 3 &&
      IsNonPlanar(points, polygon);
  };
  const InteriorFaces whole(context, mesh);
  ThreadLocals<std::vector<Face>> found;
  cells.ForEachInteriorCell(
    [&](vtkIdType cell, const vtkIdType* ids, int number)
    {
      if (std::count_if(ids, ids + number, isNear) < 3 ||
        !whole.HasFace(cell, ids, number, mayMeet))
      {
        return;
      }
      std::vector<Face>& list = found.Local();
      InteriorFaces::Polygon last{};
      bool mayCount = false;
      whole.Visit(cell, ids, number,
        [&](const InteriorFaces::Triangle& triangle, const InteriorFaces::Polygon& polygon)
        {
          if (polygon != last)
          {
            mayCount = mayMeet(polygon);
            last = polygon;
          }
          if (mayCount)
          {
            // Orient the triangle as in the adjacent tetrahedron.
            list.push_back({ { { triangle[1], triangle[0], triangle[2] } },
              mesh.ItemIds->GetValue(cells.GetNumber() + cell) });
          }
        });
    });
  if (std::all_of(
        found.begin(), found.end(), [](const std::vector<Face>& list) { return list.empty(); }))
  {
    return 0;
  }
  TiedFaces<3> faces(mesh.Points.GetSize());
  // Cancel() removes the triangles between two interior cells. It identifies triangles by index, so
  // each needs a unique one. The two triangles of a face are consecutive.
  std::size_t index = 0;
  for (const std::vector<Face>& list : found)
  {
    for (const Face& face : list)
    {
      faces.Add(face.second, face.first.data(), index++);
    }
  }
  faces.Cancel([](std::size_t) {});
  ExtractionCleanup::CountFaces(mesh, faces);
  std::vector<bool> isMatched(index / 2, false);
  faces.Visit([&isMatched](std::size_t at, bool isFace, vtkIdType)
    { isMatched[at / 2] = isMatched[at / 2] || isFace; });
  return std::count(isMatched.begin(), isMatched.end(), true);
}
}

vtkIdType InteriorFaces::CountNonPlanar(
  const ExtractionContext& context, const ExtractionMesh& mesh, vtkPoints* points)
{
  if (!vtkPointSet::SafeDownCast(context.Input) || mesh.Simplices.GetNumberOfInteriorCells() == 0 ||
    mesh.Simplices.GetNumber() == 0)
  {
    return 0;
  }
  const void* data = points->GetVoidPointer(0);
  return points->GetDataType() == VTK_FLOAT
    ? Count(context, mesh, static_cast<const float*>(data))
    : Count(context, mesh, static_cast<const double*>(data));
}

}
