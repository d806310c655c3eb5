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
/// splits each face based on the order of the global point ids or, if there are none, the point
/// ids. Therefore two cells that share a face have the same triangles there.
Error MeshCells(MeshingJob& job);

/// Generates the Delaunay tetrahedra of a point set, and refines them if a bound is set. Values at
/// a point that refinement adds are interpolated linearly in the unrefined Delaunay tetrahedron
/// that contains the point.
Error MeshPoints(MeshingJob& job);

/// Fills the closed surfaces formed by the polygons of a dataset with tetrahedra.
Error MeshSurface(MeshingJob& job);
}

}

#endif
