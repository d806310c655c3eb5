// SPDX-License-Identifier: BSD-3-Clause
// The adjacency of tetrahedra, against a map of their faces.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/FaceAdjacency.h"

#include <algorithm>
#include <map>
#include <set>

namespace
{

using namespace reference;
using Ids = std::array<std::uint32_t, 3>;

std::map<Ids, std::vector<std::uint32_t>> MapFaces(const interlume::TetrahedraMesh& mesh)
{
  std::map<Ids, std::vector<std::uint32_t>> faces;
  for (std::uint32_t face = 0; face < 4 * mesh.GetNumberOfTetrahedra(); ++face)
  {
    Ids ids;
    std::size_t found = 0;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      if (k != face % 4)
      {
        ids[found++] = mesh.GetCorners(face / 4)[k];
      }
    }
    std::sort(ids.begin(), ids.end());
    faces[ids].push_back(face);
  }
  return faces;
}

// Pieces, by visiting one after the other.
std::uint32_t CountPieces(const interlume::FaceAdjacency& adjacency, std::uint32_t number)
{
  std::vector<bool> seen(number, false);
  std::uint32_t pieces = 0;
  for (std::uint32_t start = 0; start < number; ++start)
  {
    pieces += seen[start] ? 0 : 1;
    std::vector<std::uint32_t> open(1, start);
    while (!open.empty())
    {
      const std::uint32_t t = open.back();
      open.pop_back();
      if (t == interlume::FaceAdjacency::None || seen[t])
      {
        continue;
      }
      seen[t] = true;
      for (int k = 0; k < 4; ++k)
      {
        open.push_back(adjacency.GetNeighbor(t, k));
      }
    }
  }
  return pieces;
}

void CheckMesh(const interlume::TetrahedraMesh& mesh, const std::string& name, Check& check)
{
  check.SetContext(name);
  interlume::FaceAdjacency adjacency;
  check.That(adjacency.Build(mesh), "built");
  std::vector<std::uint32_t> twins(mesh.Corners.size(), interlume::FaceAdjacency::None);
  std::vector<std::uint32_t> boundary;
  std::uint32_t nonManifold = 0;
  for (const auto& face : MapFaces(mesh))
  {
    if (face.second.size() == 2)
    {
      twins[face.second[0]] = face.second[1];
      twins[face.second[1]] = face.second[0];
    }
    else
    {
      boundary.insert(boundary.end(), face.second.begin(), face.second.end());
      nonManifold += face.second.size() > 2 ? 1 : 0;
    }
  }
  std::sort(boundary.begin(), boundary.end());
  check.That(adjacency.GetTwins() == twins, "twins");
  check.That(adjacency.GetBoundaryFaces() == boundary, "boundary");
  check.Equal(adjacency.GetNumberOfNonManifoldFaces(), nonManifold, "faces used more than twice");
  check.Equal(adjacency.CountComponents(), CountPieces(adjacency, mesh.GetNumberOfTetrahedra()),
    "components");
}

// A fan of tetrahedra about one edge, and about one point that all of many have.
interlume::TetrahedraMesh MakeFan(int number)
{
  interlume::TetrahedraMesh mesh;
  mesh.Points.assign(3 * static_cast<std::size_t>(number + 2), 0.0);
  for (int i = 0; i < number; ++i)
  {
    const std::uint32_t next = i + 1 < number ? i + 3 : 2;
    mesh.Corners.insert(mesh.Corners.end(), { 0, 1, static_cast<std::uint32_t>(i + 2), next });
  }
  return mesh;
}

void CheckCounts(Check& check)
{
  CubeMesh form;
  form.Cubes = 5;
  interlume::TetrahedraMesh mesh = MakeCubes(form);
  interlume::FaceAdjacency adjacency;
  adjacency.Build(mesh);
  check.SetContext("a cube of 5 x 5 x 5 cubes");
  check.Equal(adjacency.GetBoundaryFaces().size(), 6 * 25 * 2, "boundary faces");
  check.Equal(adjacency.CountComponents(), 1, "components");

  // A third tetrahedron on an inner face takes that face's match away.
  const std::uint32_t inner = static_cast<std::uint32_t>(
    std::find_if(adjacency.GetTwins().begin(), adjacency.GetTwins().end(),
      [](std::uint32_t twin) { return twin != interlume::FaceAdjacency::None; }) -
    adjacency.GetTwins().begin());
  for (std::uint32_t k = 0; k < 4; ++k)
  {
    mesh.Corners.push_back(k == inner % 4 ? static_cast<std::uint32_t>(mesh.Points.size() / 3)
                                          : mesh.GetCorners(inner / 4)[k]);
  }
  mesh.Points.insert(mesh.Points.end(), { 2.0, 2.0, 2.0 });
  CheckMesh(mesh, "a third tetrahedron on a face", check);
  adjacency.Build(mesh);
  check.Equal(adjacency.GetNumberOfNonManifoldFaces(), 1, "faces used three times");
  check.Equal(adjacency.GetBoundaryFaces().size(), 6 * 25 * 2 + 3 + 3, "boundary faces then");
  check.Equal(adjacency.CountComponents(), 2, "components then");
}
}

int TestTetrahedraSortAdjacency(int, char*[])
{
  Check check;
  CheckMesh(interlume::TetrahedraMesh(), "empty", check);
  CubeMesh form;
  for (const int pieces : { 5, 6 })
  {
    form.Pieces = pieces;
    form.Cubes = 14;
    const interlume::TetrahedraMesh mesh = Shuffle(MakeCubes(form), 5);
    CheckMesh(mesh, std::to_string(pieces) + " tetrahedra of a cube", check);
    CheckMesh(Separate(mesh), "without shared points", check);
  }
  for (const Shape& shape : GetShapes())
  {
    form.IsIn = shape.IsIn;
    CheckMesh(MakeCubes(form), shape.Name, check);
  }
  CheckMesh(MakeFan(50000), "a fan", check);
  interlume::TetrahedraMesh twice = MakeFan(1000);
  twice.Corners.insert(twice.Corners.end(), twice.Corners.begin(), twice.Corners.begin() + 2000);
  CheckMesh(twice, "tetrahedra that are there twice", check);
  // Many faces of one lowest id, each three times.
  interlume::TetrahedraMesh thrice = MakeFan(50000);
  const std::vector<std::uint32_t> once = thrice.Corners;
  thrice.Corners.insert(thrice.Corners.end(), once.begin(), once.end());
  thrice.Corners.insert(thrice.Corners.end(), once.begin(), once.end());
  CheckMesh(thrice, "a fan three times", check);
  CheckCounts(check);
  return check.Result();
}
