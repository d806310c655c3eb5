// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/SharedPoints.h"

#include "Streams/MessageBytes.h"
#include "Streams/ProcessBounds.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace interlume
{

namespace
{
using Bytes = RankExchange::Bytes;

/// Sends points to the processes of higher rank that may share them. put(bytes, point) appends the
/// data of a point to a message. take(at, rank, point) reads these data and returns a pointer past
/// their end. For each received point, take is called once with point -1, and then with each point
/// of this process at the same position.
template <typename Put, typename Take>
void ExchangePoints(const std::vector<vtkIdType>& points, const ArrayRows& positions,
  RankExchange& exchange, Put&& put, Take&& take)
{
  using Position = std::array<double, 3>;
  std::vector<std::pair<Position, vtkIdType>> own;
  vtkBoundingBox box;
  for (const vtkIdType point : points)
  {
    Position x;
    positions.Get<3>(point, x.data());
    if (vtkMath::IsFinite(x[0]) && vtkMath::IsFinite(x[1]) && vtkMath::IsFinite(x[2]))
    {
      box.AddPoint(x.data());
      own.emplace_back(x, point);
    }
  }
  vtkSMPTools::Sort(own.begin(), own.end());
  double bounds[6];
  box.GetBounds(bounds);
  ProcessBounds boxes;
  boxes.Build(exchange, own.empty() ? nullptr : bounds);
  bool isSent = false;
  exchange.Run(
    [&](const Bytes& received, std::vector<Bytes>& sent)
    {
      for (std::size_t i = 0; !isSent && i < own.size(); ++i)
      {
        boxes.ForEachAt(own[i].first.data(), 0.0,
          [&](int rank)
          {
            if (rank > exchange.GetRank())
            {
              Bytes& bytes = sent[static_cast<std::size_t>(rank)];
              MessageBytes::Put(bytes, own[i].first);
              MessageBytes::Put(bytes, exchange.GetRank());
              put(bytes, own[i].second);
            }
          });
      }
      isSent = true;
      for (const char* at = received.data(); at < received.data() + received.size();)
      {
        Position x;
        int rank = 0;
        MessageBytes::Get(at, x);
        MessageBytes::Get(at, rank);
        const char* end = take(at, rank, -1);
        for (auto found = std::lower_bound(own.begin(), own.end(), std::make_pair(x, vtkIdType(0)));
             found != own.end() && found->first == x; ++found)
        {
          take(at, rank, found->second);
        }
        at = end;
      }
      return true;
    });
}
}

std::vector<vtkIdType> SharedPoints::FindRepeated(
  const std::vector<vtkIdType>& points, const ArrayRows& positions, RankExchange& exchange)
{
  std::vector<vtkIdType> repeated;
  ExchangePoints(
    points, positions, exchange, [](Bytes&, vtkIdType) {},
    [&repeated](const char* at, int, vtkIdType point)
    {
      if (point >= 0)
      {
        repeated.push_back(point);
      }
      return at;
    });
  std::sort(repeated.begin(), repeated.end());
  repeated.erase(std::unique(repeated.begin(), repeated.end()), repeated.end());
  return repeated;
}

void SharedPoints::CopyFromLowestRank(const ArrayRows& positions,
  const std::vector<vtkDataArray*>& arrays, vtkIdType numberOfPoints, RankExchange& exchange)
{
  std::vector<vtkIdType> points(static_cast<std::size_t>(numberOfPoints));
  std::iota(points.begin(), points.end(), 0);
  const auto getRow = [](vtkDataArray* array, vtkIdType point)
  { return static_cast<char*>(array->GetVoidPointer(point * array->GetNumberOfComponents())); };
  const auto getSize = [](vtkDataArray* array)
  { return static_cast<std::size_t>(array->GetNumberOfComponents() * array->GetDataTypeSize()); };
  std::unordered_map<vtkIdType, int> firsts;
  ExchangePoints(
    points, positions, exchange,
    [&](Bytes& bytes, vtkIdType point)
    {
      for (vtkDataArray* array : arrays)
      {
        const char* row = getRow(array, point);
        bytes.insert(bytes.end(), row, row + getSize(array));
      }
    },
    [&](const char* at, int rank, vtkIdType point)
    {
      int& first = firsts.emplace(point, exchange.GetRank()).first->second;
      const bool isFirst = point >= 0 && rank < first;
      first = isFirst ? rank : first;
      for (vtkDataArray* array : arrays)
      {
        if (isFirst)
        {
          std::copy_n(at, getSize(array), getRow(array, point));
        }
        at += getSize(array);
      }
      return at;
    });
}

}
