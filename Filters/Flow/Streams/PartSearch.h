// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartSearch_h
#define interlume_PartSearch_h

#include "Cells/CellFinding.h"
#include "Cells/CellShape.h"
#include "Cells/Trilinear.h"
#include "Streams/RankField.h"

#include "vtkBoundingBox.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace interlume
{

/**
 * @class   PartSearch
 * @brief   in which process's part of a field positions are
 *
 * On images and rectilinear grids a position tells its cell, and that its process. Elsewhere
 * several processes may have a cell there. All of them are asked, and the first of their findings
 * counts (CellFinding).
 */
template <typename Walker>
class PartSearch
{
public:
  using Field = typename Walker::Field;

  PartSearch(const Field& field, const RankField& ranks)
    : Shared(field)
    , Ranks(ranks)
  {
  }

  /// Finds the processes that may have the cell at a position.
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

  /// Finds the own cell at a position, and stands in it.
  CellFinding Find(Walker& walker, const double x[3]) const
  {
    CellFinding finding;
    if constexpr (Field::IsSearched)
    {
      if (walker.Search(x, finding))
      {
        finding.Order = this->GetOrder(walker.GetPlace());
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

  /// Begins to wait for what a number of processes find at the position with number \a i.
  void Expect(vtkIdType i, std::size_t number) { this->Expected[i].Missing = number; }

  /// The first of all findings, and whose it is.
  struct Best
  {
    CellFinding Finding;
    int Rank = -1;
    std::size_t Missing = 0;
  };
  /// Takes what a process has found at the position with number \a i. Returns whether it was the
  /// last one to wait for.
  bool Take(vtkIdType i, int rank, const CellFinding& finding, Best& best)
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
  /// Returns the place of a cell in the order of the trees.
  std::uint64_t GetOrder(const typename Field::Place& place) const
  {
    Trilinear points;
    this->Shared.GetPoints(place, points);
    vtkBoundingBox box;
    for (int i = 0; i < CellShape::Of(this->Shared.GetShape(place)).NumberOfCorners; ++i)
    {
      box.AddPoint(points.C[i]);
    }
    double bounds[6];
    box.GetBounds(bounds);
    return this->Shared.GetTree().GetOrder(bounds);
  }

  const Field& Shared;
  const RankField& Ranks;
  std::unordered_map<vtkIdType, Best> Expected;
};

}

#endif
