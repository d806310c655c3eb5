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

/// Points of unstructured grids that several processes have.
namespace SharedPoints
{
/// Returns those of this process's points, ascending, that a process of a lower number has too, by
/// their coordinates to the last bit: all points that are looked at are counted once without them.
/// Collective.
std::vector<vtkIdType> FindRepeated(
  const std::vector<vtkIdType>& points, const ArrayRows& positions, RankExchange& exchange);

/// Gives points that several processes have the tuples of the first of these: of arrays that lie in
/// rows, the same ones in the same order in all processes that have points. Collective.
void TakeFirst(const ArrayRows& positions, const std::vector<vtkDataArray*>& arrays,
  vtkIdType numberOfPoints, RankExchange& exchange);
}

}

#endif
