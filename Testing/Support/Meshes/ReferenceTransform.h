// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTransform_h
#define ReferenceTransform_h

#include "vtkSmartPointer.h" // for the meshes

class vtkUnstructuredGrid;

/**
 * Modifications of a mesh that must not affect the result of an extraction. Each function returns a
 * new mesh without point and cell data.
 */
namespace reference
{

/// Applies a random rotation to the order of the points of each cell. Shuffles the faces of
/// polyhedra. Voxels remain unchanged, since their points have only one valid order.
vtkSmartPointer<vtkUnstructuredGrid> RotateCellPointOrder(
  vtkUnstructuredGrid* mesh, unsigned int seed);

/// Mirrors the order of the points of each cell, so that its volume becomes negative. Voxels remain
/// unchanged, and so do polyhedra, whose orientation is defined by their faces.
vtkSmartPointer<vtkUnstructuredGrid> InvertCells(vtkUnstructuredGrid* mesh);

/// Renumbers the points at random.
vtkSmartPointer<vtkUnstructuredGrid> RenumberPoints(vtkUnstructuredGrid* mesh, unsigned int seed);

/// Applies a random projective map, which preserves planes and convex cells.
vtkSmartPointer<vtkUnstructuredGrid> MapProjectively(vtkUnstructuredGrid* mesh, unsigned int seed);

}

#endif
