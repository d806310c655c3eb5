// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Fragments_h
#define interlume_Fragments_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * Segments of view rays inside tetrahedra, as a structure of arrays, so that loops over segments
 * are vectorized even if tetrahedra are small. In arrays of two, index 0 is the front end and 1 the
 * back end.
 */
struct Fragments
{
  static constexpr int CAPACITY = 512;
  /// Segments of a row are written in groups of this size. The last group may extend past the row.
  static constexpr int GROUP = 8;
  template <typename T>
  using Array = std::array<T, CAPACITY + GROUP>;
  using Values = Array<float>;
  using Color = std::array<float, 4>;

  /// The segments of a tetrahedron in adjacent pixels of a row.
  struct Run
  {
    std::uint32_t Tetrahedron;
    /// Index of the run's first pixel within the tile.
    std::uint16_t Pixel;
    std::uint16_t Begin;
    std::uint16_t End;
  };
  std::array<Run, CAPACITY> Runs;
  int NumberOfRuns = 0;
  int Size = 0;

  /// Length in units of mesh coordinates. In perspective, it is valid only after
  /// ApplyPerspectiveDivision().
  Values Length;
  /// Depths of both ends.
  Values Depth[2];
  /// Scalar, extent in time and extinction at both ends. In perspective, scalar and extent in time
  /// are multiplied by depth until ApplyPerspectiveDivision() is called.
  Values Scalar[2];
  Values DeltaT[2];
  Values Extinction[2];
  /// Colors at both ends, interpolated from point colors.
  Array<Color> Colors[2];
  /// Index of the transfer function piece that contains each end. If a segment crosses a control
  /// point, ConvertToPieceWeights() sets its entry in Pieces[0] to -1 - i, where SplitColors[i] is
  /// its color.
  Array<std::int32_t> Pieces[2];
  /// Indices of the segments that cross a control point, and the colors of these segments.
  Array<std::uint16_t> Split;
  Array<Color> SplitColors;
  int NumberOfSplits = 0;

  /// Results of the integration: weights of the colors at both ends, and the sum of these weights,
  /// which is the opacity or optical depth.
  Values Weight[2];
  Values Total;
  /// Intermediate values: optical depth, and the relative change of extinction.
  Values OpticalDepth;
  Values Slope;
};

}

#endif
