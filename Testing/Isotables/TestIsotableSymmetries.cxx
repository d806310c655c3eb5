// SPDX-License-Identifier: BSD-3-Clause
// Symmetries of a cell: their number, whether they are affine maps that map edges to edges, and
// whether cases that are mapped onto each other have the same origin, which is the smallest case
// key.

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "Hulls/Polytope.h"
#include "Cases/CellSymmetries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace interlume;

namespace
{

using Symmetry = CellSymmetries::Symmetry;
using Point = Polytope::Point;

struct Cell
{
  std::string Name;
  Polytope Shape;
  int Symmetries;
  int Reflections;
};

// Returns a cube with one face smaller than the opposite face. Its edge graph has more symmetries
// than the cell.
Polytope MakeFrustum()
{
  return Polytope::FromVertices(3,
    { Point{ { 0, 0, 0 } }, Point{ { 12, 0, 0 } }, Point{ { 0, 12, 0 } }, Point{ { 12, 12, 0 } },
      Point{ { 4, 4, 4 } }, Point{ { 8, 4, 4 } }, Point{ { 4, 8, 4 } }, Point{ { 8, 8, 4 } } });
}

std::vector<Cell> GetCells()
{
  return { { "tetrahedron x time", Polytope::Simplex(3).Prism(), 48, 24 },
    { "pyramid x time", Polytope::Pyramid().Prism(), 16, 8 },
    { "wedge x time", Polytope::Wedge().Prism(), 48, 24 },
    { "hexahedron x time", Polytope::Cube(3).Prism(), 384, 192 },
    { "frustum x time", MakeFrustum().Prism(), 16, 8 } };
}

// The affine map that maps the vertices of a cell to their images under a symmetry, fitted by least
// squares. The normal equations are solved by Gaussian elimination.
class AffineMap
{
public:
  AffineMap(const Polytope& cell, const Symmetry& symmetry)
    : Cell(cell)
  {
    std::array<std::array<double, 9>, 5> rows{};
    for (std::size_t v = 0; v < cell.Vertices.size(); ++v)
    {
      const auto from = Extend(cell.Vertices[v]);
      const auto to = Extend(cell.Vertices[symmetry.Slots[v]]);
      for (int i = 0; i < 5; ++i)
      {
        for (int j = 0; j < 5; ++j)
        {
          rows[i][j] += from[i] * from[j];
        }
        for (int j = 0; j < 4; ++j)
        {
          rows[i][5 + j] += from[i] * to[j];
        }
      }
    }
    this->Solve(rows);
  }

  double GetError(int v, int image) const
  {
    const auto from = Extend(this->Cell.Vertices[v]);
    double error = 0.0;
    for (int j = 0; j < 4; ++j)
    {
      double at = -this->Cell.Vertices[image][j];
      for (int i = 0; i < 5; ++i)
      {
        at += from[i] * this->Matrix[i][j];
      }
      reference::KeepLargest(error, std::abs(at));
    }
    return error;
  }

  double GetDeterminant() const
  {
    std::array<int, 4> order{ { 0, 1, 2, 3 } };
    double sum = 0.0;
    do
    {
      double product = 1.0;
      for (int i = 0; i < 4; ++i)
      {
        product *= this->Matrix[i][order[i]];
        for (int j = i + 1; j < 4; ++j)
        {
          product = order[i] > order[j] ? -product : product;
        }
      }
      sum += product;
    } while (std::next_permutation(order.begin(), order.end()));
    return sum;
  }

private:
  static std::array<double, 5> Extend(const Point& p)
  {
    return { { double(p[0]), double(p[1]), double(p[2]), double(p[3]), 1.0 } };
  }

  void Solve(std::array<std::array<double, 9>, 5>& rows)
  {
    for (const auto& [pivot, row] : reference::AllIndices(5, 5))
    {
      const double factor = row == pivot ? 0.0 : rows[row][pivot] / rows[pivot][pivot];
      for (int column = 0; column < 9; ++column)
      {
        rows[row][column] -= factor * rows[pivot][column];
      }
    }
    for (const auto& [i, j] : reference::AllIndices(5, 4))
    {
      this->Matrix[i][j] = rows[i][5 + j] / rows[i][i];
    }
  }

