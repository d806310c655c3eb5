// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTransform_h
#define ReferenceTransform_h

#include "vtkSmartPointer.h" // for the meshes

class vtkUnstructuredGrid;

/**
 * Changes of a mesh that must not affect the result of an extraction. Each returns a new mesh
 * without point and cell data.
 */
namespace reference
{

/// Reorders the points of each cell by a random rotation that its cell type allows. Voxels allow
/// only one order and remain unchanged.
vtkSmartPointer<vtkUnstructuredGrid> TurnCells(vtkUnstructuredGrid* mesh, unsigned int seed);

/// Mirrors each cell: the order of its points makes its volume negative. Voxels and polyhedra,
/// whose faces define the orientation, remain unchanged.
vtkSmartPointer<vtkUnstructuredGrid> InvertCells(vtkUnstructuredGrid* mesh);

/// Renumbers the points at random.
vtkSmartPointer<vtkUnstructuredGrid> RenumberPoints(vtkUnstructuredGrid* mesh, unsigned int seed);

/// Applies a random projective map, which preserves planes and convex cells.
vtkSmartPointer<vtkUnstructuredGrid> MapProjectively(vtkUnstructuredGrid* mesh, unsigned int seed);

}

#endif
