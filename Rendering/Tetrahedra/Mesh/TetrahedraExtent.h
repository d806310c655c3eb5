// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraExtent_h
#define interlume_TetrahedraExtent_h

namespace interlume
{

struct TetrahedraMesh;

/**
 * Computes how far a mesh reaches.
 */
namespace TetrahedraExtent
{
/// Returns the greatest distance of a point from the origin of the mesh's coordinates; 0 without
/// points.
double GetRadius(const TetrahedraMesh& mesh);
}

}

#endif
