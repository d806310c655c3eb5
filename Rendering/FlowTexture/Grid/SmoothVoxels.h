// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SmoothVoxels_h
#define interlume_SmoothVoxels_h

#include <vector>

namespace interlume
{

class FlowGrid;

/**
 * @class   SmoothVoxels
 * @brief   packs an implicit flow field into texels, so that one interpolated lookup is often
 * sufficient
 *
 * Each voxel has four values:
 * - u and v;
 * - the maximum slope bound of the adjacent cells. The interpolated value is at least the bound of
 *   the cell itself;
 * - the label, if it is the kind of all adjacent cells; minus the distance to the nearest cell that
 *   is not empty, in the maximum norm, if all adjacent cells are empty; otherwise MIXED.
 *
 * An interpolated fourth value is a label or negative only if no corner is MIXED: MIXED is so large
 * that even with the smallest interpolation weight it exceeds any label. Split cells and cells at a
 * seam have only MIXED corners.
 */
class SmoothVoxels
{
public:
  static constexpr float MIXED = 1e30F;

  static std::vector<float> Make(const FlowGrid& grid);
};

}

#endif
