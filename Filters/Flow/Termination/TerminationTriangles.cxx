// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TerminationTriangles.h"

#include "Cells/MultilinearCell.h"
#include "Common/ArrayCheck.h"
#include "Common/FiniteNumbers.h"
#include "Common/Vectors.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace interlume
{

namespace
{
using Triple = std::array<std::int64_t, 3>;

struct TripleHash
{
  std::size_t operator()(const Triple& triple) const
  {
    std::uint64_t hash = 0;
    for (std::int64_t value : triple)
    {
      hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15ull;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

// Returns a name for messages, for example "cell 7 of the mesh".
std::string Name(const char* what, vtkIdType id)
{
  return std::string(what) + " " + std::to_string(id) + " of the mesh";
}

// Scales the polygon to a size of about 1, so that products of squared lengths in VTK's
// triangulation do not overflow.
void ScaleToUnitSize(vtkPolygon* polygon)
{
  double bounds[6];
  polygon->GetBounds(bounds);
  const double scale = MultilinearCell::GetScale(
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }));
  vtkPoints* points = polygon->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    vtkMath::MultiplyScalar(x, scale);
    points->SetPoint(i, x);
  }
}

Error CheckTexture(vtkPolyData* data)
{
  vtkDataArray* texture = data->GetPointData()->GetTCoords();
  if (!texture)
  {
    return "the mesh has no texture coordinates; set the active TCoords of its point data";
  }
  return ArrayCheck::FindPointError(data, texture, 2).Within("the mesh's texture coordinates, ");
}
}

Error TerminationTriangles::FindTriangles(vtkPolyData* data, std::vector<Polygon>& polygons)
{
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> cut;
  vtkIdType cellId = data->GetNumberOfVerts() + data->GetNumberOfLines();
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell, ++cellId)
    {
      vtkIdType number;
      const vtkIdType* ids;
      cells->GetCellAtId(cell, number, ids);
      for (vtkIdType i = 0; i < number; ++i)
      {
        if (ids[i] < 0 || ids[i] >= data->GetNumberOfPoints())
        {
          return Name("cell", cellId) + " refers to point " + std::to_string(ids[i]) +
            ", which does not exist";
        }
        if (!FiniteNumbers::AreFinite(data->GetPoint(ids[i]), 3))
        {
          return Name("point", ids[i]) + " is not finite";
        }
        if (!FiniteNumbers::AreFinite(data->GetPointData()->GetTCoords()->GetTuple(ids[i]), 2))
        {
          return "the texture coordinates of " + Name("point", ids[i]) + " are not finite";
        }
      }
      if (cells == data->GetStrips())
      {
        for (vtkIdType i = 0; i + 2 < number; ++i)
        {
          const vtkIdType odd = i % 2;
          polygons.push_back({ { ids[i], ids[i + 1 + odd], ids[i + 2 - odd] } });
        }
      }
      else if (number == 3)
      {
        polygons.push_back({ { ids[0], ids[1], ids[2] } });
      }
      else
      {
        polygon->Initialize(static_cast<int>(number), ids, data->GetPoints());
        ScaleToUnitSize(polygon);
        if (number < 3 || !polygon->EarCutTriangulation(cut))
        {
          ++this->NumberOfDegenerateTriangles;
          continue;
        }
        for (vtkIdType i = 0; i + 2 < cut->GetNumberOfIds(); i += 3)
        {
          polygons.push_back(
            { { ids[cut->GetId(i)], ids[cut->GetId(i + 1)], ids[cut->GetId(i + 2)] } });
        }
      }
    }
  }
  return {};
}

