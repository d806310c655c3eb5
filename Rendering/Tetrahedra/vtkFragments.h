#ifndef vtkFragments_h
#define vtkFragments_h

#include <array>
#include <cstdint>

/**
 * Segments of lines of sight within tetrahedra, one array for each of their values, so that loops over
 * them use vector instructions however small the tetrahedra are. Index 0 of a pair is the front end,
 * 1 the back end.
 */
struct vtkFragments
{
  static constexpr int CAPACITY = 512;
  using Values = std::array<float, CAPACITY>;

  int Size = 0;
  /// Pixel within the tile, and tetrahedron.
  std::array<std::uint32_t, CAPACITY> Pixels;
  std::array<std::uint32_t, CAPACITY> Tetrahedra;
  /// Difference of depth; then length, in units of the mesh.
  alignas(64) Values Length;
  /// Depths of both ends.
  alignas(64) Values Depth[2];
  /// Scalar or extent in time, in perspective weighted by depth until the division.
  alignas(64) Values Scalar[2];
  alignas(64) Values DeltaT[2];
  /// Colour and extinction of both ends.
  std::array<std::array<float, 4>, CAPACITY> Color[2];

  /// What integration makes: the weights of both colours, and optical depth or transmittance.
  alignas(64) Values Weight[2];
  alignas(64) Values Total;
};

#endif
