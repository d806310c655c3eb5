// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OccupancyEstimate_h
#define interlume_OccupancyEstimate_h

namespace interlume
{

class MaterialTable;
class VolumeBlocks;
class VolumeSamples;

/**
 * @class   OccupancyEstimate
 * @brief   estimates the fraction of the visible blocks that contains a medium
 */
class OccupancyEstimate
{
public:
  /// Returns the fraction, 0 to 1, of the samples in visible blocks that have a positive extinction
  /// in any row. Uses every fourth sample along each axis. Returns 1 if no block is visible.
  static double Find(
    const VolumeSamples& samples, const VolumeBlocks& blocks, const MaterialTable& material);
};

}

#endif
