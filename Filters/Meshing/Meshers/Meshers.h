// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Meshers_h
#define interlume_Meshers_h

#include "Common/Error.h"

namespace interlume
{

struct MeshingJob;

/**
 * Meshers for cells, point sets and surfaces. Each fills the mesh of the job or returns an error.
 */
namespace Meshers
{
/// Decomposes the three-dimensional cells of a dataset into a conforming mesh. FaceTriangulation
/// splits each face in the order of the global point ids if they exist, otherwise of the point ids.
/// Therefore both cells that share a face have the same triangles there.
Error MeshCells(MeshingJob& job);

/// Generates the Delaunay tetrahedra of a point set, and refines them if a bound is set. The values
/// at a point added by refinement are interpolated linearly in the Delaunay tetrahedron of input
/// points that contains it.
Error MeshPoints(MeshingJob& job);

/// Fills closed surfaces with tetrahedra.
Error MeshSurface(MeshingJob& job);
}

}

#endif
