// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/PartitionedPatches.h"

#include "Streams/MessageBytes.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace interlume
{

namespace
{
template <typename Value>
void PutAll(RankExchange::Bytes& bytes, const std::vector<Value>& values)
{
  MessageBytes::Put(bytes, values.size());
  for (const Value& value : values)
  {
    MessageBytes::Put(bytes, value);
  }
}

template <typename Value>
void GetAll(const char*& at, std::vector<Value>& values)
{
  std::size_t number = 0;
  MessageBytes::Get(at, number);
  for (std::size_t i = 0; i < number; ++i)
  {
    values.emplace_back();
    MessageBytes::Get(at, values.back());
  }
}

/// Returns an id for each point of all processes. Points that are the same have the same id.
/// \a firsts contains the index of each process's first point.
std::vector<vtkIdType> Merge(
  const std::vector<std::array<double, 3>>& positions, const std::vector<vtkIdType>& firsts)
{
  std::vector<vtkIdType> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto get = [&positions](vtkIdType i) -> const std::array<double, 3>&
  { return positions[static_cast<std::size_t>(i)]; };
  vtkSMPTools::Sort(order.begin(), order.end(),
    [&get](vtkIdType i, vtkIdType j) { return std::tie(get(i), i) < std::tie(get(j), j); });
  std::vector<vtkIdType> ids(positions.size());
  const auto getRank = [&firsts](vtkIdType i)
  { return std::upper_bound(firsts.begin(), firsts.end(), i) - firsts.begin(); };
  for (std::size_t begin = 0; begin < order.size();)
  {
    // Process all points at one position. They are sorted by process.
    std::size_t end = begin;
    std::vector<vtkIdType> known;
    std::size_t ofRank = 0;
    for (; end < order.size() && get(order[end]) == get(order[begin]); ++end)
    {
      ofRank = end > begin && getRank(order[end]) == getRank(order[end - 1]) ? ofRank + 1 : 0;
      if (ofRank == known.size())
      {
        known.push_back(order[end]);
      }
      ids[static_cast<std::size_t>(order[end])] = known[ofRank];
    }
    begin = end;
  }
  return ids;
}
}

void PartitionedPatches::Build(const Surface& own, RankExchange& exchange, BoundaryPatches& patches)
{
  RankExchange::Bytes bytes;
  PutAll(bytes, own.Faces);
  PutAll(bytes, own.FaceCorners);
  PutAll(bytes, own.Positions);
  Surface all;
  std::vector<vtkIdType> firsts;
  for (const RankExchange::Bytes& part : exchange.Gather(bytes))
  {
    const char* at = part.data();
    const std::size_t before = all.FaceCorners.size();
    const auto first = static_cast<vtkIdType>(all.Positions.size());
    firsts.push_back(first);
    GetAll(at, all.Faces);
    GetAll(at, all.FaceCorners);
    GetAll(at, all.Positions);
    for (std::size_t face = before; face < all.FaceCorners.size(); ++face)
    {
      for (vtkIdType& point : all.FaceCorners[face].Points)
      {
        point += first;
      }
    }
  }
  const std::vector<vtkIdType> ids = Merge(all.Positions, firsts);
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(static_cast<vtkIdType>(all.Positions.size()));
  for (std::size_t i = 0; i < all.Positions.size(); ++i)
  {
    positions->SetTypedTuple(static_cast<vtkIdType>(i), all.Positions[i].data());
  }
  ArrayRows rows;
  rows.Build(positions);
  patches.Build(
    all.Faces,
    [&](vtkIdType face, vtkIdType* points)
    {
      const auto found = std::lower_bound(all.Faces.begin(), all.Faces.end(), face);
      const Corners& corners = all.FaceCorners[static_cast<std::size_t>(found - all.Faces.begin())];
      for (int i = 0; i < corners.Number; ++i)
      {
        points[i] = ids[static_cast<std::size_t>(corners.Points[i])];
      }
      return corners.Number;
    },
    rows);
}

}
