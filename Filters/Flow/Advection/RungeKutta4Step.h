// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RungeKutta4Step_h
#define interlume_RungeKutta4Step_h

#include "Common/Vectors.h"
#include "Numerics/DenseOutput.h"

namespace interlume
{

/**
 * @class   RungeKutta4Step
 * @brief   two half steps of the classical Runge-Kutta method, with one full step as error estimate
 *
 * This is the adaptive fourth-order method of C. Zhang's dissertation (Ohio State University,
 * 2006). The error is Richardson's estimate (E. Hairer, S. P. Norsett and G. Wanner, "Solving
 * Ordinary Differential Equations I", section II.4). The result is the end of the two half steps,
 * without extrapolation. The dense output is the polynomial of degree 5 through the points and
 * rates at the start, midpoint and end.
 */
class RungeKutta4Step
{
public:
  /// Exponent of h in the error per unit of time.
  static constexpr int ErrorOrder = 4;
  static constexpr bool HasEndRate = true;

  double End[3];
  double EndRate[3];
  double Error[3];

  /// Computes a step. \a first is the rate at \a p. Returns false if a rate is not finite.
  template <typename Rate>
  bool Take(Rate& rate, const double p[3], const double first[3], double h)
  {
    this->Step = h;
    double fullStep[3];
    RungeKutta4Step::ComputeStep(rate, p, first, h, fullStep);
    RungeKutta4Step::ComputeStep(rate, p, first, 0.5 * h, this->Midpoint);
    rate(this->Midpoint, this->MidpointRate);
    RungeKutta4Step::ComputeStep(rate, this->Midpoint, this->MidpointRate, 0.5 * h, this->End);
    rate(this->End, this->EndRate);
    for (int i = 0; i < 3; ++i)
    {
      this->Start[i] = p[i];
      this->StartRate[i] = first[i];
      this->Error[i] = (this->End[i] - fullStep[i]) / 15.0;
    }
    return Vectors::IsFinite(glm::make_vec3(this->Error)) &&
      Vectors::IsFinite(glm::make_vec3(this->EndRate));
  }

  void GetDenseOutput(DenseOutput<double>& dense) const
  {
    dense.Degree = 5;
    for (int i = 0; i < 3; ++i)
    {
      const double start = this->Step * this->StartRate[i];
      // Points and slopes relative to the tangent at the start.
      const double end = this->End[i] - this->Start[i] - start;
      const double endSlope = this->Step * this->EndRate[i] - start;
      const double midpoint = this->Midpoint[i] - this->Start[i] - 0.5 * start;
      const double midpointSlope = this->Step * this->MidpointRate[i] - start;
      dense.Coefficients[0][i] = this->Start[i];
      dense.Coefficients[1][i] = start;
      dense.Coefficients[2][i] = 7.0 * end - endSlope + 16.0 * midpoint - 8.0 * midpointSlope;
      dense.Coefficients[3][i] =
        -34.0 * end + 5.0 * endSlope - 32.0 * midpoint + 32.0 * midpointSlope;
      dense.Coefficients[4][i] =
        52.0 * end - 8.0 * endSlope + 16.0 * midpoint - 40.0 * midpointSlope;
      dense.Coefficients[5][i] = -24.0 * end + 4.0 * endSlope + 16.0 * midpointSlope;
    }
  }

  /// Returns 0: the method provides no estimate of the damping.
  double GetDamping(double*) const { return 0.0; }

private:
  template <typename Rate>
  static void ComputeStep(
    Rate& rate, const double p[3], const double first[3], double h, double end[3])
  {
    double at[3];
    double k2[3];
    double k3[3];
    double k4[3];
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + 0.5 * h * first[i];
    }
    rate(at, k2);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + 0.5 * h * k2[i];
    }
    rate(at, k3);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + h * k3[i];
    }
    rate(at, k4);
    for (int i = 0; i < 3; ++i)
    {
      end[i] = p[i] + h / 6.0 * (first[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    }
  }

  double Step;
  double Start[3];
  double StartRate[3];
  double Midpoint[3];
  double MidpointRate[3];
};

}

#endif
