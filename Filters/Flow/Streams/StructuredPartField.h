// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StructuredPartField_h
#define interlume_StructuredPartField_h

#include "Fields/OpenInterfaces.h"
#include "Fields/StructuredWalker.h"
#include "Streams/PartField.h"
#include "Streams/RankBoxes.h"

namespace interlume
{

/**
 * @class   StructuredPartField
 * @brief   a field on a structured grid of which a process holds a part
 *
 * Where a position is cannot be computed: the own cells are searched, and so are those of the other
 * processes in whose box it is, in an order that the processes share (CellFinding). Seams lead to
 * cells that may be any process's, by the corners of faces on the outside of the whole, which are
 * sent to the processes that have others there.
 */
class StructuredPartField : public PartField<StructuredFlowField>
{
public:
  static constexpr bool IsSearched = true;

  /// Makes the tree and finds the seams, once BuildPart has succeeded in all processes. Collective.
  void Join(RankExchange& exchange);

  /// Calls visit(rank) for the processes whose cells may hold x.
  template <typename Visit>
  void ForEachRankAt(const double x[3], Visit&& visit) const
  {
    this->Boxes.ForEachAt(x, 0.0, visit);
  }

  /// Returns what is so of the whole. Collective.
  OpenInterfaces FindOpenInterfaces(RankExchange& exchange) const;

private:
  void FindSeams(RankExchange& exchange);

  RankBoxes Boxes;
};

using StructuredPartWalker = StructuredWalkerOf<StructuredPartField>;

}

#endif
