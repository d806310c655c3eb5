// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionedStructuredField_h
#define interlume_PartitionedStructuredField_h

#include "Fields/NonconformingInterfaces.h"
#include "Fields/StructuredWalker.h"
#include "Streams/PartitionedField.h"
#include "Streams/ProcessBounds.h"

namespace interlume
{

/**
 * @class   PartitionedStructuredField
 * @brief   partition of a field on a structured grid
 *
 * The cell at a position cannot be computed directly. All processes whose bounds contain the
 * position search their own cells. All processes order the results in the same way and use the
 * first (CellSearchResult). A seam may lead to a cell of any process. To find seams, faces on the
 * boundary of the whole grid are sent to all processes that may have boundary faces at the same
 * position, and these processes compare the corners.
 */
class PartitionedStructuredField : public PartitionedField<StructuredFlowField>
{
public:
  static constexpr bool IsSearched = true;

  /// Builds the cell tree and finds the seams. Call it after BuildPart has succeeded in all
  /// processes. Collective.
  void Join(RankExchange& exchange);

  /// Calls visit(rank) for each process whose cells may contain x.
  template <typename Visit>
  void ForEachRankAt(const double x[3], Visit&& visit) const
  {
    this->Boxes.ForEachAt(x, 0.0, visit);
  }

  /// Returns the nonconforming interfaces of the whole grid. Collective.
  NonconformingInterfaces FindNonconformingInterfaces(RankExchange& exchange) const;

private:
  void FindSeams(RankExchange& exchange);

  ProcessBounds Boxes;
};

using StructuredPartWalker = StructuredWalkerOf<PartitionedStructuredField>;

}

#endif
