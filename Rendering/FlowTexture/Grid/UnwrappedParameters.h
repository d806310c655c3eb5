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
 * Along a periodic direction, u and u + 1 are the same point. In a rotating flow the seam between 1
 * and 0 is wound up, with one sheet per turn. Coordinates that continue past 1 have a seam only
 * where the two directions around the axis meet. Each voxel takes the period in which it differs
 * from a neighbor with the same label by at most one half (K. Itoh, "Analysis of the phase
 * unwrapping algorithm", 1982). Neighbors with small differences are processed first.
 */
class UnwrappedParameters
{
public:
  /// Changes the surface coordinates of a grid with known ids, periods and groups. The order of
  /// voxels does not depend on the number of threads.
  static void Apply(FlowGrid& grid);
};

}

#endif
