// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartPatches_h
#define interlume_PartPatches_h

#include "Fields/BoundaryPatches.h"
#include "Streams/RankExchange.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   PartPatches
 * @brief   the patches of a boundary of which each process has a part
 *
 * A patch may begin in one process and end in another, and is numbered by the first face of all.
 * So all processes get all of the boundary, which is a small part of the grid, while patches are
 * found. Points of two processes that have the same coordinates to the last bit are one; where a
 * process has several there, the first is the others' first, in the order of its points.
 */
namespace PartPatches
{
struct Corners
{
  int Number = 0;
  vtkIdType Points[4] = { 0, 0, 0, 0 };
};
/// Faces by ascending numbers, their corners, and the positions of points.
struct Surface
{
  std::vector<vtkIdType> Faces;
  std::vector<Corners> FaceCorners;
  std::vector<std::array<double, 3>> Positions;
};

/// Builds the patches of the surfaces of all processes, one after the other. Collective.
void Build(const Surface& own, RankExchange& exchange, BoundaryPatches& patches);
}

}

#endif
