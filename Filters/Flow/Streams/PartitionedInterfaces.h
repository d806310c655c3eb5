// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionedInterfaces_h
#define interlume_PartitionedInterfaces_h

#include "Fields/NonconformingInterfaces.h"
#include "Streams/MessageBytes.h"
#include "Streams/RankExchange.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   PartitionedInterfaces
 * @brief   counts nonconforming interfaces of a partitioned field
 */
struct PartitionedInterfaces
{
  /// Nonconforming interfaces of the whole grid.
  NonconformingInterfaces Open;
  /// True if one of these interfaces is between cells of two processes.
  bool IsBetweenRanks = false;

  /// Searches all processes for cells on the far side of the given faces of this process. \a faces
  /// must be sorted, and have no matching faces. Collective.
  template <typename Field>
  static PartitionedInterfaces Find(
    const Field& field, const std::vector<vtkIdType>& faces, RankExchange& exchange)
  {
    enum class Kind : int
    {
      Position,
      IsOpen
    };
    PartitionedInterfaces found;
    std::vector<char> isOpen(faces.size(), 0);
    bool isSent = false;
    const auto putHead = [&exchange](RankExchange::Bytes& bytes, Kind kind, std::size_t i)
    {
      MessageBytes::Put(bytes, kind);
      MessageBytes::Put(bytes, exchange.GetRank());
      MessageBytes::Put(bytes, i);
    };
    exchange.Run(
      [&](const RankExchange::Bytes& received, std::vector<RankExchange::Bytes>& sent)
      {
        for (std::size_t i = 0; !isSent && i < faces.size(); ++i)
        {
          double x[3];
          if (!NonconformingInterfaces::GetPositionOutside(field, faces[i], x))
          {
            continue;
          }
          isOpen[i] = NonconformingInterfaces::HasCell(field, faces[i] / 8, x) ? 1 : 0;
          field.ForEachRankAt(x,
            [&](int rank)
            {
              if (rank != exchange.GetRank() && !isOpen[i])
              {
                RankExchange::Bytes& bytes = sent[static_cast<std::size_t>(rank)];
                putHead(bytes, Kind::Position, i);
                for (const double coordinate : x)
                {
                  MessageBytes::Put(bytes, coordinate);
                }
              }
            });
        }
        isSent = true;
        for (const char* at = received.data(); at < received.data() + received.size();)
        {
          Kind kind;
          int rank = 0;
          std::size_t i = 0;
          MessageBytes::Get(at, kind);
          MessageBytes::Get(at, rank);
          MessageBytes::Get(at, i);
          if (kind == Kind::IsOpen)
          {
            isOpen[i] = 1;
            found.IsBetweenRanks = true;
            continue;
          }
          double x[3];
          MessageBytes::Get(at, x);
          if (NonconformingInterfaces::HasCell(field, -1, x))
          {
            putHead(sent[static_cast<std::size_t>(rank)], Kind::IsOpen, i);
          }
        }
        return true;
      });
    std::vector<vtkIdType> number{ std::count(isOpen.begin(), isOpen.end(), 1) };
    const auto open = std::find(isOpen.begin(), isOpen.end(), 1);
    // Compute the minimum as the maximum of the negated values.
    std::vector<double> minimum{ open == isOpen.end()
        ? -VTK_DOUBLE_MAX
        : -static_cast<double>(faces[static_cast<std::size_t>(open - isOpen.begin())] / 8) };
    exchange.ReduceSum(number);
    exchange.ReduceMax(minimum);
    found.Open.Number = number[0];
    found.Open.FirstCell = number[0] > 0 ? static_cast<vtkIdType>(-minimum[0]) : -1;
    found.IsBetweenRanks = exchange.IsAnywhere(found.IsBetweenRanks);
    return found;
  }
};

}

#endif
