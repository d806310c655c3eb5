// SPDX-License-Identifier: BSD-3-Clause
// Tests the face adjacency of tetrahedra against a map of their faces.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/FaceAdjacency.h"

#include <algorithm>
#include <map>
#include <vector>

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

void CheckMesh(const interlume::TetrahedraMesh& mesh, const std::string& name, Check& check)
{
  check.SetContext(name);
  std::vector<std::uint32_t> twins(mesh.Corners.size(), interlume::FaceAdjacency::None);
  for (const auto& face : MapFaces(mesh))
  {
    if (face.second.size() == 2)
    {
      twins[face.second[0]] = face.second[1];
      twins[face.second[1]] = face.second[0];
    }
  }
  check.That(interlume::FaceAdjacency::FindTwins(mesh) == twins, "matching faces");
}

// Returns a closed fan of tetrahedra that share one edge.
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

// Checks that an interior face is no longer matched if a third tetrahedron uses it.
void CheckThird(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 5;
  interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
  const auto countOpen = [&mesh]()
  {
    const std::vector<std::uint32_t> twins = interlume::FaceAdjacency::FindTwins(mesh);
    return std::count(twins.begin(), twins.end(), interlume::FaceAdjacency::None);
  };
  check.SetContext("a cube of 5 x 5 x 5 cubes");
  check.Equal(countOpen(), 6 * 25 * 2, "boundary faces");
  const std::vector<std::uint32_t> twins = interlume::FaceAdjacency::FindTwins(mesh);
  const auto inner = static_cast<std::uint32_t>(
    std::find_if(twins.begin(), twins.end(),
      [](std::uint32_t twin) { return twin != interlume::FaceAdjacency::None; }) -
    twins.begin());
  for (std::uint32_t k = 0; k < 4; ++k)
  {
    mesh.Corners.push_back(k == inner % 4 ? static_cast<std::uint32_t>(mesh.Points.size() / 3)
                                          : mesh.GetCorners(inner / 4)[k]);
  }
  mesh.Points.insert(mesh.Points.end(), { 2.0, 2.0, 2.0 });
  CheckMesh(mesh, "a third tetrahedron on a face", check);
  check.Equal(countOpen(), 6 * 25 * 2 + 3 + 3, "boundary faces with the third tetrahedron");
}
}

int TestTetrahedraSortAdjacency(int, char*[])
{
  Check check;
  CheckMesh(interlume::TetrahedraMesh(), "empty", check);
  CubeMeshSettings form;
  for (const int pieces : { 5, 6 })
  {
    form.Pieces = pieces;
    form.Cubes = 14;
    const interlume::TetrahedraMesh mesh = Shuffle(MakeCubeMesh(form), 5);
    CheckMesh(mesh, std::to_string(pieces) + " tetrahedra of a cube", check);
    CheckMesh(SeparateTetrahedra(mesh), "without shared points", check);
  }
  for (const Shape& shape : GetShapes())
  {
    form.IsIn = shape.IsIn;
    CheckMesh(MakeCubeMesh(form), shape.Name, check);
  }
  CheckMesh(MakeFan(50000), "a fan", check);
  interlume::TetrahedraMesh twice = MakeFan(1000);
  twice.Corners.insert(twice.Corners.end(), twice.Corners.begin(), twice.Corners.begin() + 2000);
  CheckMesh(twice, "duplicate tetrahedra", check);
  // All tetrahedra occur three times, and most faces have the same lowest point id.
  interlume::TetrahedraMesh triple = MakeFan(50000);
  const std::vector<std::uint32_t> once = triple.Corners;
  triple.Corners.insert(triple.Corners.end(), once.begin(), once.end());
  triple.Corners.insert(triple.Corners.end(), once.begin(), once.end());
  CheckMesh(triple, "a fan three times", check);
  CheckThird(check);
  return check.Result();
}
