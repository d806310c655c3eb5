// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SmoothVoxels_h
#define interlume_SmoothVoxels_h

#include <vector>

namespace interlume
{

class FlowGrid;

/**
 * @class   SmoothVoxels
 * @brief   texels of an implicit flow field that often make one interpolated lookup sufficient
 *
 * Each voxel has four numbers:
 * - u and v;
 * - the maximum slope bound of the adjacent cells. The interpolated value is at least the bound of
 *   the cell itself;
 * - the label, if all adjacent cells have the same surface and no seam; minus the distance to the
 *   nearest cell that is not empty, in the maximum norm, if all adjacent cells are empty; otherwise
 *   MIXED.
 *
 * An interpolated fourth number is a label, or negative, only if no corner is MIXED: this value is
 * so large that even the smallest interpolation weight yields more than any label. Split cells and
 * cells at a seam have only MIXED corners.
 */
class SmoothVoxels
{
public:
  static constexpr float MIXED = 1e30F;

  static std::vector<float> Make(const FlowGrid& grid);
};

}

#endif
