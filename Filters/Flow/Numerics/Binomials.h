// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Binomials_h
#define interlume_Binomials_h

namespace interlume
{

/**
 * @class   Binomials
 * @brief   coefficients that lead from powers to Bernstein's form and back, up to degree 5
 *
 * Choose[n][k] is n over k; Elevation[n][j][k] is (j over k) / (n over k), the part that the
 * coefficient of theta^k has in control point j of n.
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
    Binomials made;
    for (int n = 0; n <= MaximumDegree; ++n)
    {
      made.Choose[n][0] = 1.0;
      for (int k = 1; k <= n; ++k)
      {
        made.Choose[n][k] = made.Choose[n][k - 1] * (n - k + 1) / k;
      }
    }
    for (int n = 0; n <= MaximumDegree; ++n)
    {
      for (int j = 0; j <= n; ++j)
      {
        for (int k = 0; k <= j; ++k)
        {
          made.Elevation[n][j][k] = made.Choose[j][k] / made.Choose[n][k];
        }
      }
    }
    return made;
  }
};

inline const Binomials& Binomials::Get()
{
  static constexpr Binomials binomials = Make();
  return binomials;
}

}

#endif
