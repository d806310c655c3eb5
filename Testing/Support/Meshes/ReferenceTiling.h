// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTiling_h
#define ReferenceTiling_h

#include "vtkSmartPointer.h" // for the meshes

#include <array> // for the dimensions

class vtkUnstructuredGrid;

namespace reference
{

/// Hexagonal prisms as VTK_POLYHEDRON: cells[0] x cells[1] of them in a layer, cells[2] layers.
vtkSmartPointer<vtkUnstructuredGrid> MakeHoneycomb(const std::array<int, 3>& cells);

/// Truncated octahedra as VTK_POLYHEDRON around the points of a body-centred cubic lattice.
vtkSmartPointer<vtkUnstructuredGrid> MakeKelvinTiling(const std::array<int, 3>& cells);

}

#endif
