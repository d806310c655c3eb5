// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/DistinctPoints.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace interlume
{

namespace
{
struct IndexedPoint
{
  std::array<double, 3> X;
  vtkIdType Id;
};

/// Returns the exponent of a power of two above the largest extent of the points, or 0 if they have
/// no extent.
int FindUnit(const std::vector<IndexedPoint>& positions)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto ends = std::minmax_element(positions.begin(), positions.end(),
      [axis](const IndexedPoint& a, const IndexedPoint& b) { return a.X[axis] < b.X[axis]; });
    if (ends.first != positions.end())
    {
      // Use halves because the difference may overflow.
      largest = std::max(largest, ends.second->X[axis] / 2 - ends.first->X[axis] / 2);
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > 0.0 ? exponent + 1 : 0;
}
}

Error DistinctPoints::Take(vtkDataSet* input, const std::vector<bool>& isUsed)
{
  std::vector<IndexedPoint> positions;
  const vtkIdType number = input->GetNumberOfPoints();
  for (vtkIdType p = 0; p < number; ++p)
  {
    if (!isUsed[p])
    {
      continue;
    }
    IndexedPoint point{ { { 0.0, 0.0, 0.0 } }, p };
    input->GetPoint(p, point.X.data());
    if (!std::isfinite(point.X[0]) || !std::isfinite(point.X[1]) || !std::isfinite(point.X[2]))
    {
      std::ostringstream message;
      message << "Point " << p << " at (" << point.X[0] << ", " << point.X[1] << ", " << point.X[2]
              << ") is not finite.";
      return message.str();
    }
    positions.push_back(point);
  }
  if (positions.size() > static_cast<std::size_t>(std::numeric_limits<int>::max() / 8))
  {
    return std::to_string(positions.size()) + " points are more than TetGen supports.";
  }
  this->UnitExponent = FindUnit(positions);
  std::sort(positions.begin(), positions.end(),
    [](const IndexedPoint& a, const IndexedPoint& b)
    { return a.X < b.X || (a.X == b.X && a.Id < b.Id); });
  std::vector<vtkIdType> first(number, -1);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const bool isSame = i > 0 && positions[i].X == positions[i - 1].X;
    first[positions[i].Id] = isSame ? first[positions[i - 1].Id] : positions[i].Id;
    this->NumberOfMerged += isSame;
  }
  this->Indices.assign(number, -1);
  for (vtkIdType p = 0; p < number; ++p)
  {
    if (first[p] == p)
    {
      this->Indices[p] = static_cast<int>(this->SourceIds.size());
      this->SourceIds.push_back(p);
      std::array<double, 3> x;
      input->GetPoint(p, x.data());
      for (double coordinate : x)
      {
        this->Coordinates.push_back(std::ldexp(coordinate, -this->UnitExponent));
      }
    }
    else if (first[p] >= 0)
    {
      this->Indices[p] = this->Indices[first[p]];
    }
  }
  return {};
}

}
