// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BernsteinRoot_h
#define interlume_BernsteinRoot_h

#include "Numerics/Binomials.h"
#include "Numerics/NumberMath.h"

namespace interlume
{

/**
 * @class   BernsteinRoot
 * @brief   finds where a polynomial in Bernstein form first becomes negative in [0, 1]
 *
 * The polynomial is bisected until its coefficients change sign once, which means one root
 * (Descartes' rule of signs), or not at all, which means no root. See J. M. Lane and R. F.
 * Riesenfeld, "Bounds on a polynomial", BIT 21 (1981). Therefore no pair of roots is missed, unless
 * the roots are too close to separate in double precision.
 */
class BernsteinRoot
{
public:
  static constexpr int MaximumDegree = Binomials::MaximumDegree;
  /// Value that Find returns if the polynomial does not become negative.
  static constexpr double None = 2.0;

  /// Returns the first position in [0, 1] at which the polynomial becomes negative. Its value at 0
  /// must be >= 0.
  static double Find(const double* coefficients, int degree)
  {
    return BernsteinRoot::FindInInterval(coefficients, degree, 0.0, 1.0, 44);
  }

  /**
   * Returns the only root of a polynomial that is positive at 0 and negative at 1. Uses Newton's
   * method in the power basis, with a bracket as a safeguard. Lanes outside \a mask return
   * arbitrary values.
   */
  template <typename Number>
  INTERLUME_RETURNS_VECTOR static Number FindSingleRoot(
    const Number* b, int degree, const typename NumberMath<Number>::Mask& mask)
  {
    using Math = NumberMath<Number>;
    Number powers[MaximumDegree + 1];
    BernsteinRoot::GetPowers(b, degree, powers);
    // Upper bound on half the absolute second derivative.
    Number bend = Math::Of(0.0);
    for (int k = 2; k <= degree; ++k)
    {
      bend = bend + (0.5 * k * (k - 1)) * Math::Abs(powers[k]);
    }
    const Number zero = Math::Of(0.0);
    Number low = zero;
    Number high = Math::Of(1.0);
    Number theta = BernsteinRoot::GuessSingleRoot(powers[0], powers[1], b[degree]);
    Number root = theta;
    typename Math::Mask isOpen = mask;
    for (int iteration = 0; iteration < 100 && Math::IsAny(isOpen); ++iteration)
    {
      Number value = powers[degree];
      Number slope = zero;
      for (int i = degree - 1; i >= 0; --i)
      {
        slope = slope * theta + value;
        value = value * theta + powers[i];
      }
      const typename Math::Mask isBelow = value < zero;
      high = Math::Select(isBelow, theta, high);
      low = Math::Select(isBelow, low, theta);
      Number next = theta - value / slope;
      const typename Math::Mask isNewton = (low < next) & (next < high);
      const Number halved = Math::Select(value == zero, theta, 0.5 * (low + high));
      next = Math::Select(isNewton, next, halved);
      // After a Newton step, the error is at most bend / slope times the square of the step.
      const Number change = next - theta;
      const typename Math::Mask isDone =
        (isNewton & (bend * (change * change) <= 1e-14 * Math::Abs(slope))) |
        (Math::Abs(change) <= 2e-16) | (next == low) | (next == high);
      root = Math::Select(isOpen, next, root);
      isOpen &= Math::Not(isDone);
      theta = next;
    }
    return root;
  }

private:
  static double FindInInterval(const double* b, int degree, double from, double width, int depth);

  /// Estimates the root from the parabola with the given value and slope at 0 and value at 1, or
  /// from a line if the parabola has no root in (0, 1).
  template <typename Number>
  INTERLUME_RETURNS_VECTOR static Number GuessSingleRoot(
    const Number& start, const Number& slope, const Number& end)
  {
    using Math = NumberMath<Number>;
    const Number bend = end - start - slope;
    const Number square = slope * slope - 4.0 * bend * start;
    const Number divisor = Math::Sqrt(square) - slope;
    const Number theta = 2.0 * start / divisor;
    return Math::Select((theta > 0.0) & (theta < Math::Of(1.0)), theta, start / (start - end));
  }

  template <typename Number>
  static void GetPowers(const Number* b, int degree, Number* powers)
  {
    Number differences[MaximumDegree + 1];
    for (int i = 0; i <= degree; ++i)
    {
      differences[i] = b[i];
    }
    const double* binomials = Binomials::Get().Choose[degree];
    for (int k = 0; k <= degree; ++k)
    {
      powers[k] = binomials[k] * differences[0];
      for (int i = 0; i < degree - k; ++i)
      {
        differences[i] = differences[i + 1] - differences[i];
      }
    }
  }
};

inline double BernsteinRoot::FindInInterval(
  const double* b, int degree, double from, double width, int depth)
{
  int changes = 0;
  for (int i = 1; i <= degree; ++i)
  {
    changes += (b[i - 1] < 0.0) != (b[i] < 0.0);
  }
  if (b[0] < 0.0)
  {
    return from;
  }
  if (changes == 0)
  {
    return None;
  }
  if (changes == 1)
  {
    return from + width * BernsteinRoot::FindSingleRoot(b, degree, true);
  }
  if (depth == 0)
  {
    return b[degree] < 0.0 ? from : None;
  }
  double left[MaximumDegree + 1] = {};
  double right[MaximumDegree + 1] = {};
  for (int i = 0; i <= degree; ++i)
  {
    right[i] = b[i];
  }
  left[0] = b[0];
  for (int level = 1; level <= degree; ++level)
  {
    for (int i = 0; i <= degree - level; ++i)
    {
      right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    left[level] = right[0];
  }
  const double root = BernsteinRoot::FindInInterval(left, degree, from, 0.5 * width, depth - 1);
  return root != None
    ? root
    : BernsteinRoot::FindInInterval(right, degree, from + 0.5 * width, 0.5 * width, depth - 1);
}

}

#endif
