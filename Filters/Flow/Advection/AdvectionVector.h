#ifndef interlume_AdvectionVector_h
#define interlume_AdvectionVector_h

#include <algorithm>
#include <cmath>

namespace interlume
{

/**
 * @class   AdvectionVector
 * @brief   vectors of three components, as Advection and its integrators need them
 */
struct AdvectionVector
{
  static double Dot(const double a[3], const double b[3])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /// Right where squares are not numbers any more, too.
  static double Length(const double v[3])
  {
    const double square = AdvectionVector::Dot(v, v);
    if (square > 1e-280 && square < 1e280)
    {
      return std::sqrt(square);
    }
    const double largest = AdvectionVector::Largest(v);
    if (!(largest > 0.0 && std::isfinite(largest)))
    {
      return square;
    }
    const double scaled[3] = { v[0] / largest, v[1] / largest, v[2] / largest };
    return largest * std::sqrt(AdvectionVector::Dot(scaled, scaled));
  }

  /// Of the longest of some.
  static double LargestLength(const double (*vectors)[3], int number)
  {
    double square = 0.0;
    double length = 0.0;
    for (int i = 0; i < number; ++i)
    {
      square = std::max(square, AdvectionVector::Dot(vectors[i], vectors[i]));
    }
    if (square > 1e-280 && square < 1e280)
    {
      return std::sqrt(square);
    }
    for (int i = 0; i < number; ++i)
    {
      length = std::max(length, AdvectionVector::Length(vectors[i]));
    }
    return length;
  }

  /// The largest absolute value.
  static double Largest(const double v[3])
  {
    return std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  }

  static bool IsFinite(const double v[3])
  {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  }
};

}

#endif
