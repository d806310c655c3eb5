// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TileBins_h
#define interlume_TileBins_h

#include "Frame/TetrahedraFrame.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   TileBins
 * @brief   lists the tetrahedra of each tile, in drawing order
 *
 * It also stores the projected points. Tetrahedra whose bounding rectangle contains no pixel center
 * are in no tile.
 */
class TileBins
{
public:
  /// Edge length of a tile in pixels.
  static constexpr int SIZE = 96;

  /// A projected point with its values.
  struct Point
  {
    TetrahedraView::Projected Position;
    float Scalar;
    float DeltaT;
  };

  /// Fills the lists. Returns false if \a isAborted, which is called between stages, returned true.
  /// The lists are then incomplete.
  bool Fill(const TetrahedraFrame& frame, const std::function<bool()>& isAborted);

  int GetColumns() const { return this->Columns; }
  int GetNumberOfTiles() const { return this->Columns * this->Rows; }
  const Point* GetPoints() const { return this->Points.data(); }
  const std::uint32_t* Begin(int tile) const { return this->Lists.data() + this->Starts[tile]; }
  const std::uint32_t* End(int tile) const { return this->Lists.data() + this->Starts[tile + 1]; }
  vtkIdType GetNumberOfDrawnTetrahedra() const { return this->NumberDrawn; }
  std::size_t GetBytes() const;

private:
  /// First and last column, and first and last row of tiles; empty if the first exceeds the last.
  using Range = std::array<std::uint16_t, 4>;

  void ProjectPoints(const TetrahedraFrame& frame);
  void FindRanges(const TetrahedraFrame& frame);
  Range GetRange(const TetrahedraFrame& frame, std::uint32_t tetrahedron) const;
  /// Calls action(tile, tetrahedron) for the tiles of each tetrahedron of a chunk, in drawing
  /// order. Returns the number of tetrahedra in tiles.
  template <typename Action>
  vtkIdType VisitChunk(const TetrahedraFrame& frame, std::size_t chunk, const Action& action) const;
  /// Counts the tetrahedra per chunk and tile, with the tile as faster index.
  std::vector<std::size_t> CountTetrahedra(const TetrahedraFrame& frame);
  /// Sets the starts of the lists, and replaces counts by positions in the lists.
  void FindPositions(std::vector<std::size_t>& counts);

  int Columns = 0;
  int Rows = 0;
  std::vector<Point> Points;
  std::vector<Range> Ranges;
  std::vector<std::size_t> Starts;
  std::vector<std::uint32_t> Lists;
  vtkIdType NumberDrawn = 0;
};

}

#endif
