// SPDX-License-Identifier: BSD-3-Clause
#include "Order/BoundaryFaces.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <vector>

namespace interlume
{

namespace
{
using Ids = std::array<std::uint32_t, 3>;
constexpr std::uint32_t NONE = 0xffffffffu;

// Mixes a 64-bit word into a hash (first steps of the finalizer of MurmurHash3).
std::size_t Mix(std::uint64_t hash, std::uint64_t word)
{
  hash ^= word;
  hash ^= hash >> 33;
  hash *= 0xff51afd7ed558ccdull;
  hash ^= hash >> 33;
  return static_cast<std::size_t>(hash);
}

using Position = std::array<double, 3>;

struct Hash
{
  std::size_t operator()(const Ids& ids) const { return Mix(Mix(Mix(1, ids[0]), ids[1]), ids[2]); }
  std::size_t operator()(const Position& position) const
  {
    std::size_t hash = 1;
    for (double coordinate : position)
    {
      // 0 and -0 are equal, so they must have equal hashes.
      const double value = coordinate + 0.0;
      std::uint64_t word;
      std::memcpy(&word, &value, sizeof(word));
      hash = Mix(hash, word);
    }
    return hash;
  }
};

Position GetPosition(vtkDataSet* data, vtkIdType point)
{
  Position position;
  data->GetPoint(point, position.data());
  return position;
}

// Returns the grid's point id for each point of the triangles, or NONE if there is none.
std::vector<std::uint32_t> MatchPoints(vtkDataSet* triangles, vtkUnstructuredGrid* grid)
{
  const vtkIdType points = triangles->GetNumberOfPoints();
  std::vector<std::uint32_t> match(points, NONE);
  bool isSame = points == grid->GetNumberOfPoints();
  for (vtkIdType p = 0; p < points && isSame; ++p)
  {
    isSame = GetPosition(triangles, p) == GetPosition(grid, p);
    match[p] = static_cast<std::uint32_t>(p);
  }
  if (isSame)
  {
    return match;
  }
  std::unordered_map<Position, std::uint32_t, Hash> pointIds;
  pointIds.reserve(grid->GetNumberOfPoints());
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    pointIds.emplace(GetPosition(grid, p), static_cast<std::uint32_t>(p));
  }
  for (vtkIdType p = 0; p < points; ++p)
  {
    const auto found = pointIds.find(GetPosition(triangles, p));
    match[p] = found == pointIds.end() ? NONE : found->second;
  }
  return match;
}

std::vector<bool> FindUsedPoints(vtkDataSet* data)
{
  std::vector<bool> isUsed(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids)
    {
      isUsed[static_cast<std::size_t>(id)] = true;
    }
  }
  return isUsed;
}

unsigned char FindMaterial(const BoundaryFaces::Materials& materials, vtkIdType cell)
{
  const double id = materials.IsEmpty() ? 0.0 : materials.Ids->GetComponent(cell, 0);
  if (materials.IsEmpty() || !(id >= VTK_INT_MIN && id <= VTK_INT_MAX))
  {
    return 0;
  }
  const auto found = materials.Numbers.find(static_cast<int>(id));
  return found == materials.Numbers.end() ? 0 : found->second;
}

// Adds a triangle's normal, weighted by area, to the normals of its corners. Both sides are lit
// alike, so that the orientation of triangles need not be consistent.
void AddNormal(const TetrahedraMesh& mesh, const Ids& ids, TetrahedraFields& fields)
{
  const auto point = [&](int i) { return glm::make_vec3(mesh.GetPoint(ids[i])); };
  const glm::dvec3 normal = glm::cross(point(1) - point(0), point(2) - point(0));
  for (std::uint32_t id : ids)
  {
    std::array<float, 3>& sum = fields.Normals[id];
    const double sign = glm::dot(glm::dvec3(sum[0], sum[1], sum[2]), normal) < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i)
    {
      sum[i] += static_cast<float>(sign * normal[i]);
    }
  }
}
}

