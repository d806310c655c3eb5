// SPDX-License-Identifier: BSD-3-Clause
#include "Cases/CellSymmetries.h"

#include "Hulls/IntegerAlgebra.h"

#include "Hulls/PointSet.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>

namespace interlume
{

namespace
{
using namespace IntegerAlgebra;
using Slot = CellSymmetries::Slot;
using Permutation = std::vector<int>;

// Finds the automorphisms of the vertex-edge graph by backtracking, in lexicographic order.
class Automorphisms
{
public:
  explicit Automorphisms(const Polytope& cell)
    : Number(static_cast<int>(cell.Vertices.size()))
    , Neighbors(Number)
  {
    for (const auto& edge : cell.Edges)
    {
      this->Neighbors[edge[0]].Insert(edge[1]);
      this->Neighbors[edge[1]].Insert(edge[0]);
    }
    PointSet all;
    for (int v = 0; v < this->Number; ++v)
    {
      all.Insert(v);
    }
    this->Extend(all);
  }

  std::vector<Permutation> Found;

private:
  // Tries all images of the next vertex, recursively. \a free contains the vertices that are not
  // yet used as images.
  void Extend(const PointSet& free)
  {
    const int vertex = static_cast<int>(this->Images.size());
    if (vertex == this->Number)
    {
      this->Found.push_back(this->Images);
      return;
    }
    PointSet candidates = free;
    for (int other = 0; other < vertex; ++other)
    {
      const PointSet& neighbors = this->Neighbors[this->Images[other]];
      candidates =
        this->Neighbors[vertex].Contains(other) ? candidates & neighbors : candidates - neighbors;
    }
    candidates.ForEach(
      [&](int image)
      {
        PointSet rest = free;
        rest.Remove(image);
        this->Images.push_back(image);
        this->Extend(rest);
        this->Images.pop_back();
      });
  }

  int Number;
  std::vector<PointSet> Neighbors;
  Permutation Images;
};

// Affine basis selected from the vertices of a cell, and the coefficients of each vertex in it.
class Frame
{
public:
  explicit Frame(const Polytope& cell)
    : Cell(cell)
  {
    Span span(cell.Dimension);
    Permutation identity(cell.Vertices.size());
    std::iota(identity.begin(), identity.end(), 0);
    for (int v : identity)
    {
      if (span.Insert(cell.Vertices[v]))
      {
        this->Base.push_back(v);
      }
    }
    this->Volume = this->GetVolume(identity, -1, 0);
    for (int v : identity)
    {
      std::vector<std::int64_t> weights;
      for (std::size_t i = 0; i < this->Base.size(); ++i)
      {
        weights.push_back(this->GetVolume(identity, static_cast<int>(i), v));
      }
      this->Weights.push_back(weights);
    }
  }

  bool IsReflection(const Permutation& images) const
  {
    return (this->GetVolume(images, -1, 0) < 0) != (this->Volume < 0);
  }

