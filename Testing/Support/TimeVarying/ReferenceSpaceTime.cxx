// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceSpaceTime.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Meshes/ReferenceSplit.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <functional>

namespace reference
{

namespace
{

using Real = long double;

Real Determinant3(
  const std::array<std::array<Real, 4>, 4>& rows, int r, const std::array<int, 3>& c)
{
  return rows[r][c[0]] *
    (rows[r + 1][c[1]] * rows[r + 2][c[2]] - rows[r + 1][c[2]] * rows[r + 2][c[1]]) -
    rows[r][c[1]] *
    (rows[r + 1][c[0]] * rows[r + 2][c[2]] - rows[r + 1][c[2]] * rows[r + 2][c[0]]) +
    rows[r][c[2]] * (rows[r + 1][c[0]] * rows[r + 2][c[1]] - rows[r + 1][c[1]] * rows[r + 2][c[0]]);
}

/// A corner of a tetrahedron at one time step, with the value of the array.
struct SpaceTimeCorner
{
  SpaceTimePoint X;
  Real Value = 0;
};

SpaceTimeCorner CornerOf(const TimeStep& step, const char* array, const MeanPoint& mean)
{
  vtkDataSet* data = GetDataSet(step);
  SpaceTimeCorner corner;
  for (int i = 0; i < 3; ++i)
  {
    corner.X[i] = MeanOf<Real>(mean, [&](vtkIdType id) { return data->GetPoint(id)[i]; });
  }
  corner.X[3] = step.Time;
  if (array)
  {
    vtkDataArray* values = data->GetPointData()->GetArray(array);
    corner.Value = MeanOf<Real>(mean, [&](vtkIdType id) { return values->GetComponent(id, 0); });
  }
  return corner;
}

/// Returns the fraction of a simplex where lower <= function <= upper. It is 1 if the function is
/// constant and equal to a bound.
Real FractionBetween(std::vector<Real> values, Real lower, Real upper)
{
  const Real belowUpper = FractionBelow(values, upper);
  std::transform(values.begin(), values.end(), values.begin(), std::negate<>());
  return belowUpper + FractionBelow(values, -lower) - 1;
}

/// Returns the hypervolume of the region where lower <= array <= upper in the prism that a
/// tetrahedron forms between two time steps. Corners are sorted by their point ids, so neighboring
/// tetrahedra split the prism over their common triangle in the same way.
Real PrismBetween(const TimeStep& from, const TimeStep& to, const char* array, Real lower,
  Real upper, const SplitTetrahedron& split)
{
  std::array<int, 4> order = { 0, 1, 2, 3 };
  std::sort(order.begin(), order.end(),
    [&](int a, int b) {
      return std::make_pair(split[a].size(), split[a]) < std::make_pair(split[b].size(), split[b]);
    });
  int sign = 1;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      sign = order[j] > order[i] ? -sign : sign;
    }
  }
  std::array<SpaceTimeCorner, 4> bottom;
  std::array<SpaceTimeCorner, 4> top;
  for (int i = 0; i < 4; ++i)
  {
    bottom[i] = CornerOf(from, array, split[order[i]]);
    top[i] = CornerOf(to, array, split[order[i]]);
  }
  Real sum = 0;
  for (int turn = 0; turn < 4; ++turn)
  {
    // The 4-simplex of bottom corners 0 to `turn` and top corners `turn` to 3.
    std::array<SpaceTimePoint, 5> points;
    std::vector<Real> values;
    for (int i = 0; i < 5; ++i)
    {
      const SpaceTimeCorner& corner = i <= turn ? bottom[i] : top[i - 1];
      points[i] = corner.X;
      values.push_back(corner.Value);
    }
    // If the tetrahedron 0123 is positive, the 4-simplex is positive with top corner `turn` as its
    // last point. Moving this corner there from index turn + 1 takes 3 - turn swaps.
    const int parity = (3 - turn) % 2 == 0 ? 1 : -1;
    sum +=
      parity * SimplexHypervolume(points) * (array ? FractionBetween(values, lower, upper) : 1);
  }
  return sign * sum;
}

