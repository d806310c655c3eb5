// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankMeshes_h
#define RankMeshes_h

#include "Support/Meshes/ReferenceMesh.h"
#include "Streams/CurvedGridSource.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>

class vtkAlgorithm;
class vtkUnstructuredGrid;

/**
 * Analytic flows on unstructured grids, of which sources give pieces.
 */
namespace RankMeshes
{
/// Returns a mesh of boxes filled with cells, formed as a curved grid is, with a field of
/// vtkAnalyticFlowSource and coordinates of a type.
vtkSmartPointer<vtkUnstructuredGrid> Make(reference::MeshKind kind, const std::array<int, 3>& cells,
  CurvedGridSource::Shape shape, int field, int type = VTK_DOUBLE);

/// Puts the cells in a random order, so that pieces lie within each other.
void Shuffle(vtkUnstructuredGrid* mesh);

/// Hides some cells and some points.
void Hide(vtkUnstructuredGrid* mesh);

/// Returns a source of the mesh, which gives its cells in pieces, and ghost cells around them where
/// they are asked for.
vtkAlgorithm* MakeSource(vtkUnstructuredGrid* mesh);

/// Returns a piece, with ghost cells around it, as that source gives it.
vtkSmartPointer<vtkUnstructuredGrid> MakePiece(
  vtkUnstructuredGrid* mesh, int piece, int pieces, int ghostLevels);

/// A function that gives a piece of several; one piece is the whole.
using GetPiece = std::function<vtkSmartPointer<vtkUnstructuredGrid>(int piece, int pieces)>;
/// Returns a source of whatever pieces.
vtkAlgorithm* MakeSource(const GetPiece& getPiece);

/// Returns a source of blocks, each a part of the mesh with vectors of its own, and a flat one:
/// piece after piece has as many. \a hasOwnArrays: those of the first half have an array more.
vtkAlgorithm* MakeBlockSource(vtkUnstructuredGrid* mesh, int blocks, bool hasOwnArrays = false);
}

#endif
