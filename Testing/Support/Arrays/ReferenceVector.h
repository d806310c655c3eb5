// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceVector_h
#define ReferenceVector_h

#include <array>   // for the vectors
#include <cmath>   // for lengths
#include <cstddef> // for sizes

/**
 * Vector arithmetic for std::array.
 */
namespace reference
{

template <typename T, std::size_t N>
std::array<T, N>& operator+=(std::array<T, N>& a, const std::array<T, N>& b)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    a[i] += b[i];
  }
  return a;
}

template <typename T, std::size_t N>
std::array<T, N>& operator*=(std::array<T, N>& a, T factor)
{
  for (T& component : a)
  {
    component *= factor;
  }
  return a;
}

template <typename T, std::size_t N>
std::array<T, N> operator*(T factor, std::array<T, N> a)
{
  return a *= factor;
}

template <typename T, std::size_t N>
std::array<T, N> operator+(std::array<T, N> a, const std::array<T, N>& b)
{
  return a += b;
}

template <typename T, std::size_t N>
std::array<T, N> operator-(const std::array<T, N>& a, const std::array<T, N>& b)
{
  return a + T(-1) * b;
}

template <typename T>
T Dot(const std::array<T, 3>& a, const std::array<T, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename T>
std::array<T, 3> Cross(const std::array<T, 3>& a, const std::array<T, 3>& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

/// Returns the length of a vector, without overflow for large components.
template <typename T>
T GetNorm(const std::array<T, 3>& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

/// Returns whether a point is inside or on bounds in the order of vtkDataSet::GetBounds().
inline bool IsWithin(const double* x, const double* bounds)
{
  return x[0] >= bounds[0] && x[0] <= bounds[1] && x[1] >= bounds[2] && x[1] <= bounds[3] &&
    x[2] >= bounds[4] && x[2] <= bounds[5];
}

}

#endif
