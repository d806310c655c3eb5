// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Meshers_h
#define interlume_Meshers_h

#include "Common/Error.h"

namespace interlume
{

struct MeshingJob;

/**
 * The three ways to a mesh. Each fills the job's mesh, or returns an error.
 */
namespace Meshers
{
/// Decomposes the three-dimensional cells of a dataset into tetrahedra that fit together. A face is
/// cut by FaceTriangulation, in the order of the point data's global ids if there are some and of
/// the point ids otherwise, so that cells on both sides have the same triangles.
Error MeshCells(MeshingJob& job);

/// Makes the Delaunay tetrahedra of a set of points, refined if a bound is set. A point that
/// refinement adds has the values of the linear interpolation in the Delaunay tetrahedron of the
/// input's points that it lies in.
Error MeshPoints(MeshingJob& job);

/// Fills closed surfaces with tetrahedra.
Error MeshSurface(MeshingJob& job);
}

}

#endif
