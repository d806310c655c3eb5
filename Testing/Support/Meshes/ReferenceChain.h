// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceChain_h
#define ReferenceChain_h

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for sorting
#include <array>     // for keys
#include <vector>    // for the lists

/**
 * Counts how often oriented faces and edges are used. Tests use this to check without geometry or
 * tolerances that a mesh is conforming.
 */
namespace reference
{

/// An oriented simplex, stored as its sorted ids and the sign of the sorting permutation.
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

/// Number of uses of a simplex with each orientation.
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

/// Counts the uses of oriented simplices. The result is sorted by key.
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

/// Returns the faces of tetrahedra, oriented so that their normals point outward.
std::vector<OrientedSimplex<3>> FacesOf(const std::vector<Tetrahedron>& tetrahedra);
/// Return triangles as oriented simplices, and the oriented edges of triangles.
std::vector<OrientedSimplex<3>> ToOrientedSimplices(const std::vector<Triangle>& triangles);
std::vector<OrientedSimplex<2>> EdgesOf(const std::vector<Triangle>& triangles);

/// Returns whether the triangles around every point form one disk or half-disk. If every edge is
/// also used at most twice, the triangles are a two-manifold with boundary.
bool VerticesAreManifold(const std::vector<Triangle>& triangles);

}

#endif