void TerminationTriangles::Weld(
  vtkPolyData* data, const std::vector<bool>& isUsed, double tolerance)
{
  vtkMath::UninitializeBounds(this->Bounds);
  const vtkIdType number = data->GetNumberOfPoints();
  glm::dvec3 x;
  bool isFirst = true;
  for (vtkIdType id = 0; id < number; ++id)
  {
    if (isUsed[id])
    {
      data->GetPoint(id, glm::value_ptr(x));
      for (int i = 0; i < 3; ++i)
      {
        this->Bounds[2 * i] = isFirst ? x[i] : std::min(this->Bounds[2 * i], x[i]);
        this->Bounds[2 * i + 1] = isFirst ? x[i] : std::max(this->Bounds[2 * i + 1], x[i]);
      }
      isFirst = false;
    }
  }
  const double diagonal = std::hypot(this->Bounds[1] - this->Bounds[0],
    this->Bounds[3] - this->Bounds[2], this->Bounds[5] - this->Bounds[4]);
  this->Scale = MultilinearCell::GetScale(diagonal);
  this->Diagonal = this->Scale * diagonal;
  // Vertices are binned in a grid of cells twice as wide as the reach. The vertices within reach of
  // a point are in 8 cells: the point's cell and the nearer neighbors along the axes and diagonals.
  const double reach = tolerance * this->Diagonal;
  std::unordered_map<Triple, std::vector<int>, TripleHash> grid;
  this->VertexIds.assign(number, -1);
  for (vtkIdType id = 0; id < number && reach > 0.0; ++id)
  {
    if (!isUsed[id])
    {
      continue;
    }
    data->GetPoint(id, glm::value_ptr(x));
    x *= this->Scale;
    Triple home;
    int sides[3];
    for (int i = 0; i < 3; ++i)
    {
      const double position = (x[i] - this->Scale * this->Bounds[2 * i]) / (2.0 * reach);
      home[i] = static_cast<std::int64_t>(std::floor(position));
      sides[i] = position - std::floor(position) < 0.5 ? -1 : 1;
    }
    int found = -1;
    for (int neighbor = 0; neighbor < 8; ++neighbor)
    {
      const auto cell = grid.find(Triple{ { home[0] + (neighbor & 1 ? sides[0] : 0),
        home[1] + (neighbor & 2 ? sides[1] : 0), home[2] + (neighbor & 4 ? sides[2] : 0) } });
      if (cell == grid.end())
      {
        continue;
      }
      for (int vertex : cell->second)
      {
        const bool isNear = glm::distance(x, this->Vertices[vertex]) <= reach;
        found = isNear && (found < 0 || vertex < found) ? vertex : found;
      }
    }
    if (found < 0)
    {
      found = static_cast<int>(this->Vertices.size());
      this->Vertices.push_back(x);
      this->PointIds.push_back(id);
      grid[home].push_back(found);
    }
    this->VertexIds[id] = found;
  }
}

Error TerminationTriangles::Take(vtkPolyData* data, double tolerance, const bool isPeriodic[2])
{
  *this = TerminationTriangles();
  std::vector<Polygon> polygons;
  if (Error error = CheckTexture(data).Then([&] { return this->FindTriangles(data, polygons); }))
  {
    return error;
  }
  std::vector<bool> isUsed(data->GetNumberOfPoints(), false);
  for (const Polygon& polygon : polygons)
  {
    for (vtkIdType id : polygon)
    {
      isUsed[id] = true;
    }
  }
  this->Weld(data, isUsed, tolerance);
  vtkDataArray* texture = data->GetPointData()->GetTCoords();
  for (const Polygon& polygon : polygons)
  {
    Triangle triangle;
    glm::dvec3 corners[3];
    for (int i = 0; i < 3; ++i)
    {
      triangle.Corners[i] = this->VertexIds[polygon[i]];
      if (triangle.Corners[i] < 0)
      {
        return "the mesh has no extent: all its points coincide";
      }
      corners[i] = this->Vertices[triangle.Corners[i]];
      texture->GetTuple(polygon[i], triangle.Texture[i]);
      for (int j = 0; j < 2; ++j)
      {
        const double turns = std::round(triangle.Texture[0][j] - triangle.Texture[i][j]);
        triangle.Texture[i][j] += isPeriodic[j] ? turns : 0.0;
      }
    }
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double longest = std::max({ glm::distance(corners[0], corners[1]),
      glm::distance(corners[0], corners[2]), glm::distance(corners[1], corners[2]) });
    if (!(glm::length(normal) > longest * tolerance * this->Diagonal))
    {
      ++this->NumberOfDegenerateTriangles;
      continue;
    }
    this->Triangles.push_back(triangle);
  }
  return this->Triangles.empty() ? "the mesh has no triangle with an area" : Error();
}

}
