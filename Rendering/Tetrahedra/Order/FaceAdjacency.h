// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceAdjacency_h
#define interlume_FaceAdjacency_h

#include "Mesh/TetrahedraMesh.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * Finds the tetrahedra that share a face.
 *
 * Face 4 t + k is opposite corner k of tetrahedron t. Two faces are equal if their three point ids
 * are equal, regardless of coordinates. A face of more than two tetrahedra is not matched.
 */
namespace FaceAdjacency
{
/// No face.
constexpr std::uint32_t None = 0xffffffffu;
/// Maximum number of tetrahedra; face indices have 32 bits.
constexpr std::uint32_t MaximumNumberOfTetrahedra = (1u << 30) - 1;

/// Returns the twin of each face, which is the same face in the neighboring tetrahedron, or None.
/// The result depends only on point ids. Returns an empty array for more than
/// MaximumNumberOfTetrahedra.
std::vector<std::uint32_t> FindTwins(const TetrahedraMesh& mesh);
}

}

#endif
