// SPDX-License-Identifier: BSD-3-Clause
// Number of simplices of every interval table that is small enough to fill, compared with the
// numbers stated in the publication of the method, and hulls with known facets.

#include "vtkIsotable.h"
#include "Hulls/ConvexHull.h"
#include "Cases/CasePatch.h"
#include "Hulls/Polytope.h"
#include "Benchmarks/Tables/FacetTriangulation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

using namespace interlume;

namespace
{
int Failures = 0;

void Expect(bool holds, const std::string& what)
{
  if (!holds)
  {
    std::cerr << "Failed: " << what << "\n";
    ++Failures;
  }
}

struct Sum
{
  long Simplices = 0;
  int Maximum = 0;
};

Sum CountSourceOrder(const Polytope& cell)
{
  const Polytope lifted = cell.Prism();
  const int n = static_cast<int>(cell.Vertices.size());
  std::vector<int> ranks(lifted.Edges.size());
  std::iota(ranks.begin(), ranks.end(), 0);
  int cases = 1;
  for (int v = 0; v < n; ++v)
  {
    cases *= 3;
  }
  Sum sum;
  for (int key = 0; key < cases; ++key)
  {
    const int number = static_cast<int>(FacetTriangulation::Triangulate(
      CasePatch(lifted, CasePatch::GetSigns(n, true, static_cast<std::uint32_t>(key))),
      FacetTriangulation::PLACING, ranks)
                                          .size());
    sum.Simplices += number;
    sum.Maximum = std::max(sum.Maximum, number);
  }
  return sum;
}

void TestSourceOrder()
{
  struct Stated
  {
    const char* Name;
    Polytope Cell;
    long Simplices;
    int Maximum;
  };
  const Stated stated[] = { { "tetrahedron", Polytope::Simplex(3), 321, 6 },
    { "4-simplex", Polytope::Simplex(4), 2031, 14 },
    { "5-simplex", Polytope::Simplex(5), 12593, 30 },
    { "hexahedron", Polytope::Cube(3), 79344, 22 } };
  for (const Stated& row : stated)
  {
    const Sum sum = CountSourceOrder(row.Cell);
    Expect(sum.Simplices == row.Simplices && sum.Maximum == row.Maximum,
      std::string(row.Name) + " in the publication's order: " + std::to_string(sum.Simplices) +
        " simplices, at most " + std::to_string(sum.Maximum));
  }
}

void TestShipped()
{
  const struct
  {
    vtkIsotable::Shapes Shape;
    long Source;
    int Maximum;
  } rows[] = { { vtkIsotable::TETRAHEDRON, 321, 6 }, { vtkIsotable::PYRAMID, 1676, 12 },
    { vtkIsotable::WEDGE, 5685, 12 }, { vtkIsotable::HEXAHEDRON, 79344, 22 } };
  for (const auto& row : rows)
  {
    const vtkIsotable& table = vtkIsotable::Get(vtkIsotable::INTERVAL, row.Shape);
    Sum sum;
    for (int key = 0; key < table.GetNumberOfCases(); ++key)
    {
      const int number = static_cast<int>(table.GetCase(key).Simplices.size());
      sum.Simplices += number;
      sum.Maximum = std::max(sum.Maximum, number);
    }
    Expect(sum.Simplices <= row.Source && sum.Maximum <= row.Maximum,
      "the shipped table has no more simplices than the publication's, shape " +
        std::to_string(row.Shape) + ": " + std::to_string(sum.Simplices));
    Expect(table.GetNumberOfCasesMade() == table.GetNumberOfCases(), "every case was built");
  }
}

// Returns a hash of all cases, in the order of the table.
std::uint64_t Digest(const vtkIsotable& table)
{
  std::uint64_t digest = 1469598103934665603u;
  const auto add = [&digest](int number)
  { digest = (digest ^ static_cast<std::uint64_t>(number)) * 1099511628211u; };
  const auto addAll = [&add](const auto& list)
  {
    add(static_cast<int>(list.size()));
    for (const auto& number : list)
    {
      add(number);
    }
  };
  for (int key = 0; key < table.GetNumberOfCases(); ++key)
  {
    const vtkIsotable::Case& found = table.GetCase(key);
    for (const auto& simplex : found.Simplices)
    {
      addAll(simplex);
    }
    for (const auto& triangle : found.Boundary)
    {
      addAll(triangle);
    }
    addAll(found.Slots);
    addAll(found.Pieces);
  }
  return digest;
}

// The tables equal tables built from the convex hull of each case, including the order of
// simplices, which determines the order of the filters' output cells.
void TestDigests()
{
  const struct
  {
    vtkIsotable::Shapes Shape;
    std::uint64_t Digest;
  } rows[] = { { vtkIsotable::TETRAHEDRON, 3372890980895510939u },
    { vtkIsotable::PYRAMID, 13253621040149989064u }, { vtkIsotable::WEDGE, 10730056720040087469u },
    { vtkIsotable::HEXAHEDRON, 11355392010007118911u } };
  for (const auto& row : rows)
  {
    const std::uint64_t digest = Digest(vtkIsotable::Get(vtkIsotable::INTERVAL, row.Shape));
    Expect(digest == row.Digest,
      "the interval table of shape " + std::to_string(row.Shape) +
        " equals the table built from hulls: " + std::to_string(digest));
  }
}

void TestHulls()
{
  // The facets of the 24-cell are 24 octahedra.
  std::vector<Polytope::Point> points;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = a + 1; b < 4; ++b)
    {
      for (int signs = 0; signs < 4; ++signs)
      {
        Polytope::Point p{};
        p[a] = (signs & 1) ? 2 : -2;
        p[b] = (signs & 2) ? 2 : -2;
        points.push_back(p);
      }
    }
  }
  const ConvexHull cell24(4, points);
  Expect(cell24.GetFacets().size() == 24, "24-cell: 24 facets");
  for (const auto& facet : cell24.GetFacets())
  {
    Expect(facet.Points.Count() == 6 && cell24.GetFacetsOfFace(facet.Points).size() == 8,
      "24-cell: octahedra");
  }
  const Polytope polytope = Polytope::FromVertices(4, points);
  Expect(polytope.Edges.size() == 96, "24-cell: 96 edges");
  Expect(Polytope::Cube(5).Edges.size() == 80, "5-cube: 80 edges");
  Expect(Polytope::Pyramid().Edges.size() == 8, "pyramid: 8 edges");
  Expect(Polytope::FromVertices(3, { { { 1, 0, 0 } } }).Vertices.empty(),
    "an odd coordinate is rejected");
  Expect(Polytope::FromVertices(
           2, { { { 0, 0 } }, { { 4, 0 } }, { { 0, 4 } }, { { 4, 4 } }, { { 2, 2 } } })
           .Vertices.empty(),
    "an interior point is rejected");
}

