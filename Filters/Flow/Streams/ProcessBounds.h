// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ProcessBounds_h
#define interlume_ProcessBounds_h

#include "Streams/RankExchange.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace interlume
{

/// Bounding box of the data of each process, available in all processes.
class ProcessBounds
{
public:
  /// Collects the bounds of all processes. \a own are the bounds (xmin, xmax, ymin, ...) of this
  /// process, or null if it has no data. Collective.
  void Build(RankExchange& exchange, const double* own)
  {
    // Negate the lower bounds, so that ReduceMax applies to lower and upper bounds.
    const auto ranks = static_cast<std::size_t>(exchange.GetNumberOfRanks());
    std::vector<double> ends(6 * ranks, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; own && i < 6; ++i)
    {
      ends[6 * static_cast<std::size_t>(exchange.GetRank()) + i] = i % 2 ? own[i] : -own[i];
    }
    exchange.ReduceMax(ends);
    this->Ends.resize(ranks);
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      this->Ends[i / 6][i % 6] = ends[i];
    }
  }

  /// Calls visit(rank) for each process whose box, enlarged by \a margin, contains x.
  template <typename Visit>
  void ForEachAt(const double x[3], double margin, Visit&& visit) const
  {
    for (std::size_t rank = 0; rank < this->Ends.size(); ++rank)
    {
      bool isIn = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        isIn = isIn && -x[axis] <= this->Ends[rank][2 * axis] + margin &&
          x[axis] <= this->Ends[rank][2 * axis + 1] + margin;
      }
      if (isIn)
      {
        visit(static_cast<int>(rank));
      }
    }
  }

private:
  std::vector<std::array<double, 6>> Ends;
};

}

#endif
