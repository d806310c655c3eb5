// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionedCellSearch_h
#define interlume_PartitionedCellSearch_h

#include "Cells/CellSearchResult.h"
#include "Cells/CellShape.h"
#include "Cells/Trilinear.h"
#include "Streams/DistributedField.h"

#include "vtkBoundingBox.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace interlume
{

/**
 * @class   PartitionedCellSearch
 * @brief   finds the process that owns the cell at a position
 *
 * On images and rectilinear grids, the position determines the cell and thus the process. On other
 * grids, several processes may have a cell at the position. All of them search, and the first
 * result in the order of CellSearchResult is used.
 */
template <typename Walker>
class PartitionedCellSearch
{
public:
  using Field = typename Walker::Field;

  PartitionedCellSearch(const Field& field, const DistributedField& ranks)
    : Shared(field)
    , Ranks(ranks)
  {
  }

  /// Finds the processes that may own the cell at a position.
  void FindRanks(const double x[3], std::vector<int>& ranks) const
  {
    ranks.clear();
    if constexpr (Field::IsSearched)
    {
      this->Shared.ForEachRankAt(x, [&ranks](int rank) { ranks.push_back(rank); });
    }
    else
    {
      int index[3];
      double p[3];
      if (this->Shared.LocateIndex(x, index, p))
      {
        ranks.push_back(this->Ranks.FindRank(index));
      }
    }
  }

  /// Finds this process's cell at a position, and moves the walker to it.
  CellSearchResult Find(Walker& walker, const double x[3]) const
  {
    CellSearchResult finding;
    if constexpr (Field::IsSearched)
    {
      if (walker.Search(x, finding))
      {
        finding.Order = this->GetOrder(walker.GetCellLocation());
        walker.GoTo(finding.Cell);
      }
    }
    else
    {
      finding.IsFound = walker.Locate(x, finding.P);
      finding.Cell = walker.GetCell();
    }
    return finding;
  }

  /// Sets the number of search results to expect for position \a i.
  void Expect(vtkIdType i, std::size_t number) { this->Expected[i].Missing = number; }

  /// Best result so far, the process that found it, and the number of results still missing.
  struct Best
  {
    CellSearchResult Finding;
    int Rank = -1;
    std::size_t Missing = 0;
  };
  /// Adds the search result of a process for position \a i. If it was the last result expected,
  /// sets \a best and returns true.
  bool Take(vtkIdType i, int rank, const CellSearchResult& finding, Best& best)
  {
    const auto expected = this->Expected.find(i);
    if (finding.IsBefore(expected->second.Finding))
    {
      expected->second.Finding = finding;
      expected->second.Rank = rank;
    }
    if (--expected->second.Missing > 0)
    {
      return false;
    }
    best = expected->second;
    this->Expected.erase(expected);
    return true;
  }

private:
  /// Returns the Morton code of a cell in CellTree, which is the same in all processes.
  std::uint64_t GetOrder(const typename Field::CellLocation& location) const
  {
    Trilinear points;
    this->Shared.GetPoints(location, points);
    vtkBoundingBox box;
    for (int i = 0; i < CellShape::Of(this->Shared.GetShape(location)).NumberOfCorners; ++i)
    {
      box.AddPoint(points.C[i]);
    }
    double bounds[6];
    box.GetBounds(bounds);
    return this->Shared.GetTree().GetOrder(bounds);
  }

  const Field& Shared;
  const DistributedField& Ranks;
  std::unordered_map<vtkIdType, Best> Expected;
};

}

#endif
