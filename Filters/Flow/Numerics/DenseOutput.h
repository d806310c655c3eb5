// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DenseOutput_h
#define interlume_DenseOutput_h

#include "Numerics/Binomials.h"

namespace interlume
{

/**
 * @class   DenseOutput
 * @brief   where a step of an integrator is between its ends: a polynomial of theta, 0 to 1
 *
 * p(theta) = sum of Coefficients[k] theta^k.
 */
struct DenseOutput
{
  static constexpr int MaximumDegree = Binomials::MaximumDegree;

  int Degree = 0;
  double Coefficients[MaximumDegree + 1][3] = {};

  void GetPoint(double theta, double p[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      double sum = this->Coefficients[this->Degree][i];
      for (int k = this->Degree - 1; k >= 0; --k)
      {
        sum = sum * theta + this->Coefficients[k][i];
      }
      p[i] = sum;
    }
  }

  /// Computes the derivative dp/dtheta.
  void GetDerivative(double theta, double d[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      double sum = this->Degree * this->Coefficients[this->Degree][i];
      for (int k = this->Degree - 1; k >= 1; --k)
      {
        sum = sum * theta + k * this->Coefficients[k][i];
      }
      d[i] = sum;
    }
  }

  /// Computes the Degree + 1 control points of the same curve in Bernstein's form.
  void GetControlPoints(double points[MaximumDegree + 1][3]) const
  {
    const auto& weights = Binomials::Get().Elevation[this->Degree];
    for (int j = 0; j <= this->Degree; ++j)
    {
      points[j][0] = points[j][1] = points[j][2] = 0.0;
      for (int k = 0; k <= j; ++k)
      {
        for (int i = 0; i < 3; ++i)
        {
          points[j][i] += weights[j][k] * this->Coefficients[k][i];
        }
      }
    }
  }

  /// Computes the Degree control points of dp/dtheta from those of the curve. Returns their number.
  int GetSlopes(const double points[MaximumDegree + 1][3], double slopes[MaximumDegree][3]) const
  {
    for (int j = 0; j < this->Degree; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        slopes[j][i] = this->Degree * (points[j + 1][i] - points[j][i]);
      }
    }
    return this->Degree;
  }
};

}

#endif
