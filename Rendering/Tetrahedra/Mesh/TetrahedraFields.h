// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraFields_h
#define interlume_TetrahedraFields_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * Values at the points and in the tetrahedra of a TetrahedraMesh. Extinction, the fourth component
 * of a color, is per unit of length in mesh coordinates.
 */
struct TetrahedraFields
{
  enum Kinds
  {
    /// Scalars at points, mapped to colors by transfer functions.
    SCALARS,
    /// Colors at points.
    POINT_COLORS,
    /// A color for each tetrahedron.
    CELL_COLORS
  };

  Kinds Kind = SCALARS;
  /// Scalars at points (SCALARS), mapped from Range to [0, 1].
  std::vector<float> Scalars;
  double Range[2] = { 0.0, 1.0 };
  /// RGB and extinction at points (POINT_COLORS) or of tetrahedra (CELL_COLORS).
  std::vector<std::array<float, 4>> Colors;
  /// Extent in time at points; empty if it is 1 everywhere.
  std::vector<float> DeltaT;
  /// Layer of each tetrahedron; empty unless layers are drawn.
  std::vector<int> Layers;
  /// Bit mask of each tetrahedron: bit k is set if the face opposite corner k is a boundary
  /// triangle. Faces, Normals and TextureCoordinates are empty if no boundary triangles are drawn.
  std::vector<unsigned char> Faces;
  /// Material of the triangle opposite each corner of each tetrahedron (BoundaryShading); empty if
  /// there is only one material.
  std::vector<std::array<unsigned char, 4>> FaceMaterials;
  /// Normals at points.
  std::vector<std::array<float, 3>> Normals;
  /// Texture coordinates at points; empty if the boundary triangles have none.
  std::vector<std::array<float, 2>> TextureCoordinates;
};

}

#endif
