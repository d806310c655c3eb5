// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMesh_h
#define ReferenceMesh_h

#include "vtkSmartPointer.h" // for the meshes
#include "vtkType.h"         // for vtkIdType

#include <array>  // for the dimensions
#include <string> // for the names
#include <vector> // for the list of kinds

class vtkUnstructuredGrid;

/**
 * Meshes for the tests, made without the code under test. Every mesh is conforming: two cells meet
 * in a whole face of both, or an edge, or a point. Cells are convex with planar faces and keep
 * VTK's vertex order, so that every one has a positive volume.
 */
namespace reference
{

/// How a block of boxes is filled with cells.
enum class MeshKind
{
  Hexahedra,    ///< a hexahedron a box
  Voxels,       ///< a voxel a box
  Wedges,       ///< two wedges a box
  Pyramids,     ///< six pyramids a box, apex in its centre
  Tetrahedra5,  ///< five tetrahedra a box, mirrored in every other box
  Tetrahedra6,  ///< six tetrahedra a box around its main diagonal
  Tetrahedra12, ///< twelve tetrahedra a box around its centre
  Boxes,        ///< a VTK_POLYHEDRON with six faces a box
  Mixed,        ///< hexahedra, wedges, pyramids, tetrahedra and polyhedra at random
  Honeycomb,    ///< hexagonal prisms as VTK_POLYHEDRON
  Kelvin        ///< truncated octahedra as VTK_POLYHEDRON
};

/// Every kind, and every kind with tetrahedra only.
const std::vector<MeshKind>& AllMeshKinds();
const std::vector<MeshKind>& TetrahedralMeshKinds();
std::string GetName(MeshKind kind);

/**
 * A mesh of \a kind with cells[0] x cells[1] x cells[2] boxes (honeycomb and Kelvin: cells).
 * The boxes fill the cube [0, cells[0]] x [0, cells[1]] x [0, cells[2]]. \a seed is for the mixed
 * mesh.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(
  MeshKind kind, const std::array<int, 3>& cells, unsigned int seed = 1);

/// The corners of the box (i,j,k) of a lattice of \a cells boxes, in the order of a hexahedron.
std::array<vtkIdType, 8> BoxCorners(const std::array<int, 3>& cells, int i, int j, int k);

}

#endif
