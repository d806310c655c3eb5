// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceChain_h
#define ReferenceChain_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for sorting
#include <array>     // for keys
#include <vector>    // for the lists

/**
 * Oriented faces and edges and how often each is used: combinatorial tests of what fits together,
 * with no geometry and no tolerance.
 */
namespace reference
{

/// An oriented simplex as its sorted ids and the sign of the permutation that sorts them.
template <size_t N>
struct OrientedSimplex
{
  std::array<vtkIdType, N> Key;
  int Sign;

  explicit OrientedSimplex(const std::array<vtkIdType, N>& ids)
    : Key(ids)
    , Sign(1)
  {
    for (size_t i = 1; i < N; ++i)
    {
      for (size_t j = i; j > 0 && this->Key[j] < this->Key[j - 1]; --j)
      {
        std::swap(this->Key[j], this->Key[j - 1]);
        this->Sign = -this->Sign;
      }
    }
  }
};

/// How often a simplex is used with each orientation.
template <size_t N>
struct SimplexUse
{
  std::array<vtkIdType, N> Key;
  int Plus;
  int Minus;

  int Net() const { return this->Plus - this->Minus; }
  int Total() const { return this->Plus + this->Minus; }
  bool operator==(const SimplexUse& other) const
  {
    return this->Key == other.Key && this->Plus == other.Plus && this->Minus == other.Minus;
  }
  SimplexUse Reversed() const { return { this->Key, this->Minus, this->Plus }; }
};

using FaceUse = SimplexUse<3>;
using EdgeUse = SimplexUse<2>;

/// The uses of a list of oriented simplices, sorted by key.
template <size_t N>
std::vector<SimplexUse<N>> CountUses(std::vector<OrientedSimplex<N>> simplices)
{
  std::sort(
    simplices.begin(), simplices.end(), [](const auto& a, const auto& b) { return a.Key < b.Key; });
  std::vector<SimplexUse<N>> uses;
  for (const OrientedSimplex<N>& simplex : simplices)
  {
    if (uses.empty() || uses.back().Key != simplex.Key)
    {
      uses.push_back({ simplex.Key, 0, 0 });
    }
    ++(simplex.Sign > 0 ? uses.back().Plus : uses.back().Minus);
  }
  return uses;
}

using Triangle = std::array<vtkIdType, 3>;
using Tetrahedron = std::array<vtkIdType, 4>;

/// The oriented faces of tetrahedra, normals outward.
std::vector<OrientedSimplex<3>> FacesOf(const std::vector<Tetrahedron>& tetrahedra);
/// Triangles as oriented simplices, and their oriented edges.
std::vector<OrientedSimplex<3>> Oriented(const std::vector<Triangle>& triangles);
std::vector<OrientedSimplex<2>> EdgesOf(const std::vector<Triangle>& triangles);

/// Whether the triangles around every point form one disc or half disc: with EdgesOf used at most
/// twice each, the triangles are a two-manifold with boundary.
bool VerticesAreManifold(const std::vector<Triangle>& triangles);

}

#endif
