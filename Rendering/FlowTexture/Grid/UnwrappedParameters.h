// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnwrappedParameters_h
#define interlume_UnwrappedParameters_h

namespace interlume
{

class FlowGrid;

/**
 * @class   UnwrappedParameters
 * @brief   adds whole periods to the surface coordinates of voxels, to reduce the number of seams
 *
 * Along a periodic direction, u and u + 1 are the same point. A rotating flow winds up the seam
 * between 1 and 0, with one sheet per turn. If coordinates continue past 1, a seam remains only
 * where voxels that were processed in opposite directions around the axis meet. Whole periods are
 * added to a voxel's coordinate so that it differs from a neighbor with the same label by at most
 * one half (K. Itoh, "Analysis of the phase unwrapping algorithm", 1982). Neighbors with small
 * differences are processed first.
 */
class UnwrappedParameters
{
public:
  /// Changes the surface coordinates of a grid whose ids, periods and groups are set.
  static void Apply(FlowGrid& grid);
};

}

#endif
