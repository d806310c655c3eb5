#ifndef vtkTetrahedraPicture_h
#define vtkTetrahedraPicture_h

#include "vtkTetrahedraFields.h"
#include "vtkTetrahedraMesh.h"
#include "vtkTetrahedraView.h"
#include "vtkTransferPieces.h"

#include <cstdint>
#include <vector>

class vtkBoundaryShading;

/**
 * All that one picture is made of, for either path. What is pointed to outlives the drawing.
 */
struct vtkTetrahedraPicture
{
  enum Blends
  {
    COMPOSITE,
    MAXIMUM,
    ADDITIVE,
    PRIORITY,
    OPTICAL_DEPTH,
    /// The input's cell that is first on each line of sight.
    SELECTION
  };

  const vtkTetrahedraMesh* Mesh = nullptr;
  const vtkTetrahedraFields* Fields = nullptr;
  const vtkTransferPieces* Pieces = nullptr;
  vtkTetrahedraView View;
  /// Front to back, or by layers from the highest priority down; null: as they are.
  const std::vector<std::uint32_t>* Order = nullptr;
  /// Depth of the nearest opaque surface, row by row from below; null where there is none.
  const float* Opaque = nullptr;
  /// Of the boundary triangles; null where none are drawn.
  const vtkBoundaryShading* Surface = nullptr;
  Blends Blend = COMPOSITE;
  /// Extinction of opacity 1, so that MAXIMUM can undo what extinction was made by.
  double ExtinctionUnit = 1.0;
  bool IsExact = true;
  /// Pixels of the viewport along an edge of one of the picture.
  int PixelStride = 1;
  /// One of how many tetrahedra is drawn, and stands for them.
  std::uint32_t TetrahedronStride = 1;

  /// Whether a tetrahedron is among those drawn.
  bool IsDrawn(std::uint32_t tetrahedron) const
  {
    // Knuth's multiplicative hash: no pattern in space.
    return this->TetrahedronStride == 1 ||
      ((tetrahedron * 2654435761u) >> 8) % this->TetrahedronStride == 0;
  }
};

#endif
