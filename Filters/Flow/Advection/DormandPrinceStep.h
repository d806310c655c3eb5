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
 * @brief   one step of the Dormand-Prince method of order 5(4), with dense output of order 4
 *
 * See J. R. Dormand and P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl.
 * Math. 6 (1980). For the dense output and the stiffness test see E. Hairer, S. P. Norsett and G.
 * Wanner, "Solving Ordinary Differential Equations I", section II.6, and volume II, section IV.2.
 * The rate at the end of a step is the first rate of the next one. \a Number is double, or a
 * SimdPack for several streamlines.
 */
template <typename Number>
class DormandPrinceStep
{
public:
  using Math = NumberMath<Number>;
  using Mask = typename Math::Mask;

  /// Exponent of h in the error per unit of time.
  static constexpr int ErrorOrder = 4;
  static constexpr bool HasEndRate = true;
  /// Number of rates that a step evaluates, excluding the first.
  static constexpr int NumberOfRates = 6;

  Number End[3];
  Number EndRate[3];
  /// Error of the embedded solution of order 4.
  Number Error[3];

  /// Computes a step. \a first is the rate at \a p. Returns a mask that is true where error and end
  /// are finite.
  template <typename Rate>
  INTERLUME_RETURNS_VECTOR Mask Take(
    Rate& rate, const Number p[3], const Number first[3], const Number& step)
  {
    const Number h = step;
    this->Step = h;
    Number at[3];
    for (int i = 0; i < 3; ++i)
    {
      this->Start[i] = p[i];
      this->K1[i] = first[i];
      at[i] = p[i] + h * (1.0 / 5.0 * first[i]);
    }
    Number k2[3];
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
      this->SixthPoint[i] = p[i] +
        h *
          (9017.0 / 3168.0 * first[i] - 355.0 / 33.0 * k2[i] + 46732.0 / 5247.0 * this->K3[i] +
            49.0 / 176.0 * this->K4[i] - 5103.0 / 18656.0 * this->K5[i]);
    }
    rate(this->SixthPoint, this->K6);
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
    // 0 times infinity or NaN is NaN.
    Number check = 0.0 * this->Error[0];
    for (const Number& number :
      { this->Error[1], this->Error[2], this->End[0], this->End[1], this->End[2] })
    {
      check = check + 0.0 * number;
    }
    return check == Math::Of(0.0);
  }

  void GetDenseOutput(DenseOutput<Number>& dense) const
  {
    dense.Degree = 4;
    for (int i = 0; i < 3; ++i)
    {
      const Number displacement = this->End[i] - this->Start[i];
      const Number bend = this->Step * this->K1[i] - displacement;
      const Number twist = displacement - this->Step * this->EndRate[i] - bend;
      const Number fourth = this->Step *
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
   * Returns an estimate of h |lambda|, where lambda is the dominant eigenvalue of the Jacobian. The
   * last two stages are both at the end of the step. Their difference approximates the dominant
   * eigenvector if the field is stiff.
   */
  double GetStiffness() const
  {
    double points[3];
    double rates[3];
    this->GetEndDifference(points, rates);
    const double distance = Vectors::SafeLength(glm::make_vec3(points));
    return distance > std::numeric_limits<double>::min()
      ? this->Step * (Vectors::SafeLength(glm::make_vec3(rates)) / distance)
      : 0.0;
  }

  /**
   * Computes a direction in which the field may damp errors. Returns the step times the decay rate
   * in that direction, or a value <= 0 if there is no damping.
   */
  INTERLUME_RETURNS_VECTOR Number GetDamping(Number direction[3]) const
  {
    Number rates[3];
    this->GetEndDifference(direction, rates);
    const Number square = Math::Dot(direction, direction);
    return Math::Select(square > std::numeric_limits<double>::min(),
      -this->Step * (Math::Dot(direction, rates) / square), Math::Of(0.0));
  }

  /// Computes the difference between the last two stages, which are both at the end of the step,
  /// and the difference between their rates.
  void GetEndDifference(Number points[3], Number rates[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      points[i] = this->End[i] - this->SixthPoint[i];
      rates[i] = this->EndRate[i] - this->K6[i];
    }
  }

private:
  Number Step;
  Number Start[3];
  Number K1[3];
  Number K3[3];
  Number K4[3];
  Number K5[3];
  Number K6[3];
  Number SixthPoint[3];
};

}

#endif
