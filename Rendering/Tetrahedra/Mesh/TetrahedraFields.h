// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraFields_h
#define interlume_TetrahedraFields_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * The values that the tetrahedra carry. Extinction, the fourth of a colour, is per unit of length
 * of the mesh's coordinates (TetrahedraMesh::Scale).
 */
struct TetrahedraFields
{
  enum Kinds
  {
    /// The fields are scalars at points, with colour by transfer functions.
    SCALARS,
    /// The fields are colours at points.
    POINT_COLORS,
    /// The fields are one colour for each tetrahedron.
    CELL_COLORS
  };

  Kinds Kind = SCALARS;
  /// The scalars at points (SCALARS), 0 to 1 over Range.
  std::vector<float> Scalars;
  double Range[2] = { 0.0, 1.0 };
  /// The colours as RGB and extinction, at points or of cells.
  std::vector<std::array<float, 4>> Colors;
  /// The extent in time at points; empty where it is 1 everywhere.
  std::vector<float> DeltaT;
  /// The layer of each tetrahedron; empty unless layers are drawn.
  std::vector<int> Layers;
  /// The faces of each tetrahedron that are boundary triangles, bit k for that opposite corner k;
  /// empty where no boundary is drawn, as are the next two.
  std::vector<unsigned char> Faces;
  /// The normals at points.
  std::vector<std::array<float, 3>> Normals;
  /// The texture coordinates at points; empty where the boundary has none.
  std::vector<std::array<float, 2>> TextureCoordinates;
};

}

#endif
