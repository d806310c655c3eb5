// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SmoothVoxels_h
#define interlume_SmoothVoxels_h

#include <vector>

namespace interlume
{

class FlowGrid;

/**
 * @class   SmoothVoxels
 * @brief   texels of an implicit flow field, of which one interpolated look tells most of a sample
 *
 * Of each voxel four numbers:
 * - u and v;
 * - the largest bound of slopes of the cells around the voxel, so that the interpolated one is no
 *   less than that of the cell it is in;
 * - the label, where all cells around the voxel have one surface and no seam; less the distance of
 *   the nearest cell that is not empty, in the largest norm, where all are empty; else MIXED. What
 *   is interpolated is a label, or below 0, only if that is so at all corners, for all the corners
 *   of other cells are MIXED, and this is so much that the smallest weight of a float keeps it
 *   above all labels.
 */
class SmoothVoxels
{
public:
  static constexpr float MIXED = 1e30F;

  static std::vector<float> Make(const FlowGrid& grid);
};

}

#endif
