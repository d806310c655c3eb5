// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTiling_h
#define ReferenceTiling_h

#include "vtkSmartPointer.h" // for the meshes

#include <array> // for the dimensions

class vtkUnstructuredGrid;

namespace reference
{

/// Returns hexagonal prisms as VTK_POLYHEDRON, in cells[2] layers of cells[0] x cells[1] prisms.
vtkSmartPointer<vtkUnstructuredGrid> MakeHoneycomb(const std::array<int, 3>& cells);

/// Returns truncated octahedra as VTK_POLYHEDRON, centered at the points of a body-centered cubic
/// lattice of \a cells cubes.
vtkSmartPointer<vtkUnstructuredGrid> MakeKelvinTiling(const std::array<int, 3>& cells);

}

#endif
