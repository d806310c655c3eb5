// SPDX-License-Identifier: BSD-3-Clause
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
 * The data that one picture is made of, for either path. Pointers stay valid until it is drawn.
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

  /// The number of changes of each part, from which a window knows what it has to upload or to draw
  /// again.
  struct Changes
  {
    int Mesh = 0;
    int Values = 0;
    int Colors = 0;
    int Order = 0;
    int Surface = 0;
    /// The surface without its lights, which are no upload.
    int Boundary = 0;

    bool operator==(const Changes& other) const
    {
      return this->Mesh == other.Mesh && this->Values == other.Values &&
        this->Colors == other.Colors && this->Order == other.Order &&
        this->Surface == other.Surface && this->Boundary == other.Boundary;
    }
  };

  Changes Versions;
  const TetrahedraMesh* Mesh = nullptr;
  const TetrahedraFields* Fields = nullptr;
  const PiecewiseLinearTransfer* Pieces = nullptr;
  TetrahedraView View;
  /// The planes that cut off points of the mesh, in its coordinates. Equal planes append the same
  /// parts to the same mesh.
  std::vector<glm::dvec4> Planes;
  /// The order: front to back, or by layers from the highest priority down; null for tetrahedra as
  /// they are.
  const std::vector<std::uint32_t>* Order = nullptr;
  /// The depth of the nearest opaque surface, row by row from below; null where there is none.
  const float* Opaque = nullptr;
  /// The shading of the boundary triangles; null where none are drawn.
  const BoundaryShading* Surface = nullptr;
  Blends Blend = COMPOSITE;
  /// Whether the picture is what the blend mode sums up, or keeps the largest of, and no colours
  /// yet.
  bool IsSum = false;
  /// The extinction of opacity 1, so that MAXIMUM can undo what extinction was made by.
  double ExtinctionUnit = 1.0;
  bool IsExact = true;
  /// Whether the vertices of silhouettes are pulled, with OpenGL, instead of made by a geometry
  /// shader.
  bool IsPulled = false;
  /// The number of pixels of the viewport along an edge of one of the picture.
  int PixelStride = 1;
  /// The number of tetrahedra of which one is drawn, and stands for them.
  std::uint32_t TetrahedronStride = 1;

  /// Returns whether the same depth of opaque surfaces gives the same image.
  bool HasSameImage(const TetrahedraFrame& other) const
  {
    return this->Versions == other.Versions && this->View == other.View &&
      this->Planes == other.Planes && this->Blend == other.Blend &&
      this->IsExact == other.IsExact && this->PixelStride == other.PixelStride &&
      this->TetrahedronStride == other.TetrahedronStride;
  }

  /// Returns whether a tetrahedron is among those drawn.
  bool IsDrawn(std::uint32_t tetrahedron) const
  {
    // Knuth's multiplicative hash has no pattern in space.
    return this->TetrahedronStride == 1 ||
      ((tetrahedron * 2654435761u) >> 8) % this->TetrahedronStride == 0;
  }
};

}

#endif