  bool IsAffine(const Permutation& images) const
  {
    for (std::size_t v = 0; v < images.size(); ++v)
    {
      for (int axis = 0; axis < this->Cell.Dimension; ++axis)
      {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < this->Base.size(); ++i)
        {
          sum += this->Weights[v][i] * this->Cell.Vertices[images[this->Base[i]]][axis];
        }
        if (sum != this->Volume * this->Cell.Vertices[images[v]][axis])
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  // Returns the signed volume that the images of the basis vertices span. Vertex \a v takes the
  // place of basis vertex \a replaced, unless that is -1.
  std::int64_t GetVolume(const Permutation& images, int replaced, int v) const
  {
    Normal rows[MaximumDimension];
    int columns[MaximumDimension];
    std::iota(columns, columns + MaximumDimension, 0);
    const auto get = [&](int i) -> const Point&
    { return this->Cell.Vertices[images[i == replaced ? v : this->Base[i]]]; };
    for (int i = 1; i <= this->Cell.Dimension; ++i)
    {
      rows[i - 1] = Difference(get(i), get(0));
    }
    return Determinant(rows, columns, this->Cell.Dimension);
  }

  const Polytope& Cell;
  std::vector<int> Base;
  std::int64_t Volume = 0;
  std::vector<std::vector<std::int64_t>> Weights;
};

// Lookup table for the edge between two vertices.
class EdgeTable
{
public:
  explicit EdgeTable(const Polytope& cell)
    : Number(static_cast<int>(cell.Vertices.size()))
    , Edges(Number * Number)
  {
    for (std::size_t e = 0; e < cell.Edges.size(); ++e)
    {
      const auto& edge = cell.Edges[e];
      this->Edges[edge[0] * this->Number + edge[1]] = static_cast<int>(e);
      this->Edges[edge[1] * this->Number + edge[0]] = static_cast<int>(e);
    }
  }

  int Get(int a, int b) const { return this->Edges[a * this->Number + b]; }

private:
  int Number;
  std::vector<int> Edges;
};

// Returns the image of each slot if the vertices are mapped to \a images.
std::vector<Slot> MoveSlots(const Polytope& cell, const EdgeTable& edges, const Permutation& images)
{
  const std::size_t m = cell.Edges.size();
  std::vector<Slot> slots(images.begin(), images.end());
  for (const std::size_t first : { images.size(), images.size() + m })
  {
    for (const auto& edge : cell.Edges)
    {
      slots.push_back(static_cast<Slot>(first + edges.Get(images[edge[0]], images[edge[1]])));
    }
  }
  return slots;
}
}

CellSymmetries::CellSymmetries(const Polytope& cell)
{
  const Frame frame(cell);
  const EdgeTable edges(cell);
  for (const Permutation& images : Automorphisms(cell).Found)
  {
    if (frame.IsAffine(images))
    {
      this->Symmetries.push_back({ MoveSlots(cell, edges, images), frame.IsReflection(images) });
    }
  }
  this->FillTransformedKeys(static_cast<int>(cell.Vertices.size()));
}

void CellSymmetries::FillTransformedKeys(int numberOfVertices)
{
  const std::size_t number = this->Symmetries.size();
  this->NumberOfGroups = (numberOfVertices + GroupSize - 1) / GroupSize;
  // For each vertex and symmetry: the place value of the vertex's digit after the inverse symmetry
  // has been applied to a key.
  std::vector<std::uint32_t> weights(this->NumberOfGroups * GroupSize * number, 0);
  std::uint32_t power = 1;
  for (int v = 0; v < numberOfVertices; ++v, power *= 3)
  {
    for (std::size_t s = 0; s < number; ++s)
    {
      weights[this->Symmetries[s].Slots[v] * number + s] = power;
    }
  }
  this->MovedKeys.assign(number * this->NumberOfGroups * GroupCases, 0);
  for (int group = 0; group < this->NumberOfGroups; ++group)
  {
    std::uint32_t* contributions = this->MovedKeys.data() + group * GroupCases * number;
    for (int value = 1; value < GroupCases; ++value)
    {
      // Find the lowest nonzero digit. Decrementing it gives a value that is already processed.
      int digit = group * GroupSize;
      int one = 1;
      for (; value / one % 3 == 0; one *= 3)
      {
        ++digit;
      }
      const std::uint32_t* smaller = contributions + (value - one) * number;
      std::transform(smaller, smaller + number, weights.data() + digit * number,
        contributions + value * number, std::plus<>());
    }
  }
}

CellSymmetries::Origin CellSymmetries::FindRepresentative(std::uint32_t key) const
{
  const std::size_t number = this->Symmetries.size();
  std::vector<std::uint32_t> moved(number, 0);
  for (int group = 0; group < this->NumberOfGroups; ++group, key /= GroupCases)
  {
    const std::uint32_t* contributions =
      this->MovedKeys.data() + (group * GroupCases + key % GroupCases) * number;
    for (std::size_t s = 0; s < number; ++s)
    {
      moved[s] += contributions[s];
    }
  }
  // Use two separate loops so that the compiler can vectorize them.
  std::uint32_t smallest = moved[0];
  for (const std::uint32_t other : moved)
  {
    smallest = std::min(smallest, other);
  }
  const auto first = std::find(moved.begin(), moved.end(), smallest);
  return { smallest, static_cast<int>(first - moved.begin()) };
}

}
