// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexProjection.h"

#include "Common/FunctionClones.h"
#include "Common/Lanes.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace interlume
{

namespace
{
using Four = Lanes<4>;
// What takes the place of double where that would lose too many digits.
using Extended = long double;

// What Lanes have, for one number.
Extended Select(bool mask, Extended a, Extended b)
{
  return mask ? a : b;
}
Extended Max(Extended a, Extended b)
{
  return std::max(a, b);
}
Extended Abs(Extended a)
{
  return std::abs(a);
}

[[gnu::always_inline]] inline Four Select(const Four::Mask& mask, const Four& a, const Four& b)
{
  return Four::Select(mask, a, b);
}
[[gnu::always_inline]] inline Four Max(const Four& a, const Four& b)
{
  return Four::Max(a, b);
}
[[gnu::always_inline]] inline Four Abs(const Four& a)
{
  return Four::Abs(a);
}

template <typename Number>
[[gnu::always_inline]] inline Number Of(double value)
{
  if constexpr (std::is_same_v<Number, Extended>)
  {
    return static_cast<Extended>(value);
  }
  else
  {
    return Number::Of(value);
  }
}

template <typename Number>
struct Vector
{
  Number X[3];

  [[gnu::always_inline]] friend Vector operator-(const Vector& a, const Vector& b)
  {
    return { { a.X[0] - b.X[0], a.X[1] - b.X[1], a.X[2] - b.X[2] } };
  }
};

template <typename Number>
[[gnu::always_inline]] inline Number Determinant(
  const Vector<Number>& a, const Vector<Number>& b, const Vector<Number>& c)
{
  const Number x = b.X[1] * c.X[2] - c.X[1] * b.X[2];
  const Number y = b.X[2] * c.X[0] - c.X[2] * b.X[0];
  const Number z = b.X[0] * c.X[1] - c.X[0] * b.X[1];
  return a.X[0] * x + a.X[1] * y + a.X[2] * z;
}

// The sums of the positive and of the negative numbers, both as amounts.
template <typename Number>
struct Sums
{
  Number Positive = Of<Number>(0.0);
  Number Negative = Of<Number>(0.0);

  [[gnu::always_inline]] void Add(const Number& value)
  {
    const Number none = Of<Number>(0.0);
    const auto isNegative = value < none;
    this->Positive = this->Positive + Select(isNegative, none, Abs(value));
    this->Negative = this->Negative + Select(isNegative, Abs(value), none);
  }
};

// The dependency of one simplex, as Extended, or of several, as Four.
template <typename Number>
struct Dependency
{
  using Mask = decltype(Number() < Number());
  static constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;

  Number Weights[NumberOfPoints];
  // The time at the thick point on one face less that on the other.
  Number Thickness;
  Mask IsPositive[NumberOfPoints];
  Mask IsNegative[NumberOfPoints];
  // Whether there is a thick point.
  Mask IsSolid;
  // Whether few digits were lost.
  Mask IsExact;

  // A point is x, y, z and the coordinate that is projected along; isZero tells which lambda are
  // known to be.
  [[gnu::always_inline]] Dependency(
    const Number (&points)[NumberOfPoints][4], const Mask (&isZero)[NumberOfPoints])
  {
    constexpr double small = 1.0 / (1LL << 44);
    constexpr double enough = 1.0 / (1 << 11);
    const Number zero = Of<Number>(0.0);
    const Number one = Of<Number>(1.0);
    Vector<Number> edges[NumberOfPoints - 1];
    Number longest = zero;
    for (int i = 1; i < NumberOfPoints; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        edges[i - 1].X[axis] = points[i][axis] - points[0][axis];
        longest = Max(longest, Abs(edges[i - 1].X[axis]));
      }
    }
    const Mask hasExtent = zero < longest;
    // Edges are scaled to size 1, so that no product overflows or vanishes.
    const Number scale = Select(hasExtent, longest, one);
    for (Vector<Number>& edge : edges)
    {
      for (Number& x : edge.X)
      {
        x = x / scale;
      }
    }
    // Times are counted from one among them.
    Number times[NumberOfPoints];
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      times[i] = points[i][3] - points[0][3];
    }
    const auto& [a, b, c, d] = edges;
    Number lambda[NumberOfPoints] = { Determinant(b - a, c - a, d - a), -Determinant(b, c, d),
      Determinant(a, c, d), -Determinant(a, b, d), Determinant(a, b, c) };
    Sums<Number> all;
    Number content = zero;
    Number longestTime = zero;
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      lambda[i] = Select(isZero[i], zero, lambda[i]);
      all.Add(lambda[i]);
      content = content + lambda[i] * times[i];
      longestTime = Max(longestTime, Abs(times[i]));
    }
    const Number most = Max(all.Positive, all.Negative);
    // For a simplex that is thin in time, less may be left out.
    const Number share = Select(zero < longestTime, Abs(content) / (longestTime * most), one);
    Mask isExact = Of<Number>(enough) < most;
    Sums<Number> kept;
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      const Number size = Abs(lambda[i]);
      isExact = isExact & (Mask(small * most < size) | Mask(lambda[i] == zero));
      lambda[i] = Select(small * share * most < size, lambda[i], zero);
      this->IsPositive[i] = zero < lambda[i];
      this->IsNegative[i] = lambda[i] < zero;
      kept.Add(lambda[i]);
    }
    this->IsSolid = Mask(zero < kept.Positive) & Mask(zero < kept.Negative);
    this->Thickness = zero;
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      const Number sum = Select(this->IsNegative[i], kept.Negative, kept.Positive);
      const Number part = Select(this->IsSolid, lambda[i] / sum, zero);
      this->Thickness = this->Thickness + part * times[i];
      this->Weights[i] = 0.5 * Abs(part);
    }
    this->Thickness = Select(this->IsSolid, this->Thickness, zero);
    const Mask isThick =
      enough * longestTime < Select(this->IsSolid, Abs(this->Thickness), one + longestTime);
    const Mask isPoint = longest == zero;
    this->IsExact = (isExact & isThick) | isPoint;
  }
};

