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
 * Analytic flows on unstructured grids, and sources that divide the grids into pieces.
 */
namespace RankMeshes
{
/// Returns a mesh with the given shape, whose hexahedral \a cells are split into cells of the given
/// kind. \a field is a field of vtkAnalyticFlowSource and \a type the VTK type of the point
/// coordinates.
vtkSmartPointer<vtkUnstructuredGrid> Make(reference::MeshKind kind, const std::array<int, 3>& cells,
  CurvedGridSource::Shape shape, int field, int type = VTK_DOUBLE);

/// Shuffles the cells, so that the pieces are interleaved.
void Shuffle(vtkUnstructuredGrid* mesh);

/// Hides some cells and some points.
void Hide(vtkUnstructuredGrid* mesh);

/// Returns a source that divides the mesh into pieces and adds ghost cells if requested.
vtkAlgorithm* MakeSource(vtkUnstructuredGrid* mesh);

/// Returns a piece with ghost cells, equal to the output of MakeSource(mesh).
vtkSmartPointer<vtkUnstructuredGrid> MakePiece(
  vtkUnstructuredGrid* mesh, int piece, int pieces, int ghostLevels);

/// A function that returns a piece. A single piece is the full mesh.
using GetPiece = std::function<vtkSmartPointer<vtkUnstructuredGrid>(int piece, int pieces)>;
/// Returns a source of the given pieces.
vtkAlgorithm* MakeSource(const GetPiece& getPiece);

/// Returns a source that splits the mesh into \a blocks blocks, whose vectors have different
/// offsets, and adds a block with only a triangle. Blocks are distributed evenly among pieces. If
/// \a hasOwnArrays is true, some blocks have an additional array.
vtkAlgorithm* MakeBlockSource(vtkUnstructuredGrid* mesh, int blocks, bool hasOwnArrays = false);
}

#endif
