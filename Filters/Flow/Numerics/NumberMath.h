// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_NumberMath_h
#define interlume_NumberMath_h

#include "Common/SimdPack.h"

#include <cmath>

namespace interlume
{

/// Dot product of vectors of doubles or SIMD packs.
template <typename Number>
struct ScalarProduct
{
  [[gnu::always_inline]] static Number Dot(const Number a[3], const Number b[3])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
};

/**
 * @class   NumberMath
 * @brief   provides operations for templates whose number type is double or a SimdPack
 *
 * The mask type of double is bool. Negate masks with Not, because ~ of a bool is always true.
 */
template <typename Number>
struct NumberMath
  : Number
  , ScalarProduct<Number>
{
  using Mask = typename Number::Mask;
  [[gnu::always_inline]] static Mask Not(const Mask& mask) { return ~mask; }
};

template <>
struct NumberMath<double> : ScalarProduct<double>
{
  using Mask = bool;

  static double Of(double value) { return value; }
  static double Select(bool mask, double a, double b) { return mask ? a : b; }
  static double Min(double a, double b) { return b < a ? b : a; }
  static double Max(double a, double b) { return a < b ? b : a; }
  static double Abs(double a) { return std::abs(a); }
  static double Sqrt(double a) { return std::sqrt(a); }
  static bool IsAny(bool mask) { return mask; }
  static bool Not(bool mask) { return !mask; }
};

}

#endif
