// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTransform_h
#define ReferenceTransform_h

#include "vtkSmartPointer.h" // for the meshes

class vtkUnstructuredGrid;

/**
 * Changes of a mesh that an extraction must not mind. Each gives a new mesh; point and cell data
 * are not carried.
 */
namespace reference
{

/// The same cells, each with its points in an order given by a random rotation of its type. Voxels,
/// which have one order only, stay as they are.
vtkSmartPointer<vtkUnstructuredGrid> TurnCells(vtkUnstructuredGrid* mesh, unsigned int seed);

/// The same cells, each mirrored: the points in an order that makes its volume negative.
/// Voxels, and polyhedra, whose faces say their side, stay as they are.
vtkSmartPointer<vtkUnstructuredGrid> InvertCells(vtkUnstructuredGrid* mesh);

/// The same cells over points numbered at random.
vtkSmartPointer<vtkUnstructuredGrid> RenumberPoints(vtkUnstructuredGrid* mesh, unsigned int seed);

/// The mesh under a random projective map: planes stay planes and convex cells stay convex.
vtkSmartPointer<vtkUnstructuredGrid> MapProjectively(vtkUnstructuredGrid* mesh, unsigned int seed);

}

#endif
