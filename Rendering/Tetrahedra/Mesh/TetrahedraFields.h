#ifndef interlume_TetrahedraFields_h
#define interlume_TetrahedraFields_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * What the tetrahedra carry. Extinction, the fourth of a colour, is per unit of length of the
 * mesh's coordinates (TetrahedraMesh::Scale).
 */
struct TetrahedraFields
{
  enum Kinds
  {
    /// Scalars at points; colour by transfer functions.
    SCALARS,
    /// Colours at points.
    POINT_COLORS,
    /// One colour for each tetrahedron.
    CELL_COLORS
  };

  Kinds Kind = SCALARS;
  /// 0 to 1 over Range; at points (SCALARS).
  std::vector<float> Scalars;
  double Range[2] = { 0.0, 1.0 };
  /// RGB and extinction, at points or of cells.
  std::vector<std::array<float, 4>> Colors;
  /// At points; empty where it is 1 everywhere.
  std::vector<float> DeltaT;
  /// Of each tetrahedron; empty unless layers are drawn.
  std::vector<int> Layers;
  /// Of each tetrahedron the faces that are boundary triangles, bit k for that opposite corner k;
  /// empty where no boundary is drawn, as are the next two.
  std::vector<unsigned char> Faces;
  /// At points.
  std::vector<std::array<float, 3>> Normals;
  /// At points; empty where the boundary has none.
  std::vector<std::array<float, 2>> TextureCoordinates;
};

}

#endif