// Tests tables of cells that are defined by a list of vertices.
void TestVertices()
{
  using Vertices = std::vector<std::array<int, 3>>;
  const Vertices octahedron{ { { 2, 0, 0 } }, { { -2, 0, 0 } }, { { 0, 2, 0 } }, { { 0, -2, 0 } },
    { { 0, 0, 2 } }, { { 0, 0, -2 } } };
  const vtkIsotable table(vtkIsotable::INTERVAL, octahedron);
  Expect(table.GetNumberOfVertices() == 6 && table.GetNumberOfEdges() == 12 &&
      table.GetNumberOfCases() == 729,
    "octahedron: 6 vertices, 12 edges, 729 cases");
  Expect(
    table.GetCase(364).Simplices.size() == 4, "octahedron with all vertices inside: 4 tetrahedra");
  const vtkIsotable contour(vtkIsotable::CONTOUR, octahedron);
  Expect(contour.GetCase(1).Simplices.size() == 2, "octahedron with one vertex above: a square");
  Vertices cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.push_back({ { 2 * (i & 1), i & 2, (i & 4) / 2 } });
  }
  Expect(vtkIsotable(vtkIsotable::INTERVAL, cube).GetNumberOfCases() == 6561, "cube: 6561 cases");
  cube.push_back({ { 4, 4, 4 } });
  Expect(
    vtkIsotable(vtkIsotable::CONTOUR, cube).GetNumberOfCases() == 0, "nine points are rejected");
  Expect(vtkIsotable(vtkIsotable::CONTOUR, Vertices{ { { 1, 0, 0 } } }).GetNumberOfCases() == 0,
    "an odd coordinate is rejected");
}
}

int TestIsotableTables(int, char*[])
{
  TestSourceOrder();
  TestShipped();
  TestDigests();
  TestHulls();
  TestVertices();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
