// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RankBoxes_h
#define interlume_RankBoxes_h

#include "Streams/RankExchange.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace interlume
{

/// The box that each process has something in, known to all.
class RankBoxes
{
public:
  /// Takes the lower and upper x, y, z of this process; null where it has nothing. Collective.
  void Build(RankExchange& exchange, const double* own)
  {
    // Upper bounds and the negatives of lower ones, of which the largest count.
    const auto ranks = static_cast<std::size_t>(exchange.GetNumberOfRanks());
    std::vector<double> ends(6 * ranks, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; own && i < 6; ++i)
    {
      ends[6 * static_cast<std::size_t>(exchange.GetRank()) + i] = i % 2 ? own[i] : -own[i];
    }
    exchange.Maximize(ends);
    this->Ends.resize(ranks);
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      this->Ends[i / 6][i % 6] = ends[i];
    }
  }

  /// Calls visit(rank) for the processes whose box, larger by a margin, holds x.
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
