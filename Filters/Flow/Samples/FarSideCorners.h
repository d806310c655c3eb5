// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FarSideCorners_h
#define interlume_FarSideCorners_h

#include "Advection/AdvectionOptions.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

class ImplicitFlowArrays;

/**
 * @class   FarSideCorners
 * @brief   finds the samples at corners of cells that a termination surface cuts
 *
 * The cells are mixed: their corners differ in status or id, or time is discontinuous within them.
 * A surface reached by a corner's streamline crosses such a cell if the signed distance from it has
 * both signs at the corners, and the distances of two corners on different sides add up to at most
 * the cell's diagonal. All corners must project onto the surface, so that its boundary edge is not
 * in the cell. A corner on the surface counts as having reached it.
 */
class FarSideCorners
{
public:
  struct Corner
  {
    vtkIdType Sample = -1;
    /// Index of the surface in the options.
    int Surface = -1;
    /// Signed distance from the surface; 0 if the sample is on it.
    double Distance = 0.0;
    /// Longest diagonal of the cut cells that share this corner.
    double Length = 0.0;
    /// True if one of these cells has a corner on the other side that reaches a surface.
    bool IsOtherReached = false;
  };

  /// Two corners of a cell, one that reaches a surface and one that does not.
  struct Pair
  {
    vtkIdType Reached = -1;
    vtkIdType Other = -1;
    bool IsEdge = true;
  };

  /// Finds the corners, each with its nearest surface, in ascending order of samples and without
  /// duplicates. If \a pairs is not null, it receives pairs for the mixed cells that no surface
  /// crosses and in which some corners reach the same surface and the others reach none. Each pair
  /// consists of the ends of an edge. A corner without such an edge is paired with the nearest
  /// corner that can complete a pair.
  static std::vector<Corner> Find(vtkDataSet* samples, const ImplicitFlowArrays& arrays,
    const AdvectionOptions& options, std::vector<Pair>* pairs = nullptr);

  /// Removes pairs that are not edges if both samples are also in pairs that are.
  static void RemoveRedundant(std::vector<Pair>& pairs);
};

}

#endif
