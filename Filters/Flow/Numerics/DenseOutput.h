// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DenseOutput_h
#define interlume_DenseOutput_h

#include "Numerics/Binomials.h"
#include "Numerics/NumberMath.h"

namespace interlume
{

/**
 * @class   DenseOutput
 * @brief   polynomial p(theta), 0 <= theta <= 1, that interpolates a step of an integrator
 *
 * p(theta) = sum of Coefficients[k] theta^k. \a Number is double or a SimdPack.
 */
template <typename Number>
struct DenseOutput
{
  static constexpr int MaximumDegree = Binomials::MaximumDegree;

  int Degree = 0;
  Number Coefficients[MaximumDegree + 1][3];

  void GetPoint(const Number& theta, Number p[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      Number sum = this->Coefficients[this->Degree][i];
      for (int k = this->Degree - 1; k >= 0; --k)
      {
        sum = sum * theta + this->Coefficients[k][i];
      }
      p[i] = sum;
    }
  }

  /// Computes the derivative dp/dtheta.
  void GetDerivative(const Number& theta, Number d[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      Number sum = this->Degree * this->Coefficients[this->Degree][i];
      for (int k = this->Degree - 1; k >= 1; --k)
      {
        sum = sum * theta + k * this->Coefficients[k][i];
      }
      d[i] = sum;
    }
  }

  /// Computes the Degree + 1 Bernstein control points of the curve.
  void GetControlPoints(Number points[MaximumDegree + 1][3]) const
  {
    const auto& weights = Binomials::Get().Elevation[this->Degree];
    for (int j = 0; j <= this->Degree; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        Number sum = NumberMath<Number>::Of(0.0);
        for (int k = 0; k <= j; ++k)
        {
          sum = sum + weights[j][k] * this->Coefficients[k][i];
        }
        points[j][i] = sum;
      }
    }
  }

  /// Computes control point \a j of dp/dtheta, 0 <= j < Degree, from the control points of the
  /// curve.
  void GetSlope(const Number points[MaximumDegree + 1][3], int j, Number slope[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      slope[i] = double(this->Degree) * (points[j + 1][i] - points[j][i]);
    }
  }
};

}

#endif
