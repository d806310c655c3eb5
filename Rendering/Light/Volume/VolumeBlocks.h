// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeBlocks_h
#define interlume_VolumeBlocks_h

#include "Volume/BlockLattice.h"

#include <array>
#include <vector>

namespace interlume
{

class MaterialTable;
class VolumeSamples;

/**
 * @class   VolumeBlocks
 * @brief   the ranges of values of small blocks of a volume, and which of them can be seen
 *
 * The box of the samples' centres is cut into blocks of equal cells along each axis, the last ones
 * smaller. A block's range is that of all samples that interpolation inside it reads, and of a
 * further one on each side for gradients.
 */
class VolumeBlocks
{
public:
  /// The number of cells of a block along an axis, and of a small one.
  static constexpr int BlockSize = 16;
  static constexpr int SmallSize = BlockSize / 2;

  /// Finds the ranges of blocks of \a cells along each axis, with several threads.
  void Build(const VolumeSamples& samples, int cells = BlockSize);

  /// Takes the ranges of blocks of twice as many cells along each axis from those of \a small ones,
  /// which gives what Build() finds.
  void Join(const VolumeBlocks& small);

  /// Marks the blocks whose range has an extinction above 0 somewhere.
  void Classify(const MaterialTable& material);

  const std::array<int, 3>& GetSize() const { return this->Size; }
  int GetNumberOfBlocks() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  int GetNumberVisible() const { return this->NumberVisible; }
  bool IsVisible(int i, int j, int k) const
  {
    const auto row = static_cast<std::size_t>(k) * this->Size[1] + j;
    return this->Visible[row * this->Size[0] + i] != 0;
  }
  BlockLattice GetLattice() const
  {
    return { { { this->GetBorders(0), this->GetBorders(1), this->GetBorders(2) } }, this->Visible };
  }
  /// Where block borders lie along \a axis, in texture coordinates 0 to 1: one more than blocks.
  std::vector<double> GetBorders(int axis) const;

private:
  /// Sets the numbers of blocks, without ranges.
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
  /// The lower and upper value of each component of each block.
  std::vector<std::array<double, 2>> Ranges;
  std::vector<unsigned char> Visible;
  int NumberVisible = 0;
};

}

#endif
