// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BeyondCorners_h
#define interlume_BeyondCorners_h

#include "Advection/AdvectionOptions.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

class ImplicitFlowArrays;

/**
 * @class   BeyondCorners
 * @brief   samples that are corners of cells a termination surface passes through, answers
 * differing
 *
 * The cells are those whose corners differ in status or id, or lie across their surface, and that a
 * surface which a corner has reached passes through: its distance changes sign there, two corners
 * on different sides are together no further from it than the cell's diagonal, and all are beside
 * it, so that its rim is not in the cell. A corner on the surface has reached it.
 */
class BeyondCorners
{
public:
  struct Corner
  {
    vtkIdType Sample = -1;
    /// The number of the surface in the options.
    int Surface = -1;
    /// The signed distance from the surface; 0 where the sample is on it.
    double Distance = 0.0;
    /// The longest diagonal of the cells that the sample is such a corner of.
    double Length = 0.0;
    /// Whether samples on the other side have an answer.
    bool IsOtherReached = false;
  };

  /// Two corners of a cell, one of which reaches a surface.
  struct Pair
  {
    vtkIdType Reached = -1;
    vtkIdType Other = -1;
  };

  /// Finds the corners, ascending by sample, each once, with the nearest surface. \a options must
  /// not change while they are used. If \a pairs is not null, it becomes the pairs in all other
  /// cells whose corners reach one surface or none: the ends of edges, and for a corner without
  /// such an edge the nearest other one.
  static std::vector<Corner> Find(vtkDataSet* samples, const ImplicitFlowArrays& arrays,
    const AdvectionOptions& options, std::vector<Pair>* pairs = nullptr);
};

}

#endif
