// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionedPatches_h
#define interlume_PartitionedPatches_h

#include "Fields/BoundaryPatches.h"
#include "Streams/RankExchange.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   PartitionedPatches
 * @brief   finds the patches of the boundary of a partitioned grid
 *
 * A patch may extend over several processes, and its number depends on its first face in the whole
 * grid. Therefore all processes receive the entire boundary, which is small compared to the grid.
 * Points of two processes are the same if their coordinates are bit-identical. If a process has
 * several points at one position, the n-th of them is the same as the n-th point at this position
 * in any other process.
 */
namespace PartitionedPatches
{
struct Corners
{
  int Number = 0;
  vtkIdType Points[4] = { 0, 0, 0, 0 };
};
/// Sorted faces, their corners, and the positions of their points.
struct Surface
{
  std::vector<vtkIdType> Faces;
  std::vector<Corners> FaceCorners;
  std::vector<std::array<double, 3>> Positions;
};

/// Builds the patches of the boundary that consists of the surfaces of all processes in rank order.
/// Collective.
void Build(const Surface& own, RankExchange& exchange, BoundaryPatches& patches);
}

}

#endif