// The results of four simplices, one after the other.
struct FourResults
{
  static constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;

  Four Weights[NumberOfPoints];
  Four Thickness;
  alignas(Four::Size) long long Positive[Four::Number];
  alignas(Four::Size) long long Negative[Four::Number];
  unsigned int AreExact;
};

[[gnu::always_inline]] inline void ProjectFour(
  const SimplexProjection::Corners* points, const std::uint8_t* flats, FourResults& results)
{
  using Mask = Four::Mask;
  constexpr int size = SimplexProjection::NumberOfPoints;
  Four coordinates[size][4];
  Mask isZero[size];
  const Mask flat{ flats[0], flats[1], flats[2], flats[3] };
  for (int i = 0; i < size; ++i)
  {
    for (int axis = 0; axis < 4; ++axis)
    {
      coordinates[i][axis] = Four::OfEach([=](int lane) { return points[lane][i][axis]; });
    }
    isZero[i] = (flat & (1LL << i)) != 0;
  }
  const Dependency<Four> found(coordinates, isZero);
  Mask positive{};
  Mask negative{};
  for (int i = 0; i < size; ++i)
  {
    results.Weights[i] = found.Weights[i];
    positive |= found.IsPositive[i] & found.IsSolid & (1LL << i);
    negative |= found.IsNegative[i] & found.IsSolid & (1LL << i);
  }
  results.Thickness = found.Thickness;
  for (int lane = 0; lane < Four::Number; ++lane)
  {
    results.Positive[lane] = positive[lane];
    results.Negative[lane] = negative[lane];
  }
  results.AreExact = Four::GetBits(found.IsExact);
}

INTERLUME_AVX2_FUNCTION
void ProjectFourByAVX2(
  const SimplexProjection::Corners* points, const std::uint8_t* flats, FourResults& results)
{
  ProjectFour(points, flats, results);
}

void ProjectFourPlainly(
  const SimplexProjection::Corners* points, const std::uint8_t* flats, FourResults& results)
{
  ProjectFour(points, flats, results);
}
}

SimplexProjection::SimplexProjection(const Corners& points, unsigned flat)
{
  const std::uint8_t flats = static_cast<std::uint8_t>(flat);
  SimplexProjection::Project(&points, &flats, 1, this);
}

void SimplexProjection::ProjectExtended(const Corners& points, unsigned flat)
{
  Extended coordinates[NumberOfPoints][4];
  bool isZero[NumberOfPoints];
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    std::copy(points[i].begin(), points[i].end(), coordinates[i]);
    isZero[i] = ((flat >> i) & 1) != 0;
  }
  const Dependency<Extended> found(coordinates, isZero);
  unsigned int positive = 0;
  unsigned int negative = 0;
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    this->Weights[i] = static_cast<double>(found.Weights[i]);
    positive |= found.IsPositive[i] && found.IsSolid ? 1u << i : 0u;
    negative |= found.IsNegative[i] && found.IsSolid ? 1u << i : 0u;
  }
  this->Thickness = static_cast<double>(std::abs(found.Thickness));
  this->Signs = SimplexSigns(positive, negative, found.Thickness < 0);
}

template <typename ProjectFourOnes>
void SimplexProjection::ProjectEach(const Corners* points, const std::uint8_t* flats, int number,
  SimplexProjection* projections, ProjectFourOnes&& projectFour)
{
  for (int first = 0; first < number; first += Four::Number)
  {
    const int lanes = std::min(number - first, Four::Number);
    FourResults results;
    if (lanes == Four::Number)
    {
      projectFour(points + first, flats + first, results);
    }
    else
    {
      Corners fourPoints[Four::Number];
      std::uint8_t fourFlats[Four::Number];
      for (int lane = 0; lane < Four::Number; ++lane)
      {
        const int one = first + std::min(lane, lanes - 1);
        fourPoints[lane] = points[one];
        fourFlats[lane] = flats[one];
      }
      projectFour(fourPoints, fourFlats, results);
    }
    for (int lane = 0; lane < lanes; ++lane)
    {
      SimplexProjection& projection = projections[first + lane];
      if (((results.AreExact >> lane) & 1u) == 0)
      {
        projection.ProjectExtended(points[first + lane], flats[first + lane]);
        continue;
      }
      for (int i = 0; i < NumberOfPoints; ++i)
      {
        projection.Weights[i] = results.Weights[i].Get(lane);
      }
      const double thickness = results.Thickness.Get(lane);
      projection.Thickness = std::abs(thickness);
      projection.Signs = SimplexSigns(static_cast<unsigned int>(results.Positive[lane]),
        static_cast<unsigned int>(results.Negative[lane]), thickness < 0);
    }
  }
}

void SimplexProjection::Project(
  const Corners* points, const std::uint8_t* flats, int number, SimplexProjection* projections)
{
  if (INTERLUME_HAS_AVX2)
  {
    ProjectEach(points, flats, number, projections, ProjectFourByAVX2);
  }
  else
  {
    ProjectPlainly(points, flats, number, projections);
  }
}

void SimplexProjection::ProjectPlainly(
  const Corners* points, const std::uint8_t* flats, int number, SimplexProjection* projections)
{
  ProjectEach(points, flats, number, projections, ProjectFourPlainly);
}

}