  const Polytope& Cell;
  std::array<std::array<double, 4>, 5> Matrix;
};

void TestMaps(const Cell& cell, reference::Check& check)
{
  const CellSymmetries symmetries(cell.Shape);
  check.Equal(symmetries.Get().size(), cell.Symmetries, "number of symmetries");
  std::set<std::vector<std::uint8_t>> distinct;
  int reflections = 0;
  for (const Symmetry& symmetry : symmetries.Get())
  {
    distinct.insert(symmetry.Slots);
    reflections += symmetry.Reverses;
    const AffineMap map(cell.Shape, symmetry);
    double error = 0.0;
    for (std::size_t v = 0; v < cell.Shape.Vertices.size(); ++v)
    {
      reference::KeepLargest(error, map.GetError(static_cast<int>(v), symmetry.Slots[v]));
    }
    check.That(error < 1e-9, "a symmetry is an affine map");
    check.Near(
      map.GetDeterminant(), symmetry.Reverses ? -1.0 : 1.0, 1e-9, "determinant of the symmetry");
  }
  check.Equal(distinct.size(), cell.Symmetries, "no symmetry is repeated");
  check.Equal(reflections, cell.Reflections, "number of reflections");
  const std::vector<std::uint8_t>& first = symmetries.Get()[0].Slots;
  check.That(std::is_sorted(first.begin(), first.end()), "the first symmetry is the identity");
}

void TestEdges(const Cell& cell, reference::Check& check)
{
  const std::size_t n = cell.Shape.Vertices.size();
  const std::size_t m = cell.Shape.Edges.size();
  const CellSymmetries symmetries(cell.Shape);
  for (const Symmetry& symmetry : symmetries.Get())
  {
    bool fits = symmetry.Slots.size() == n + 2 * m;
    for (std::size_t e = 0; fits && e < 2 * m; ++e)
    {
      const std::size_t first = e < m ? n : n + m;
      const std::size_t image = symmetry.Slots[n + e] - first;
      const auto& edge = cell.Shape.Edges[e % m];
      const std::set<int> moved{ symmetry.Slots[edge[0]], symmetry.Slots[edge[1]] };
      fits = image < m &&
        moved == std::set<int>{ cell.Shape.Edges[image][0], cell.Shape.Edges[image][1] };
    }
    check.That(fits, "edge intersections are mapped in the same way as the ends of their edges");
  }
}

void TestOrigins(const Cell& cell, reference::Check& check)
{
  const CellSymmetries symmetries(cell.Shape);
  const std::size_t n = cell.Shape.Vertices.size();
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<int> digits(n);
    std::generate(digits.begin(), digits.end(), [&random] { return random() % 3; });
    const auto move = [&](const Symmetry& symmetry)
    {
      std::vector<int> moved(n);
      for (std::size_t v = 0; v < n; ++v)
      {
        moved[symmetry.Slots[v]] = digits[v];
      }
      std::uint32_t key = 0;
      for (std::size_t v = n; v-- > 0;)
      {
        key = 3 * key + moved[v];
      }
      return key;
    };
    std::uint32_t smallest = UINT32_MAX;
    for (const Symmetry& symmetry : symmetries.Get())
    {
      smallest = std::min(smallest, move(symmetry));
    }
    const std::uint32_t key = move(symmetries.Get()[0]);
    const CellSymmetries::Origin origin = symmetries.FindRepresentative(key);
    check.Equal(origin.Key, smallest, "the origin is the smallest key");
    for (int& digit : digits)
    {
      digit = smallest % 3;
      smallest /= 3;
    }
    check.Equal(
      move(symmetries.Get()[origin.Symmetry]), key, "the symmetry maps the origin to the case");
  }
}

}

int TestIsotableSymmetries(int, char*[])
{
  reference::Check check;
  for (const Cell& cell : GetCells())
  {
    check.SetContext(cell.Name);
    TestMaps(cell, check);
    TestEdges(cell, check);
    TestOrigins(cell, check);
  }
  return check.Result();
}
