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

// Returns whether four points are farther from a plane than rounding takes them.
bool IsWarped(vtkPoints* points, const WholeFaces::Polygon& polygon)
{
  glm::dvec3 x[4];
  double largest = 0.0;
  for (int v = 0; v < 4; ++v)
  {
    points->GetPoint(polygon[v], glm::value_ptr(x[v]));
    largest = std::max({ largest, std::abs(x[v].x), std::abs(x[v].y), std::abs(x[v].z) });
  }
  const glm::dvec3 normal = glm::cross(x[1] - x[0], x[2] - x[0]);
  const double rounding = points->GetDataType() == VTK_FLOAT
    ? static_cast<double>(std::numeric_limits<float>::epsilon())
    : std::numeric_limits<double>::epsilon();
  constexpr double steps = 8.0;
  return std::abs(glm::dot(normal, x[3] - x[0])) > steps * rounding * largest * glm::length(normal);
}
}

vtkIdType WholeFaces::CountWarped(
  const ExtractionContext& context, const ExtractionMesh& mesh, vtkPoints* points)
{
  const SimplexList& cells = mesh.Simplices;
  if (!vtkPointSet::SafeDownCast(context.Input) || cells.GetNumberOfWhole() == 0 ||
    cells.GetNumber() == 0)
  {
    return 0;
  }
  // Only faces of which three points are also those of tetrahedra come into question: where values
  // equal a bound, there may be a tetrahedron at one of a face's triangles and none at the other.
  ExtractionBuffer<std::atomic<unsigned char>> isCut;
  isCut.AllocateZeros(mesh.Points.GetSize());
  vtkSMPTools::For(0, cells.GetNumber() * 4,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType at = first; at < last; ++at)
      {
        isCut[cells.GetIdAt(at)].store(1, std::memory_order_relaxed);
      }
    });
  const auto isNear = [&isCut](vtkIdType id)
  { return id >= 0 && isCut[id].load(std::memory_order_relaxed) != 0; };
  const WholeFaces whole(context, mesh);
  ThreadLocals<std::vector<Face>> found;
  whole.ForEachCell(
    [&](vtkIdType cell, const vtkIdType* ids, int number)
    {
      if (std::count_if(ids, ids + number, isNear) < 3)
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
            mayCount = polygon[3] >= 0 &&
              std::count_if(polygon.begin(), polygon.end(), isNear) >= 3 &&
              IsWarped(points, polygon);
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
