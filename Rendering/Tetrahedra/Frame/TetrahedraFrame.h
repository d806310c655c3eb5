#ifndef interlume_TetrahedraFrame_h
#define interlume_TetrahedraFrame_h

#include "Frame/PiecewiseLinearTransfer.h"
#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"
#include "View/TetrahedraView.h"

#include <cstdint>
#include <vector>

namespace interlume
{

class BoundaryShading;

/**
 * All that one picture is made of, for either path. What is pointed to outlives the drawing.
 */
struct TetrahedraFrame
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

  const TetrahedraMesh* Mesh = nullptr;
  const TetrahedraFields* Fields = nullptr;
  const PiecewiseLinearTransfer* Pieces = nullptr;
  TetrahedraView View;
  /// Front to back, or by layers from the highest priority down; null: as they are.
  const std::vector<std::uint32_t>* Order = nullptr;
  /// Depth of the nearest opaque surface, row by row from below; null where there is none.
  const float* Opaque = nullptr;
  /// Of the boundary triangles; null where none are drawn.
  const BoundaryShading* Surface = nullptr;
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

}

#endif
