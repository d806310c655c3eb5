// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Trilinear_h
#define interlume_Trilinear_h

namespace interlume
{

/**
 * @class   Trilinear
 * @brief   coefficients of three trilinear polynomials of p = (x, y, z)
 *
 * Row m of C contains the coefficients of one product of coordinates: 1, x, y, xy, z, xz, yz, xyz
 * for m = 0 to 7. Column i belongs to polynomial i. Rows have four elements so that compilers can
 * vectorize; the last column is unused.
 */
struct Trilinear
{
  alignas(32) double C[8][4];

  /// Converts values at the corners of [0,1]^3, ordered with x varying fastest, to coefficients.
  void Fit()
  {
    for (int bit = 1; bit < 8; bit *= 2)
    {
      for (int m = 0; m < 8; ++m)
      {
        if (m & bit)
        {
          this->Subtract(m, m ^ bit);
        }
      }
    }
  }

  void Subtract(int row, int other)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->C[row][i] -= this->C[other][i];
    }
  }

  void Clear(int row)
  {
    for (double& c : this->C[row])
    {
      c = 0.0;
    }
  }

  void Evaluate(const double p[3], double value[3]) const
  {
    const double x = p[0];
    const double y = p[1];
    const double z = p[2];
    const auto& c = this->C;
    double v[4];
    for (int i = 0; i < 4; ++i)
    {
      v[i] = ((c[0][i] + x * c[1][i]) + y * (c[2][i] + x * c[3][i])) +
        z * ((c[4][i] + x * c[5][i]) + y * (c[6][i] + x * c[7][i]));
    }
    Copy(v, value);
  }

  /// Evaluates a polynomial whose xy, xz, yz and xyz coefficients are 0.
  void EvaluateLinear(const double p[3], double value[3]) const
  {
    const auto& c = this->C;
    double v[4];
    for (int i = 0; i < 4; ++i)
    {
      v[i] = ((c[0][i] + p[0] * c[1][i]) + p[1] * c[2][i]) + p[2] * c[4][i];
    }
    Copy(v, value);
  }

  /// Computes the first derivatives: row j is the derivative along axis j.
  void EvaluateDerivatives(const double p[3], double d[3][4]) const
  {
    const double x = p[0];
    const double y = p[1];
    const double z = p[2];
    const auto& c = this->C;
    for (int i = 0; i < 4; ++i)
    {
      d[0][i] = (c[1][i] + y * c[3][i]) + z * (c[5][i] + y * c[7][i]);
      d[1][i] = (c[2][i] + x * c[3][i]) + z * (c[6][i] + x * c[7][i]);
      d[2][i] = (c[4][i] + x * c[5][i]) + y * (c[6][i] + x * c[7][i]);
    }
  }

  /// Computes the mixed second derivatives for xy, xz and yz. All other second derivatives are 0.
  void EvaluateMixedDerivatives(const double p[3], double d[3][4]) const
  {
    const auto& c = this->C;
    for (int i = 0; i < 4; ++i)
    {
      d[0][i] = c[3][i] + p[2] * c[7][i];
      d[1][i] = c[5][i] + p[1] * c[7][i];
      d[2][i] = c[6][i] + p[0] * c[7][i];
    }
  }

private:
  static void Copy(const double from[4], double to[3])
  {
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
  }
};

}

#endif
