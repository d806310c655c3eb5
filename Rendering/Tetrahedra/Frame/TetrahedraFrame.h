// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraFrame_h
#define interlume_TetrahedraFrame_h

#include "Frame/PiecewiseLinearTransferFunction.h"
#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"
#include "View/TetrahedraView.h"

#include <cstdint>
#include <vector>

namespace interlume
{

class BoundaryShading;

/**
 * The data from which a render path, OpenGL or software, draws one image. Pointers must remain
 * valid until the image is drawn.
 */
struct TetrahedraFrame
{
  enum Blends
  {
    COMPOSITE,
    MAXIMUM,
    ADDITIVE,
    PRIORITY,
    OPTICAL_DEPTH
  };

  /// Counts the changes of each kind of data. A window compares these counts with those of its last
  /// image to decide what to upload or redraw.
  struct Changes
  {
    int Mesh = 0;
    int Values = 0;
    int Colors = 0;
    int Order = 0;
    int Surface = 0;
    /// Changes of the boundary triangles, but not of their lighting, which requires no upload.
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
  const PiecewiseLinearTransferFunction* Pieces = nullptr;
  TetrahedraView View;
  /// Planes that cut the mesh, in mesh coordinates. The parts that PlaneClip appends change only if
  /// the mesh or these planes change.
  std::vector<glm::dvec4> Planes;
  /// Tetrahedra in drawing order: front to back, or by layer from the highest priority. Null means
  /// mesh order.
  const std::vector<std::uint32_t>* Order = nullptr;
  /// Depth of the closest opaque surface at each pixel, bottom row first; null if there is none.
  const float* Opaque = nullptr;
  /// Shading of the boundary triangles; null if they are not drawn.
  const BoundaryShading* Surface = nullptr;
  Blends Blend = COMPOSITE;
  /// If true, the image contains the sums or maxima of the blend mode before their conversion to
  /// colors.
  bool IsSum = false;
  /// If true, the image contains the tetrahedron seen at each pixel instead of colors (software).
  bool IsSelection = false;
  /// Extinction that corresponds to opacity 1. MAXIMUM uses it to recover opacity.
  double ExtinctionUnit = 1.0;
  bool IsExact = true;
  /// If true, a vertex shader reads tetrahedra from buffers and creates their silhouettes (OpenGL).
  /// Otherwise a geometry shader creates the silhouettes.
  bool IsPulled = false;
  /// Number of viewport pixels per image pixel, in x and in y.
  int PixelStride = 1;

  /// Returns true if both frames give the same image for the same depths of opaque surfaces.
  bool HasSameImage(const TetrahedraFrame& other) const
  {
    return this->Mesh == other.Mesh && this->Versions == other.Versions &&
      this->View == other.View && this->Planes == other.Planes && this->Blend == other.Blend &&
      this->IsExact == other.IsExact && this->PixelStride == other.PixelStride;
  }
};

}

#endif
