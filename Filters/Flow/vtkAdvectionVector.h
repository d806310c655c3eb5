#ifndef vtkAdvectionVector_h
#define vtkAdvectionVector_h

#include <algorithm>
#include <cmath>

/**
 * @class   vtkAdvectionVector
 * @brief   vectors of three components, as vtkAdvection and its integrators need them
 */
struct vtkAdvectionVector
{
  static double Dot(const double a[3], const double b[3])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /// Right where squares are not numbers any more, too.
  static double Length(const double v[3])
  {
    const double square = vtkAdvectionVector::Dot(v, v);
    if (square > 1e-280 && square < 1e280)
    {
      return std::sqrt(square);
    }
    const double largest = vtkAdvectionVector::Largest(v);
    if (!(largest > 0.0 && std::isfinite(largest)))
    {
      return square;
    }
    const double scaled[3] = { v[0] / largest, v[1] / largest, v[2] / largest };
    return largest * std::sqrt(vtkAdvectionVector::Dot(scaled, scaled));
  }

  /// Of the longest of some.
  static double LargestLength(const double (*vectors)[3], int number)
  {
    double square = 0.0;
    double length = 0.0;
    for (int i = 0; i < number; ++i)
    {
      square = std::max(square, vtkAdvectionVector::Dot(vectors[i], vectors[i]));
    }
    if (square > 1e-280 && square < 1e280)
    {
      return std::sqrt(square);
    }
    for (int i = 0; i < number; ++i)
    {
      length = std::max(length, vtkAdvectionVector::Length(vectors[i]));
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

#endif
