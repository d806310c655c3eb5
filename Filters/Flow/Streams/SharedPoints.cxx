// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/SharedPoints.h"

#include "Streams/MessageBytes.h"
#include "Streams/RankBoxes.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <utility>

namespace interlume
{

std::vector<vtkIdType> SharedPoints::FindRepeated(
  const std::vector<vtkIdType>& points, const ArrayRows& positions, RankExchange& exchange)
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
  RankBoxes boxes;
  boxes.Build(exchange, own.empty() ? nullptr : bounds);
  std::vector<vtkIdType> repeated;
  bool isSent = false;
  exchange.Run(
    [&](const RankExchange::Bytes& received, std::vector<RankExchange::Bytes>& sent)
    {
      for (std::size_t i = 0; !isSent && i < own.size(); ++i)
      {
        boxes.ForEachAt(own[i].first.data(), 0.0,
          [&](int rank)
          {
            if (rank > exchange.GetRank())
            {
              MessageBytes::Put(sent[static_cast<std::size_t>(rank)], own[i].first);
            }
          });
      }
      isSent = true;
      for (const char* at = received.data(); at < received.data() + received.size();)
      {
        Position x;
        MessageBytes::Get(at, x);
        for (auto found = std::lower_bound(own.begin(), own.end(), std::make_pair(x, vtkIdType(0)));
             found != own.end() && found->first == x; ++found)
        {
          repeated.push_back(found->second);
        }
      }
      return true;
    });
  std::sort(repeated.begin(), repeated.end());
  repeated.erase(std::unique(repeated.begin(), repeated.end()), repeated.end());
  return repeated;
}

}
