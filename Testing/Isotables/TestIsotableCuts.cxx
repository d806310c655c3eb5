// SPDX-License-Identifier: BSD-3-Clause
// A case cut at run time equals the exact pulling triangulation for any vertex order. The result on
// a face depends on that face only. Threads may request the same case at the same time.

#include "Isotables/ReferenceIsotable.h"

#include "Hulls/Polytope.h"
#include "vtkIsotable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <thread>
#include <vector>

namespace
{
using Slot = vtkIsotable::Slot;
bool TestOrders(vtkIsotable::Kinds kind, vtkIsotable::Shapes shape, std::mt19937& random)
{
  const vtkIsotable& table = vtkIsotable::Get(kind, shape);
  const int size = table.GetSimplexSize();
  std::array<Slot, 8> vertexRanks;
  std::iota(vertexRanks.begin(), vertexRanks.end(), Slot(0));
  const int step = std::max(1, table.GetNumberOfCases() / 300);
  for (int key = 0; key < table.GetNumberOfCases(); key += step)
  {
    std::shuffle(vertexRanks.begin(), vertexRanks.begin() + table.GetNumberOfVertices(), random);
    const vtkIsotable::RankArray ranks = table.GetSlotRanks(vertexRanks.data());
    std::multiset<reference::OrientedSimplex> cut;
    table.Cut(
      table.GetCase(key), ranks,
      [&](const vtkIsotable::Simplex& s) {
        cut.insert(reference::Orient({ s.begin(), s.begin() + size }));
      },
      [](const vtkIsotable::Triangle&) {});
    if (cut !=
      reference::PullExactly(interlume::Polytope::FromShape(shape), kind == vtkIsotable::INTERVAL,
        static_cast<std::uint32_t>(key), { ranks.begin(), ranks.end() }))
    {
      std::cerr << "Kind " << kind << ", shape " << shape << ", case " << key
                << ": the cut is not the pulling triangulation.\n";
      return false;
    }
  }
  return true;
}

// Returns the triangles of a case on a facet of the cell. Each slot is given by its kind and its
// two vertices. Cells that share a facet must produce the same triangles there if its vertices have
// the same digits and the same order in both cells.
std::set<std::vector<std::array<int, 3>>> GetFacesOn(const vtkIsotable& table, int key,
  const vtkIsotable::RankArray& ranks, const std::set<int>& facet)
{
  const int n = table.GetNumberOfVertices();
  const int m = table.GetNumberOfEdges();
  std::map<std::vector<std::array<int, 3>>, int> count;
  table.Cut(
    table.GetCase(key), ranks,
    [&](const vtkIsotable::Simplex& s)
    {
      for (int skip = 0; skip < 4; ++skip)
      {
        std::vector<std::array<int, 3>> face;
        for (int p = 0; p < 4; ++p)
        {
          if (p == skip)
          {
            continue;
          }
          const int slot = s[p];
          const int kind = slot < n ? 0 : 1 + (slot - n) / m;
          const std::array<Slot, 2> ends =
            slot < n ? std::array<Slot, 2>{ { s[p], s[p] } } : table.GetEdge((slot - n) % m);
          if (facet.count(ends[0]) && facet.count(ends[1]))
          {
            face.push_back({ { kind, ends[0], ends[1] } });
          }
        }
        std::sort(face.begin(), face.end());
        count[face] += face.size() == 3;
      }
    },
    [](const vtkIsotable::Triangle&) {});
  std::set<std::vector<std::array<int, 3>>> faces;
  for (const auto& entry : count)
  {
    if (entry.second == 1)
    {
      // A triangle whose points are all on one isosurface bounds the interval and is not part of
      // the facet.
      const bool isSurface = entry.first[0][0] != 0 && entry.first[0][0] == entry.first[2][0];
      if (!isSurface)
      {
        faces.insert(entry.first);
      }
    }
  }
  return faces;
}

// Compares the triangles on a quadrilateral face shared by cells of three shapes. Cycle lists the
// vertices of the face in cyclic order.
bool TestSharedQuadrilateral(std::mt19937& random)
{
  struct Side
  {
    vtkIsotable::Shapes Shape;
    std::array<int, 4> Cycle;
  };
  const Side sides[] = { { vtkIsotable::HEXAHEDRON, { { 0, 1, 3, 2 } } },
    { vtkIsotable::HEXAHEDRON, { { 7, 5, 1, 3 } } }, { vtkIsotable::WEDGE, { { 0, 1, 4, 3 } } },
    { vtkIsotable::PYRAMID, { { 0, 1, 2, 3 } } } };
  for (int round = 0; round < 400; ++round)
  {
    std::array<int, 4> digits;
    std::generate(digits.begin(), digits.end(), [&random] { return random() % 3; });
    std::array<int, 4> order{ { 0, 1, 2, 3 } };
    std::shuffle(order.begin(), order.end(), random);
    std::set<std::set<std::vector<std::array<int, 2>>>> results;
    for (const Side& side : sides)
    {
      const vtkIsotable& table = vtkIsotable::Get(vtkIsotable::INTERVAL, side.Shape);
      const int n = table.GetNumberOfVertices();
      // Vertices that are not on the face have random digits and a random position in the order.
      std::vector<double> orders(n);
      std::vector<int> all(n);
      for (int v = 0; v < n; ++v)
      {
        orders[v] = random() % 1000 / 200.0 - 0.5 + 1e-4 * v;
        all[v] = random() % 3;
      }
      for (int c = 0; c < 4; ++c)
      {
        orders[side.Cycle[c]] = order[c];
        all[side.Cycle[c]] = digits[c];
      }
      Slot vertexRanks[8];
      int key = 0;
      for (int v = n - 1; v >= 0; --v)
      {
        vertexRanks[v] = static_cast<Slot>(std::count_if(
          orders.begin(), orders.end(), [&](double value) { return value < orders[v]; }));
        key = 3 * key + all[v];
      }
      const auto faces = GetFacesOn(table, key, table.GetSlotRanks(vertexRanks),
        std::set<int>(side.Cycle.begin(), side.Cycle.end()));
      // Describes triangles independently of the cell's vertex numbers, by the kind of each slot
      // and the positions of both vertices in the cycle.
      std::set<std::vector<std::array<int, 2>>> triangles;
      for (const auto& face : faces)
      {
        std::vector<std::array<int, 2>> triangle;
        for (const auto& point : face)
        {
          const auto at = [&side](int vertex)
          {
            return static_cast<int>(
              std::find(side.Cycle.begin(), side.Cycle.end(), vertex) - side.Cycle.begin());
          };
          const int a = std::min(at(point[1]), at(point[2]));
          const int b = std::max(at(point[1]), at(point[2]));
          triangle.push_back({ { point[0], 4 * a + b } });
        }
        std::sort(triangle.begin(), triangle.end());
        triangles.insert(triangle);
      }
      results.insert(triangles);
    }
    if (results.size() != 1)
    {
      std::cerr << "Round " << round << ": cells disagree on a shared quadrilateral.\n";
      return false;
    }
  }
  return true;
}

bool TestThreads()
{
  const vtkIsotable table(vtkIsotable::INTERVAL, interlume::Polytope::Wedge());
  std::vector<std::vector<const vtkIsotable::Case*>> seen(8);
  std::vector<std::thread> threads;
  for (auto& mine : seen)
  {
    threads.emplace_back(
      [&table, &mine]
      {
        for (int key = 0; key < table.GetNumberOfCases(); ++key)
        {
          mine.push_back(&table.GetCase(key));
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& mine : seen)
  {
    if (mine != seen[0])
    {
      std::cerr << "Threads received different copies of a case.\n";
      return false;
    }
  }
  return true;
}
}

int TestIsotableCuts(int, char*[])
{
  std::mt19937 random(7);
  bool passed = TestThreads() && TestSharedQuadrilateral(random);
  for (int shape = 0; shape < vtkIsotable::NUMBER_OF_SHAPES; ++shape)
  {
    for (const auto kind : { vtkIsotable::CONTOUR, vtkIsotable::INTERVAL })
    {
      passed = passed && TestOrders(kind, static_cast<vtkIsotable::Shapes>(shape), random);
    }
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
