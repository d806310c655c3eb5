// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Binomials_h
#define interlume_Binomials_h

namespace interlume
{

/**
 * @class   Binomials
 * @brief   coefficients for conversion between the power basis and the Bernstein basis, up to
 * degree 5
 *
 * Choose[n][k] is the binomial coefficient C(n, k). Elevation[n][j][k] is C(j, k) / C(n, k), the
 * weight of the coefficient of theta^k in control point j of a curve of degree n.
 */
struct Binomials
{
  static constexpr int MaximumDegree = 5;

  double Choose[MaximumDegree + 1][MaximumDegree + 1] = {};
  double Elevation[MaximumDegree + 1][MaximumDegree + 1][MaximumDegree + 1] = {};

  static const Binomials& Get();

private:
  static constexpr Binomials Make()
  {
    Binomials result;
    for (int n = 0; n <= MaximumDegree; ++n)
    {
      result.Choose[n][0] = 1.0;
      for (int k = 1; k <= n; ++k)
      {
        result.Choose[n][k] = result.Choose[n][k - 1] * (n - k + 1) / k;
      }
    }
    for (int n = 0; n <= MaximumDegree; ++n)
    {
      for (int j = 0; j <= n; ++j)
      {
        for (int k = 0; k <= j; ++k)
        {
          result.Elevation[n][j][k] = result.Choose[j][k] / result.Choose[n][k];
        }
      }
    }
    return result;
  }
};

inline const Binomials& Binomials::Get()
{
  static constexpr Binomials binomials = Make();
  return binomials;
}

}

#endif
