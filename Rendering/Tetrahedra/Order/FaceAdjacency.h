// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceAdjacency_h
#define interlume_FaceAdjacency_h

#include "Mesh/TetrahedraMesh.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * Finds which tetrahedra share a face.
 *
 * Faces are numbered 4 t + k: face k of tetrahedron t is opposite its corner k. Two faces are the
 * same if their three point ids are, for any coordinates. A face of more than two tetrahedra is
 * matched with none of them.
 */
namespace FaceAdjacency
{
/// Stands for no face.
constexpr std::uint32_t None = 0xffffffffu;
/// The largest number of tetrahedra whose faces 32 bits number.
constexpr std::uint32_t MaximumNumberOfTetrahedra = (1u << 30) - 1;

/// Returns for each face the same face as its other tetrahedron numbers it, or None. It depends on
/// point ids only, not on the view or on coordinates. Returns no faces for more than
/// MaximumNumberOfTetrahedra.
std::vector<std::uint32_t> FindTwins(const TetrahedraMesh& mesh);
}

}

#endif