void BoundaryFaces::Clear(TetrahedraFields& fields)
{
  fields.Faces.clear();
  fields.FaceMaterials.clear();
  fields.Normals.clear();
  fields.TextureCoordinates.clear();
}

BoundaryFaces::Counts BoundaryFaces::Build(vtkDataSet* triangles, vtkUnstructuredGrid* grid,
  const TetrahedraMesh& mesh, const Materials& materials, TetrahedraFields& fields)
{
  Clear(fields);
  Counts counts;
  const std::size_t points = mesh.Points.size() / 3;
  const std::vector<std::uint32_t> match = MatchPoints(triangles, grid);
  vtkDataArray* normals = triangles->GetPointData()->GetNormals();
  vtkDataArray* coordinates = triangles->GetPointData()->GetTCoords();
  fields.Normals.assign(points, { { 0.0f, 0.0f, 0.0f } });
  if (coordinates)
  {
    fields.TextureCoordinates.assign(points, { { 0.0f, 0.0f } });
  }
  // Points that several appended surfaces share exist several times. Each surface uses its own.
  const std::vector<bool> isUsed = FindUsedPoints(triangles);
  for (std::size_t p = 0; p < match.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    if (match[p] == NONE || !isUsed[p])
    {
      continue;
    }
    for (int i = 0; i < 3 && normals; ++i)
    {
      fields.Normals[match[p]][i] = static_cast<float>(normals->GetComponent(id, i));
    }
    for (int i = 0; i < 2 && coordinates; ++i)
    {
      const bool has = i < coordinates->GetNumberOfComponents();
      fields.TextureCoordinates[match[p]][i] =
        has ? static_cast<float>(coordinates->GetComponent(id, i)) : 0.0f;
    }
  }

  // Triangles by their sorted corners.
  struct Triangle
  {
    unsigned char Material;
    bool IsFound;
  };
  std::unordered_map<Ids, Triangle, Hash> faces;
  std::vector<bool> isCorner(points, false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellPoints(cell, ids);
    Ids corners{ { NONE, NONE, NONE } };
    for (int i = 0; i < 3 && triangles->GetCellType(cell) == VTK_TRIANGLE; ++i)
    {
      corners[i] = match[ids->GetId(i)];
    }
    if (std::find(corners.begin(), corners.end(), NONE) != corners.end())
    {
      ++counts.Unmatched;
      continue;
    }
    if (!normals)
    {
      AddNormal(mesh, corners, fields);
    }
    for (std::uint32_t corner : corners)
    {
      isCorner[corner] = true;
    }
    std::sort(corners.begin(), corners.end());
    faces.emplace(corners, Triangle{ FindMaterial(materials, cell), false });
  }
  fields.Faces.assign(mesh.GetNumberOfTetrahedra(), 0);
  if (!materials.IsEmpty())
  {
    fields.FaceMaterials.assign(mesh.GetNumberOfTetrahedra(), { { 0, 0, 0, 0 } });
  }
  for (std::uint32_t t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
  {
    const std::uint32_t* corners = mesh.GetCorners(t);
    const int marked =
      isCorner[corners[0]] + isCorner[corners[1]] + isCorner[corners[2]] + isCorner[corners[3]];
    for (int face = 0; face < 4 && marked >= 3; ++face)
    {
      Ids key;
      for (int i = 0; i < 3; ++i)
      {
        key[i] = corners[(face + 1 + i) % 4];
      }
      std::sort(key.begin(), key.end());
      const auto found = faces.find(key);
      if (found != faces.end() && !found->second.IsFound)
      {
        found->second.IsFound = true;
        if (!materials.IsEmpty())
        {
          fields.FaceMaterials[t][face] = found->second.Material;
        }
        fields.Faces[t] = static_cast<unsigned char>(fields.Faces[t] | (1u << face));
        ++counts.Triangles;
      }
    }
  }
  counts.Unmatched += static_cast<vtkIdType>(faces.size()) - counts.Triangles;
  if (counts.Triangles == 0)
  {
    Clear(fields);
  }
  return counts;
}

}
