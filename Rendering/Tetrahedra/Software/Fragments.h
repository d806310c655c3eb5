// SPDX-License-Identifier: BSD-3-Clause
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
  /// The size of the groups that rows are written in, the last beyond their end.
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

  /// The difference of depth; then the length, in units of the mesh.
  Values Length;
  /// The depths of both ends.
  Values Depth[2];
  /// Scalar, extent in time, and extinction of both ends, weighted by depth until the division in
  /// perspective.
  Values Scalar[2];
  Values DeltaT[2];
  Values Extinction[2];
  /// The point colours of both ends.
  Array<Color> Colors[2];
  /// The pieces of the transfer functions that both ends are in; for the front end of a segment
  /// that passes a control point, once it is integrated, -1 - i for Bent[i].
  Array<std::int32_t> Pieces[2];
  /// The segments that pass a control point, and the colours that they come to.
  Array<std::uint16_t> Bent;
  Array<Color> BentColors;
  int NumberBent = 0;

  /// The results of integration: the weights of both colours, and their sum, opacity or optical
  /// depth.
  Values Weight[2];
  Values Total;
  /// The intermediate values: optical depth, and how extinction falls or rises.
  Values OpticalDepth;
  Values Slope;
};

}

#endif
