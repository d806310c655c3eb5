// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexProjection.h"

#include "Common/SimdDispatch.h"
#include "Common/SimdPack.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace interlume
{

namespace
{
// Two number types: Four, a SIMD pack, projects four simplices at once, one per lane. Extended, a
// long double, projects a simplex for which double precision would lose too many digits.
using Four = SimdPack<4>;
using Extended = long double;

// Scalar counterparts of the SIMD functions.
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

// The sum of the positive numbers, and the absolute value of the sum of the negative numbers.
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

// The affine dependency of one simplex (Extended) or of four simplices (Four).
template <typename Number>
struct Dependency
{
  using Mask = decltype(Number() < Number());
  static constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;

  Number Weights[NumberOfPoints];
  // Signed difference of the times of the two faces at the thick point.
  Number Thickness;
  Mask IsPositive[NumberOfPoints];
  Mask IsNegative[NumberOfPoints];
  // If true, the simplex has a thick point.
  Mask IsSolid;
  // If true, double precision is sufficient.
  Mask IsExact;

  // A point has the coordinates x, y, z, and t along the projection direction. \a isZero marks each
  // lambda that is known to be zero.
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
    // Scale the edges so that their largest coordinate is 1 and no product overflows or underflows.
    const Number scale = Select(hasExtent, longest, one);
    for (Vector<Number>& edge : edges)
    {
      for (Number& x : edge.X)
      {
        x = x / scale;
      }
    }
    // Use times relative to the first point.
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
    const Number largest = Max(all.Positive, all.Negative);
    // The threshold for lambda is lower for a simplex that is thin relative to its extent in time.
    const Number fraction = Select(zero < longestTime, Abs(content) / (longestTime * largest), one);
    Mask isExact = Of<Number>(enough) < largest;
    Sums<Number> retained;
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      const Number size = Abs(lambda[i]);
      isExact = isExact & (Mask(small * largest < size) | Mask(lambda[i] == zero));
      lambda[i] = Select(small * fraction * largest < size, lambda[i], zero);
      this->IsPositive[i] = zero < lambda[i];
      this->IsNegative[i] = lambda[i] < zero;
      retained.Add(lambda[i]);
    }
    this->IsSolid = Mask(zero < retained.Positive) & Mask(zero < retained.Negative);
    this->Thickness = zero;
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      const Number sum = Select(this->IsNegative[i], retained.Negative, retained.Positive);
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

// The results of four simplices, one SIMD lane each.
struct FourResults
{
  static constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;

  Four Weights[NumberOfPoints];
  Four Thickness;
  alignas(Four::Size) long long Positive[Four::Number];
  alignas(Four::Size) long long Negative[Four::Number];
  unsigned int AreExact;
};

void ProjectFour(
  const SimplexProjection::Corners* points, const std::uint8_t* flats, FourResults& results)
{
  SimdDispatch::Call(
    [&]
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
    });
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

void SimplexProjection::Project(
  const Corners* points, const std::uint8_t* flats, int number, SimplexProjection* projections)
{
  for (int first = 0; first < number; first += Four::Number)
  {
    const int lanes = std::min(number - first, Four::Number);
    FourResults results;
    if (lanes == Four::Number)
    {
      ProjectFour(points + first, flats + first, results);
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
      ProjectFour(fourPoints, fourFlats, results);
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

}
