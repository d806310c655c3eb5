// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SharedPoints_h
#define interlume_SharedPoints_h

#include "Common/ArrayRows.h"
#include "Streams/RankExchange.h"

#include "vtkType.h"

#include <vector>

class vtkDataArray;

namespace interlume
{

/// Points of unstructured grids that several processes share.
namespace SharedPoints
{
/// Returns, in ascending order, the given points that a process of lower rank also has, with
/// bit-identical coordinates. If each process omits these points, every point is counted once over
/// all processes. Collective.
std::vector<vtkIdType> FindRepeated(
  const std::vector<vtkIdType>& points, const ArrayRows& positions, RankExchange& exchange);

/// Replaces the tuples of each shared point with those of the process with the lowest rank that has
/// the point. The arrays must have contiguous tuples. All processes with points must pass the same
/// arrays in the same order. Collective.
void CopyFromLowestRank(const ArrayRows& positions, const std::vector<vtkDataArray*>& arrays,
  vtkIdType numberOfPoints, RankExchange& exchange);
}

}

#endif