Real HypervolumeOf(const TimeSteps& steps, const char* array, Real lower, Real upper)
{
  Real sum = 0;
  for (size_t i = 0; i + 1 < steps.size(); ++i)
  {
    ForEachTetrahedron(GetDataSet(steps[i]),
      [&](vtkIdType, const SplitTetrahedron& split)
      { sum += PrismBetween(steps[i], steps[i + 1], array, lower, upper, split); });
  }
  return sum;
}

/// Returns the time during which a function that changes linearly from a to b is between bounds.
Real Duration(Real a, Real b, Real lower, Real upper, Real time)
{
  return time * FractionBetween({ a, b }, lower, upper);
}

}

long double SimplexHypervolume(const std::array<SpaceTimePoint, 5>& points)
{
  std::array<std::array<Real, 4>, 4> rows;
  for (const auto& [i, a] : AllIndices(4, 4))
  {
    rows[i][a] = points[i + 1][a] - points[0][a];
  }
  Real determinant = 0;
  constexpr std::array<int, 3> others[4] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };
  for (int c = 0; c < 4; ++c)
  {
    determinant += (c % 2 == 0 ? 1 : -1) * rows[0][c] * Determinant3(rows, 1, others[c]);
  }
  return determinant / 24;
}

long double FractionBelow(const std::vector<long double>& values, long double bound)
{
  std::vector<Real> below;
  std::vector<Real> above;
  for (Real value : values)
  {
    (value <= bound ? below : above).push_back(value - bound);
  }
  if (above.empty())
  {
    return 1;
  }
  // All values are relative to the bound, and y_1, y_2, ... are the values above it. Initially,
  // A_0 = 1 and A_k = 0 for k > 0. For each value x <= 0, A_k is replaced with
  // (y_k * A_k - x * A_{k-1}) / (y_k - x) in order of increasing k. The last A_k is the fraction.
  std::vector<Real> fractions(above.size() + 1, 0);
  fractions[0] = 1;
  for (Real x : below)
  {
    for (size_t k = 1; k <= above.size(); ++k)
    {
      fractions[k] = (above[k - 1] * fractions[k] - x * fractions[k - 1]) / (above[k - 1] - x);
    }
  }
  return fractions.back();
}

long double HypervolumeBetween(
  const TimeSteps& steps, const char* array, double lower, double upper)
{
  return HypervolumeOf(steps, array, lower, upper);
}

long double DomainHypervolume(const TimeSteps& steps)
{
  return HypervolumeOf(steps, nullptr, 0, 0);
}

long double DurationAt(const TimeSteps& steps, const char* array, double lower, double upper,
  const std::array<double, 3>& point)
{
  const std::array<Real, 3> x = { point[0], point[1], point[2] };
  Real sum = 0;
  bool found = false;
  ForEachTetrahedron(GetDataSet(steps.front()),
    [&](vtkIdType, const SplitTetrahedron& split)
    {
      std::array<std::array<Real, 3>, 4> corners;
      for (int i = 0; i < 4; ++i)
      {
        const SpaceTimePoint corner = CornerOf(steps.front(), nullptr, split[i]).X;
        corners[i] = { corner[0], corner[1], corner[2] };
      }
      const Real volume = Determinant(corners[0], corners[1], corners[2], corners[3]);
      std::array<Real, 4> weights;
      for (int i = 0; i < 4; ++i)
      {
        auto replaced = corners;
        replaced[i] = x;
        weights[i] = Determinant(replaced[0], replaced[1], replaced[2], replaced[3]) / volume;
      }
      if (found || *std::min_element(weights.begin(), weights.end()) < 0)
      {
        return;
      }
      found = true;
      std::vector<Real> values;
      for (const TimeStep& step : steps)
      {
        Real value = 0;
        for (int i = 0; i < 4; ++i)
        {
          value += weights[i] * CornerOf(step, array, split[i]).Value;
        }
        values.push_back(value);
      }
      for (size_t i = 0; i + 1 < steps.size(); ++i)
      {
        sum += Duration(values[i], values[i + 1], lower, upper, steps[i + 1].Time - steps[i].Time);
      }
    });
  return sum;
}

}
