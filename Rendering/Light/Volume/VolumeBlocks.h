// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeBlocks_h
#define interlume_VolumeBlocks_h

#include "Volume/BlockGrid.h"

#include <array>
#include <vector>

namespace interlume
{

class MaterialTable;
class VolumeSamples;

/**
 * @class   VolumeBlocks
 * @brief   value ranges and visibility of small blocks of a volume
 *
 * The cells between the sample centers are divided into blocks with the same number of cells along
 * each axis. The last blocks may be smaller. A block's value range includes all samples that are
 * read to interpolate inside the block, and one more sample on each side for gradients.
 */
class VolumeBlocks
{
public:
  /// Number of cells along the edge of a block and of a small block.
  static constexpr int BlockSize = 16;
  static constexpr int SmallSize = BlockSize / 2;

  /// Computes the value ranges of blocks with \a cells cells along each axis, in parallel.
  void Build(const VolumeSamples& samples, int cells = BlockSize);

  /// Combines the blocks of \a small into blocks of twice the edge length. The result is the same
  /// as that of Build().
  void Join(const VolumeBlocks& small);

  /// Marks blocks as visible if their value range contains a value with a positive extinction.
  void Classify(const MaterialTable& material);

  const std::array<int, 3>& GetSize() const { return this->Size; }
  int GetNumberOfBlocks() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  int GetNumberOfVisibleBlocks() const { return this->NumberVisible; }
  bool IsVisible(int i, int j, int k) const
  {
    const auto row = static_cast<std::size_t>(k) * this->Size[1] + j;
    return this->Visible[row * this->Size[0] + i] != 0;
  }
  BlockGrid GetBlockGrid() const
  {
    return { { { this->GetBorders(0), this->GetBorders(1), this->GetBorders(2) } }, this->Visible };
  }
  /// Returns the borders between blocks along \a axis, including both ends, in texture coordinates
  /// from 0 to 1.
  std::vector<double> GetBorders(int axis) const;

private:
  /// Sets the number of blocks and clears their ranges.
  void SetSize(const std::array<int, 3>& samples, int components, int cells);
  std::array<double, 2>* GetRanges(int block)
  {
    return &this->Ranges[static_cast<std::size_t>(block) *
      static_cast<std::size_t>(this->Components)];
  }

  int Cells = BlockSize;
  std::array<int, 3> Size{ { 0, 0, 0 } };
  std::array<int, 3> Samples{ { 0, 0, 0 } };
  int Components = 0;
  /// Smallest and largest value of each component in each block.
  std::vector<std::array<double, 2>> Ranges;
  std::vector<unsigned char> Visible;
  int NumberVisible = 0;
};

}

#endif
