// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/WholeFaces.h"

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
using Face = std::pair<WholeFaces::Triangle, vtkIdType>;

// Returns whether four of the points are farther from a plane than rounding takes them.
template <typename T>
bool IsWarped(const T* points, const WholeFaces::Polygon& polygon)
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
  // Only faces of which three points are also those of tetrahedra come into question: where values
  // equal a bound, there may be a tetrahedron at one of a face's triangles and none at the other.
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
  const auto mayMeet = [&](const WholeFaces::Polygon& polygon)
  {
    return polygon[3] >= 0 && std::count_if(polygon.begin(), polygon.end(), isNear) >= 3 &&
      IsWarped(points, polygon);
  };
  const WholeFaces whole(context, mesh);
  ThreadLocals<std::vector<Face>> found;
  cells.ForEachWhole(
    [&](vtkIdType cell, const vtkIdType* ids, int number)
    {
      if (std::count_if(ids, ids + number, isNear) < 3 ||
        !whole.HasFace(cell, ids, number, mayMeet))
      {
        return;
      }
      std::vector<Face>& list = found.Local();
      WholeFaces::Polygon last{};
      bool mayCount = false;
      whole.Visit(cell, ids, number,
        [&](const WholeFaces::Triangle& triangle, const WholeFaces::Polygon& polygon)
        {
          if (polygon != last)
          {
            mayCount = mayMeet(polygon);
            last = polygon;
          }
          if (mayCount)
          {
            // Turned as the tetrahedron's beyond is.
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
  // Each has a place of its own: of two whole cells that meet only theirs go. A face's two
  // triangles follow each other.
  std::size_t place = 0;
  for (const std::vector<Face>& list : found)
  {
    for (const Face& face : list)
    {
      faces.Add(face.second, face.first.data(), place++);
    }
  }
  faces.Cancel([](std::size_t) {});
  ExtractionCleanup::CountFaces(mesh, faces);
  std::vector<bool> isMet(place / 2, false);
  faces.Visit(
    [&isMet](std::size_t at, bool isFace, vtkIdType) { isMet[at / 2] = isMet[at / 2] || isFace; });
  return std::count(isMet.begin(), isMet.end(), true);
}
}

vtkIdType WholeFaces::CountWarped(
  const ExtractionContext& context, const ExtractionMesh& mesh, vtkPoints* points)
{
  if (!vtkPointSet::SafeDownCast(context.Input) || mesh.Simplices.GetNumberOfWhole() == 0 ||
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
