// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMesh_h
#define ReferenceMesh_h

#include "vtkSmartPointer.h" // for the meshes
#include "vtkType.h"         // for vtkIdType

#include <array>  // for the dimensions
#include <string> // for the names
#include <vector> // for lists of kinds

class vtkUnstructuredGrid;

/**
 * Meshes for tests, built without the code under test. Every mesh is conforming: two cells are
 * disjoint or share a complete face, an edge or a point. Cells are convex with planar faces, and
 * their points have VTK's order, so every volume is positive.
 */
namespace reference
{

/// Kind of cells of a mesh.
enum class MeshKind
{
  Hexahedra,    ///< one hexahedron per box
  Voxels,       ///< one voxel per box
  Wedges,       ///< two wedges per box
  Pyramids,     ///< six pyramids per box with the apex in its center
  Tetrahedra5,  ///< five tetrahedra per box, mirrored in every other box
  Tetrahedra6,  ///< six tetrahedra per box around its main diagonal
  Tetrahedra12, ///< twelve tetrahedra per box around its center
  Boxes,        ///< one VTK_POLYHEDRON with six faces per box
  Mixed,        ///< random hexahedra, wedges, pyramids, tetrahedra and polyhedra
  Honeycomb,    ///< hexagonal prisms as VTK_POLYHEDRON
  Kelvin        ///< truncated octahedra as VTK_POLYHEDRON
};

/// Return all kinds, and the kinds that consist of tetrahedra.
const std::vector<MeshKind>& AllMeshKinds();
const std::vector<MeshKind>& TetrahedralMeshKinds();
std::string GetName(MeshKind kind);

/**
 * Returns a mesh of \a kind with cells[0] x cells[1] x cells[2] boxes, which fill the block [0,
 * cells[0]] x [0, cells[1]] x [0, cells[2]]. For Honeycomb, \a cells is the number of prisms along
 * each axis. For Kelvin, it is the number of lattice cubes along each axis, with two octahedra
 * each. Only the mixed mesh uses \a seed.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(
  MeshKind kind, const std::array<int, 3>& cells, unsigned int seed = 1);

/// Returns the point ids of box (i, j, k) in a grid of \a cells boxes, in the order of
/// VTK_HEXAHEDRON.
std::array<vtkIdType, 8> BoxCorners(const std::array<int, 3>& cells, int i, int j, int k);

}

#endif
