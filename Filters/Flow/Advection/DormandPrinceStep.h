// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DormandPrinceStep_h
#define interlume_DormandPrinceStep_h

#include "Common/Vectors.h"
#include "Numerics/DenseOutput.h"

#include <limits>

namespace interlume
{

/**
 * @class   DormandPrinceStep
 * @brief   one step of the method of Dormand and Prince, order 5(4), dense output of order 4
 *
 * J. R. Dormand and P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math.
 * 6 (1980); dense output and test for stiffness as in E. Hairer, S. P. Norsett and G. Wanner,
 * "Solving Ordinary Differential Equations I", section II.6, and II, section IV.2. The rate at the
 * end is the first of the next step.
 */
class DormandPrinceStep
{
public:
  /// The power of the step by which the error per unit of time falls.
  static constexpr int ErrorOrder = 4;
  static constexpr bool HasEndRate = true;
  /// The rates that a step computes, without the first.
  static constexpr int NumberOfRates = 6;

  double End[3];
  double EndRate[3];
  /// The error of the solution of order 4.
  double Error[3];

  /// Takes a step. \a first is the rate at \a p. Returns false where a rate is not finite.
  template <typename Rate>
  bool Take(Rate& rate, const double p[3], const double first[3], double h)
  {
    this->Step = h;
    double at[3];
    for (int i = 0; i < 3; ++i)
    {
      this->Start[i] = p[i];
      this->K1[i] = first[i];
      at[i] = p[i] + h * (1.0 / 5.0 * first[i]);
    }
    double k2[3];
    rate(at, k2);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + h * (3.0 / 40.0 * first[i] + 9.0 / 40.0 * k2[i]);
    }
    rate(at, this->K3);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + h * (44.0 / 45.0 * first[i] - 56.0 / 15.0 * k2[i] + 32.0 / 9.0 * this->K3[i]);
    }
    rate(at, this->K4);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] +
        h *
          (19372.0 / 6561.0 * first[i] - 25360.0 / 2187.0 * k2[i] + 64448.0 / 6561.0 * this->K3[i] -
            212.0 / 729.0 * this->K4[i]);
    }
    rate(at, this->K5);
    for (int i = 0; i < 3; ++i)
    {
      this->SixthPlace[i] = p[i] +
        h *
          (9017.0 / 3168.0 * first[i] - 355.0 / 33.0 * k2[i] + 46732.0 / 5247.0 * this->K3[i] +
            49.0 / 176.0 * this->K4[i] - 5103.0 / 18656.0 * this->K5[i]);
    }
    rate(this->SixthPlace, this->K6);
    for (int i = 0; i < 3; ++i)
    {
      this->End[i] = p[i] +
        h *
          (35.0 / 384.0 * first[i] + 500.0 / 1113.0 * this->K3[i] + 125.0 / 192.0 * this->K4[i] -
            2187.0 / 6784.0 * this->K5[i] + 11.0 / 84.0 * this->K6[i]);
    }
    rate(this->End, this->EndRate);
    for (int i = 0; i < 3; ++i)
    {
      this->Error[i] = h *
        (71.0 / 57600.0 * first[i] - 71.0 / 16695.0 * this->K3[i] + 71.0 / 1920.0 * this->K4[i] -
          17253.0 / 339200.0 * this->K5[i] + 22.0 / 525.0 * this->K6[i] -
          1.0 / 40.0 * this->EndRate[i]);
    }
    return Vectors::IsFinite(glm::make_vec3(this->Error)) &&
      Vectors::IsFinite(glm::make_vec3(this->End));
  }

  void GetDenseOutput(DenseOutput& dense) const
  {
    dense.Degree = 4;
    for (int i = 0; i < 3; ++i)
    {
      const double way = this->End[i] - this->Start[i];
      const double bend = this->Step * this->K1[i] - way;
      const double twist = way - this->Step * this->EndRate[i] - bend;
      const double fourth = this->Step *
        (-12715105075.0 / 11282082432.0 * this->K1[i] +
          87487479700.0 / 32700410799.0 * this->K3[i] - 10690763975.0 / 1880347072.0 * this->K4[i] +
          701980252875.0 / 199316789632.0 * this->K5[i] - 1453857185.0 / 822651844.0 * this->K6[i] +
          69997945.0 / 29380423.0 * this->EndRate[i]);
      dense.Coefficients[0][i] = this->Start[i];
      dense.Coefficients[1][i] = this->Step * this->K1[i];
      dense.Coefficients[2][i] = twist - bend + fourth;
      dense.Coefficients[3][i] = -twist - 2.0 * fourth;
      dense.Coefficients[4][i] = fourth;
    }
  }

  /**
   * Returns the step times the largest eigenvalue's absolute value, as the last two stages see it:
   * both are at the step's end, and differ by what a stiff field blows up.
   */
  double GetStiffness() const
  {
    double places[3];
    double rates[3];
    for (int i = 0; i < 3; ++i)
    {
      places[i] = this->End[i] - this->SixthPlace[i];
      rates[i] = this->EndRate[i] - this->K6[i];
    }
    const double apart = Vectors::SafeLength(glm::make_vec3(places));
    return apart > std::numeric_limits<double>::min()
      ? this->Step * (Vectors::SafeLength(glm::make_vec3(rates)) / apart)
      : 0.0;
  }

  /**
   * Computes a direction in which a stiff field damps, and returns by how much: the step times the
   * rate of decay, as GetStiffness finds it; 0 or below where it does not damp.
   */
  double GetDamping(double direction[3]) const
  {
    double rates[3];
    for (int i = 0; i < 3; ++i)
    {
      direction[i] = this->End[i] - this->SixthPlace[i];
      rates[i] = this->EndRate[i] - this->K6[i];
    }
    const double square = Vectors::Dot(direction, direction);
    return square > std::numeric_limits<double>::min()
      ? -this->Step * (Vectors::Dot(direction, rates) / square)
      : 0.0;
  }

private:
  double Step;
  double Start[3];
  double K1[3];
  double K3[3];
  double K4[3];
  double K5[3];
  double K6[3];
  double SixthPlace[3];
};

}

#endif
