#ifndef vtkDualNumber_h
#define vtkDualNumber_h

#include <cmath>

/**
 * @class   vtkDualNumber
 * @brief   a number with its derivatives by three variables
 *
 * A formula written as a template of the type of its numbers gives its exact derivatives when it is
 * called with these.
 */
struct vtkDualNumber
{
  double Value = 0.0;
  double Derivatives[3] = { 0.0, 0.0, 0.0 };

  vtkDualNumber() = default;
  vtkDualNumber(double constant)
    : Value(constant)
  {
  }

  /// f(a), with f' = \a derivative there.
  static vtkDualNumber Apply(double value, double derivative, const vtkDualNumber& a)
  {
    vtkDualNumber result(value);
    for (int i = 0; i < 3; ++i)
    {
      result.Derivatives[i] = derivative * a.Derivatives[i];
    }
    return result;
  }

  /// f(a, b), with the partial derivatives \a fa and \a fb there.
  static vtkDualNumber Apply(
    double value, double fa, const vtkDualNumber& a, double fb, const vtkDualNumber& b)
  {
    vtkDualNumber result(value);
    for (int i = 0; i < 3; ++i)
    {
      result.Derivatives[i] = fa * a.Derivatives[i] + fb * b.Derivatives[i];
    }
    return result;
  }
};

inline vtkDualNumber operator-(const vtkDualNumber& a)
{
  return vtkDualNumber::Apply(-a.Value, -1.0, a);
}

inline vtkDualNumber operator+(const vtkDualNumber& a, const vtkDualNumber& b)
{
  return vtkDualNumber::Apply(a.Value + b.Value, 1.0, a, 1.0, b);
}

inline vtkDualNumber operator-(const vtkDualNumber& a, const vtkDualNumber& b)
{
  return vtkDualNumber::Apply(a.Value - b.Value, 1.0, a, -1.0, b);
}

inline vtkDualNumber operator*(const vtkDualNumber& a, const vtkDualNumber& b)
{
  return vtkDualNumber::Apply(a.Value * b.Value, b.Value, a, a.Value, b);
}

inline vtkDualNumber operator/(const vtkDualNumber& a, const vtkDualNumber& b)
{
  const double quotient = a.Value / b.Value;
  return vtkDualNumber::Apply(quotient, 1.0 / b.Value, a, -quotient / b.Value, b);
}

/// Functions for both kinds of numbers.
namespace vtkDualMath
{
inline double GetValue(double a)
{
  return a;
}
inline double GetValue(const vtkDualNumber& a)
{
  return a.Value;
}

inline double Sqrt(double a)
{
  return std::sqrt(a);
}
inline vtkDualNumber Sqrt(const vtkDualNumber& a)
{
  const double root = std::sqrt(a.Value);
  return vtkDualNumber::Apply(root, 0.5 / root, a);
}

inline double Sin(double a)
{
  return std::sin(a);
}
inline vtkDualNumber Sin(const vtkDualNumber& a)
{
  return vtkDualNumber::Apply(std::sin(a.Value), std::cos(a.Value), a);
}

inline double Cos(double a)
{
  return std::cos(a);
}
inline vtkDualNumber Cos(const vtkDualNumber& a)
{
  return vtkDualNumber::Apply(std::cos(a.Value), -std::sin(a.Value), a);
}

inline double Tanh(double a)
{
  return std::tanh(a);
}
inline vtkDualNumber Tanh(const vtkDualNumber& a)
{
  const double value = std::tanh(a.Value);
  return vtkDualNumber::Apply(value, 1.0 - value * value, a);
}

/// (1 - exp(-a)) / a, which is 1 at 0.
inline double Decay(double a)
{
  return a == 0.0 ? 1.0 : -std::expm1(-a) / a;
}
inline vtkDualNumber Decay(const vtkDualNumber& a)
{
  // Near 0 the difference below cancels: there the series of the derivative.
  const double x = a.Value;
  const double value = Decay(x);
  const double derivative = std::abs(x) < 1e-3
    ? -0.5 + x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x / 144.0)))
    : (std::exp(-x) - value) / x;
  return vtkDualNumber::Apply(value, derivative, a);
}
}

#endif
