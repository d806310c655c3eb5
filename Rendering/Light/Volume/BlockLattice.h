// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BlockLattice_h
#define interlume_BlockLattice_h

#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   BlockLattice
 * @brief   the visible blocks of a volume, as few as there can be
 *
 * Blocks lie along three axes of texture coordinates and share all borders, so that there are no
 * corners on the edges of other blocks.
 */
class BlockLattice
{
public:
  /// Takes \a borders along each axis, one more than blocks, and for each block whether it is \a
  /// visible, x fastest.
  BlockLattice(
    const std::array<std::vector<double>, 3>& borders, const std::vector<unsigned char>& visible);

  /// Leaves out the blocks outside of \a box; the first and last blocks reach to it, and beyond it
  /// by \a margin of each axis.
  void Crop(const std::array<std::array<double, 2>, 3>& box, const std::array<double, 3>& margin);

  /// Joins layers whose blocks are visible in the same places.
  void Join();

  int GetSize(std::size_t axis) const { return static_cast<int>(this->Borders[axis].size()) - 1; }
  const std::vector<double>& GetBorders(std::size_t axis) const { return this->Borders[axis]; }
  bool IsVisible(const std::array<int, 3>& block) const;
  /// Returns all visible blocks, x fastest.
  std::vector<std::array<int, 3>> GetVisible() const;

private:
  bool AreAlike(std::size_t axis, int layer, int other) const;
  /// Keeps these layers along the axis, with these borders.
  void Keep(std::size_t axis, const std::vector<int>& layers, const std::vector<double>& borders);

  std::array<std::vector<double>, 3> Borders;
  std::vector<unsigned char> Visible;
};

}

#endif
