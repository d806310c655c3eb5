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
struct Place
{
  std::array<double, 3> X;
  vtkIdType Id;
};

/// Returns the power of two above the largest extent of the points, 0 if they have none.
int FindUnit(const std::vector<Place>& places)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto ends = std::minmax_element(places.begin(), places.end(),
      [axis](const Place& a, const Place& b) { return a.X[axis] < b.X[axis]; });
    if (ends.first != places.end())
    {
      // Halves, whose difference does not overflow.
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
  std::vector<Place> places;
  const vtkIdType number = input->GetNumberOfPoints();
  for (vtkIdType p = 0; p < number; ++p)
  {
    if (!isUsed[p])
    {
      continue;
    }
    Place place{ { { 0.0, 0.0, 0.0 } }, p };
    input->GetPoint(p, place.X.data());
    if (!std::isfinite(place.X[0]) || !std::isfinite(place.X[1]) || !std::isfinite(place.X[2]))
    {
      std::ostringstream words;
      words << "Point " << p << " at (" << place.X[0] << ", " << place.X[1] << ", " << place.X[2]
            << ") is not finite.";
      return words.str();
    }
    places.push_back(place);
  }
  if (places.size() > static_cast<std::size_t>(std::numeric_limits<int>::max() / 8))
  {
    return std::to_string(places.size()) + " points are more than TetGen can number.";
  }
  this->UnitExponent = FindUnit(places);
  std::sort(places.begin(), places.end(),
    [](const Place& a, const Place& b) { return a.X < b.X || (a.X == b.X && a.Id < b.Id); });
  std::vector<vtkIdType> first(number, -1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const bool isSame = i > 0 && places[i].X == places[i - 1].X;
    first[places[i].Id] = isSame ? first[places[i - 1].Id] : places[i].Id;
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
