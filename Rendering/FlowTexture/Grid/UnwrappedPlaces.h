// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnwrappedPlaces_h
#define interlume_UnwrappedPlaces_h

namespace interlume
{

class FlowGrid;

/**
 * @class   UnwrappedPlaces
 * @brief   adds whole periods to the places of voxels, so that few cells have a seam in them
 *
 * Along a periodic direction u and u + 1 are one place. A flow that turns winds the seam between 1
 * and 0 up, and there is a sheet of it for each turn; places that go on beyond 1 have a seam only
 * where one way round the axis meets the other. Voxels of one label take, one from the other, the
 * period in which they differ by half or less (K. Itoh, "Analysis of the phase unwrapping
 * algorithm", 1982), those that differ little first.
 */
class UnwrappedPlaces
{
public:
  /// Changes the places of a grid, whose ids, periods and groups are known. Takes one order of
  /// voxels for any number of threads.
  static void Apply(FlowGrid& grid);
};

}

#endif
