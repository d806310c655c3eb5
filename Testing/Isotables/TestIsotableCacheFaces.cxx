// SPDX-License-Identifier: BSD-3-Clause
// Cells that share a three-dimensional face in space and time produce the same tetrahedra on it if
// their vertices there have the same digits and the same order. This holds for any pair of cell
// shapes.

#include "Support/Checks/ReferenceCheck.h"

#include "vtkIsotable.h"
#include "SpaceTime/SpaceTimeTable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace interlume;

namespace
{

using Slot = SpaceTimeTable::Slot;
using Shapes = vtkIsotable::Shapes;

// A face of a cell. Vertices[i] is the cell vertex that is vertex i of the face.
struct Face
{
  std::string Name;
  Shapes Shape;
  std::vector<int> Vertices;
};

// Returns a list of cubic faces and a list of prismatic faces of cells extruded in time. The
// vertices of cubes are in voxel order, those of prisms triangle by triangle.
std::vector<std::vector<Face>> GetFaces()
{
  using Table = vtkIsotable;
  return {
    { { "hexahedron at the first time", Table::HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
      { "hexahedron at the second time", Table::HEXAHEDRON, { 8, 9, 10, 11, 12, 13, 14, 15 } },
      { "side of a hexahedron", Table::HEXAHEDRON, { 1, 3, 5, 7, 9, 11, 13, 15 } },
      { "rotated side of a hexahedron", Table::HEXAHEDRON, { 4, 0, 6, 2, 12, 8, 14, 10 } },
      { "top of a hexahedron", Table::HEXAHEDRON, { 4, 5, 6, 7, 12, 13, 14, 15 } },
      { "side of a wedge", Table::WEDGE, { 0, 1, 3, 4, 6, 7, 9, 10 } },
      { "base of a pyramid", Table::PYRAMID, { 0, 1, 3, 2, 5, 6, 8, 7 } } },
    { { "wedge at the first time", Table::WEDGE, { 0, 1, 2, 3, 4, 5 } },
      { "wedge at the second time", Table::WEDGE, { 6, 7, 8, 9, 10, 11 } },
      { "end of a wedge", Table::WEDGE, { 3, 4, 5, 9, 10, 11 } },
      { "side of a tetrahedron", Table::TETRAHEDRON, { 0, 3, 2, 4, 7, 6 } },
      { "side of a pyramid", Table::PYRAMID, { 1, 2, 4, 6, 7, 9 } } }
  };
}

// A point of a face, described independently of the cell: its kind (vertex, lower or upper edge
// intersection) and the two ends of its edge as face vertices.
using FacePoint = std::array<int, 3>;
using Tetrahedra = std::set<std::vector<FacePoint>>;

// Returns the tetrahedra on the face: those whose points lie on the face and that belong to exactly
// one simplex.
Tetrahedra FindTetrahedra(const SpaceTimeTable& cache, const SpaceTimeTable::Case& what,
  const SpaceTimeTable::RankArray& ranks, const Face& face)
{
  const int n = cache.GetNumberOfVertices();
  const int m = cache.GetNumberOfEdges();
  const auto find = [&face](int vertex)
  {
    return static_cast<int>(
      std::find(face.Vertices.begin(), face.Vertices.end(), vertex) - face.Vertices.begin());
  };
  const int outside = static_cast<int>(face.Vertices.size());
  std::map<std::vector<FacePoint>, int> count;
  cache.Cut(what, ranks,
    [&](const SpaceTimeTable::Simplex& simplex)
    {
      std::vector<FacePoint> points;
      for (const Slot slot : simplex)
      {
        const int kind = slot < n ? 0 : 1 + (slot - n) / m;
        const auto edge =
          kind == 0 ? std::array<Slot, 2>{ { slot, slot } } : cache.GetEdge((slot - n) % m);
        const int a = find(edge[0]);
        const int b = find(edge[1]);
        if (std::max(a, b) < outside)
        {
          points.push_back({ { kind, std::min(a, b), std::max(a, b) } });
        }
      }
      std::sort(points.begin(), points.end());
      if (points.size() == 4)
      {
        ++count[points];
      }
    });
  Tetrahedra found;
  for (const auto& entry : count)
  {
    if (entry.second == 1)
    {
      found.insert(entry.first);
    }
  }
  return found;
}

class Sharing
{
public:
  Sharing(const std::vector<Face>& faces, int seed)
    : Faces(faces)
    , Random(seed)
  {
  }

  // Compares the tetrahedra that different cells produce on the face. Returns their number.
  std::size_t Test(reference::Check& check)
  {
    const std::size_t number = this->Faces[0].Vertices.size();
    this->Digits.resize(number);
    const bool isMixed = this->Random() % 2 == 0;
    for (std::uint32_t& digit : this->Digits)
    {
      digit = isMixed || this->Random() % 4 == 0 ? this->Random() % 3 : 1;
    }
    this->Order.resize(number);
    std::iota(this->Order.begin(), this->Order.end(), 0);
    std::shuffle(this->Order.begin(), this->Order.end(), this->Random);
    const Tetrahedra expected = this->Cut(this->Faces[0]);
    for (const Face& face : this->Faces)
    {
      check.That(this->Cut(face) == expected, face.Name + " agrees with " + this->Faces[0].Name);
    }
    return expected.size();
  }

private:
  // Cuts a cell. Vertices that are not on the face have random digits and a random position in the
  // vertex order.
  Tetrahedra Cut(const Face& face)
  {
    SpaceTimeTable& cache = SpaceTimeTable::Get(face.Shape);
    const int n = cache.GetNumberOfVertices();
    std::vector<double> orders(n);
    std::vector<std::uint32_t> digits(n);
    for (int v = 0; v < n; ++v)
    {
      orders[v] = this->Random() % 1000 / 100.0 - 1.0 + 1e-4 * (v + 1);
      digits[v] = this->Random() % 3;
    }
    for (std::size_t i = 0; i < face.Vertices.size(); ++i)
    {
      orders[face.Vertices[i]] = this->Order[i];
      digits[face.Vertices[i]] = this->Digits[i];
    }
    std::vector<Slot> vertexRanks;
    std::uint32_t key = 0;
    for (int v = 0; v < n; ++v)
    {
      vertexRanks.push_back(static_cast<Slot>(std::count_if(
        orders.begin(), orders.end(), [&](double order) { return order < orders[v]; })));
      key = 3 * key + digits[n - 1 - v];
    }
    return FindTetrahedra(cache, cache.GetCase(key), cache.GetSlotRanks(vertexRanks.data()), face);
  }

  const std::vector<Face>& Faces;
  std::mt19937 Random;
  std::vector<std::uint32_t> Digits;
  std::vector<int> Order;
};

}

int TestIsotableCacheFaces(int, char*[])
{
  reference::Check check;
  for (const std::vector<Face>& faces : GetFaces())
  {
    Sharing sharing(faces, 13);
    std::size_t tetrahedra = 0;
    for (int round = 0; round < 200; ++round)
    {
      check.SetContext("round " + std::to_string(round));
      tetrahedra += sharing.Test(check);
    }
    check.That(tetrahedra > 200, "faces contain tetrahedra");
  }
  return check.Result();
}
