#ifndef interlume_Fragments_h
#define interlume_Fragments_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * Segments of lines of sight within tetrahedra, one array for each of their values, so that loops
 * over them use vector instructions however small the tetrahedra are. Index 0 of a pair is the
 * front end, 1 the back end.
 */
struct Fragments
{
  static constexpr int CAPACITY = 512;
  /// Rows are written in groups of this many, the last beyond their end.
  static constexpr int GROUP = 8;
  template <typename T>
  using Array = std::array<T, CAPACITY + GROUP>;
  using Values = Array<float>;
  using Color = std::array<float, 4>;

  /// Segments of one tetrahedron in neighbouring pixels.
  struct Run
  {
    std::uint32_t Tetrahedron;
    /// The first pixel within the tile.
    std::uint16_t Pixel;
    std::uint16_t Begin;
    std::uint16_t End;
  };
  std::array<Run, CAPACITY> Runs;
  int NumberOfRuns = 0;
  int Size = 0;

  /// Difference of depth; then length, in units of the mesh.
  Values Length;
  /// Depths of both ends.
  Values Depth[2];
  /// Scalar, extent in time, and extinction. In perspective weighted by depth until the division.
  Values Scalar[2];
  Values DeltaT[2];
  Values Extinction[2];
  /// Point colours of both ends.
  Array<Color> Colors[2];
  /// The pieces of the transfer functions that both ends are in; of the front, once a segment that
  /// passes a control point is integrated, -1 - i for Bent[i].
  Array<std::int32_t> Pieces[2];
  /// Segments that pass a control point, and the colours that they come to.
  Array<std::uint16_t> Bent;
  Array<Color> BentColors;
  int NumberBent = 0;

  /// What integration makes: the weights of both colours, and their sum, opacity or optical depth.
  Values Weight[2];
  Values Total;
  /// Kept on the way: optical depth, and how extinction falls or rises.
  Values OpticalDepth;
  Values Slope;
};

}

#endif
