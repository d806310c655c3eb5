// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceAdjacency_h
#define interlume_FaceAdjacency_h

#include "Mesh/TetrahedraMesh.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   FaceAdjacency
 * @brief   which tetrahedra share a face
 *
 * Faces are numbered 4 t + k: face k of tetrahedron t is opposite its corner k. Two faces are the
 * same where their three point ids are, whatever the coordinates. A face that more than two
 * tetrahedra have is matched with none of them, and counted. It depends on the ids alone, so it is
 * kept while the view, and even the coordinates, change.
 */
class FaceAdjacency
{
public:
  /// The number that stands for no face.
  static constexpr std::uint32_t None = 0xffffffffu;
  /// The largest number of tetrahedra whose faces 32 bits number.
  static constexpr std::uint32_t MaximumNumberOfTetrahedra = (1u << 30) - 1;

  /// Matches all faces. Returns false, and is then empty, beyond MaximumNumberOfTetrahedra.
  bool Build(const TetrahedraMesh& mesh);

  /// Returns for each face the same face as its other tetrahedron numbers it, or None.
  const std::vector<std::uint32_t>& GetTwins() const { return this->Twins; }
  /// Returns the tetrahedron beyond face \a k of \a tetrahedron, or None.
  std::uint32_t GetNeighbor(std::uint32_t tetrahedron, int k) const
  {
    const std::uint32_t twin = this->Twins[4 * static_cast<std::size_t>(tetrahedron) + k];
    return twin == None ? None : twin / 4;
  }
  /// Returns the faces without a twin, ascending.
  const std::vector<std::uint32_t>& GetBoundaryFaces() const { return this->BoundaryFaces; }
  /// Returns how many triangles more than two tetrahedra have for a face.
  std::uint32_t GetNumberOfNonManifoldFaces() const { return this->NonManifoldFaces; }

  /// Counts the pieces that are connected over faces; visits all tetrahedra.
  std::uint32_t CountComponents() const;

  /// Returns the bytes held: 16 a tetrahedron, and the boundary.
  std::size_t GetBytes() const;

private:
  void ListBoundary();

  std::vector<std::uint32_t> Twins;
  std::vector<std::uint32_t> BoundaryFaces;
  std::uint32_t NonManifoldFaces = 0;
};

}

#endif
