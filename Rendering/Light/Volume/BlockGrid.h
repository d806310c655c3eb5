// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BlockGrid_h
#define interlume_BlockGrid_h

#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   BlockGrid
 * @brief   visible blocks of a volume, merged into larger blocks where possible
 *
 * Blocks form a rectilinear grid in texture coordinates. A layer is the set of blocks that have the
 * same index along an axis. Only whole layers are merged, so that no block has a corner on the edge
 * of another block.
 */
class BlockGrid
{
public:
  /// \a borders has one more entry along each axis than there are blocks. \a visible has one flag
  /// per block, x fastest.
  BlockGrid(
    const std::array<std::vector<double>, 3>& borders, const std::vector<unsigned char>& visible);

  /// Crops the blocks to \a box, then extends the outermost blocks by \a margin along each axis.
  void Crop(const std::array<std::array<double, 2>, 3>& box, const std::array<double, 3>& margin);

  /// Merges adjacent layers in which the same blocks are visible.
  void Join();

  int GetSize(std::size_t axis) const { return static_cast<int>(this->Borders[axis].size()) - 1; }
  const std::vector<double>& GetBorders(std::size_t axis) const { return this->Borders[axis]; }
  bool IsVisible(const std::array<int, 3>& block) const;
  /// Returns all visible blocks, x fastest.
  std::vector<std::array<int, 3>> GetVisible() const;

private:
  bool AreEqual(std::size_t axis, int layer, int other) const;
  /// Retains only the layers with the indices \a layers along \a axis, and sets their \a borders.
  void Keep(std::size_t axis, const std::vector<int>& layers, const std::vector<double>& borders);

  std::array<std::vector<double>, 3> Borders;
  std::vector<unsigned char> Visible;
};

}

#endif
