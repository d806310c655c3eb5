// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RosenbrockStep_h
#define interlume_RosenbrockStep_h

#include "Common/Vectors.h"
#include "Numerics/DenseOutput.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace interlume
{

/**
 * @class   RosenbrockStep
 * @brief   one step of RODAS, an L-stable and stiffly accurate Rosenbrock method of order 4(3)
 *
 * Each of the six stages solves a linear system with three unknowns. The dense output has order 3.
 * See E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II", sections IV.7 and
 * IV.10; the coefficients are from their program. Stage i solves
 *
 *     (1 / gamma - h J) u[i] = h f(p + sum a[i][j] u[j]) + sum c[i][j] u[j]
 */
class RosenbrockStep
{
public:
  /// Exponent of h in the error per unit of time.
  static constexpr int ErrorOrder = 3;
  static constexpr bool HasEndRate = false;

  double End[3];
  double EndRate[3] = {};
  double Error[3];

  /// Computes a step. \a first is the rate at \a p. Returns false if a rate is not finite or the
  /// system is singular.
  template <typename Rate>
  bool Take(Rate& rate, const double p[3], const double first[3], double h)
  {
    rate.GetJacobian(p, this->Jacobian);
    for (double& entry : this->Jacobian)
    {
      entry *= h;
    }
    if (!this->Factor())
    {
      return false;
    }
    double at[3];
    double f[3] = { first[0], first[1], first[2] };
    for (int stage = 0; stage < NumberOfStages; ++stage)
    {
      if (stage > 0)
      {
        for (int i = 0; i < 3; ++i)
        {
          double sum = 0.0;
          for (int j = 0; j < stage; ++j)
          {
            sum += A[stage][j] * this->U[j][i];
          }
          at[i] = p[i] + sum;
        }
        rate(at, f);
      }
      double* u = this->U[stage];
      for (int i = 0; i < 3; ++i)
      {
        double sum = h * f[i];
        for (int j = 0; j < stage; ++j)
        {
          sum += C[stage][j] * this->U[j][i];
        }
        u[i] = sum;
      }
      this->Solve(u);
    }
    for (int i = 0; i < 3; ++i)
    {
      this->Start[i] = p[i];
      this->Error[i] = this->U[NumberOfStages - 1][i];
      this->End[i] = at[i] + this->Error[i];
    }
    return Vectors::IsFinite(glm::make_vec3(this->Error)) &&
      Vectors::IsFinite(glm::make_vec3(this->End));
  }

  void GetDenseOutput(DenseOutput<double>& dense) const
  {
    dense.Degree = 3;
    for (int i = 0; i < 3; ++i)
    {
      double bend = 0.0;
      double twist = 0.0;
      for (int j = 0; j < NumberOfStages - 1; ++j)
      {
        bend += D[0][j] * this->U[j][i];
        twist += D[1][j] * this->U[j][i];
      }
      dense.Coefficients[0][i] = this->Start[i];
      dense.Coefficients[1][i] = this->End[i] - this->Start[i] + bend;
      dense.Coefficients[2][i] = twist - bend;
      dense.Coefficients[3][i] = -twist;
    }
  }

  /// Returns the step times the row-sum norm of the Jacobian, an upper bound of |h lambda|.
  double GetStiffness() const
  {
    double largest = 0.0;
    for (int row = 0; row < 9; row += 3)
    {
      largest = std::max(largest,
        std::abs(this->Jacobian[row]) + std::abs(this->Jacobian[row + 1]) +
          std::abs(this->Jacobian[row + 2]));
    }
    return largest;
  }

  /**
   * Computes the direction in which a stiff field damps the error. Returns the step times the decay
   * rate in that direction, or a value <= 0 if there is no damping.
   */
  double GetDamping(double direction[3]) const
  {
    double change[3];
    this->Multiply(this->Error, direction);
    this->Multiply(direction, change);
    const double square = Vectors::Dot(direction, direction);
    return square > std::numeric_limits<double>::min() ? -Vectors::Dot(direction, change) / square
                                                       : 0.0;
  }

private:
  static constexpr int NumberOfStages = 6;
  static constexpr double Gamma = 0.25;
  static constexpr double A[NumberOfStages][NumberOfStages - 1] = { {}, { 1.544 },
    { 0.9466785280815826, 0.2557011698983284 },
    { 3.314825187068521, 2.896124015972201, 0.9986419139977817 },
    { 1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950 },
    { 1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0 } };
  static constexpr double C[NumberOfStages][NumberOfStages - 1] = { {}, { -5.6688 },
    { -2.430093356833875, -0.2063599157091915 },
    { -0.1073529058151375, -9.594562251023355, -20.47028614809616 },
    { 7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160 },
    { 8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136,
      -6.058818238834054 } };
  static constexpr double D[2][NumberOfStages - 1] = { { 10.12623508344586, -7.487995877610167,
                                                         -34.80091861555747, -7.992771707568823,
                                                         1.025137723295662 },
    { -0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386,
      -6.594389125716872 } };

  /// Multiplies h J by v.
  void Multiply(const double v[3], double product[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      product[i] = Vectors::Dot(this->Jacobian + 3 * i, v);
    }
  }

  /// Computes the LU factorization of 1 / gamma - h J with partial pivoting. The diagonal stores
  /// reciprocals. Returns false if the matrix is singular.
  bool Factor()
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Rows[i] = i;
      for (int j = 0; j < 3; ++j)
      {
        this->Matrix[i][j] = (i == j ? 1.0 / Gamma : 0.0) - this->Jacobian[3 * i + j];
      }
    }
    for (int column = 0; column < 3; ++column)
    {
      int pivot = column;
      for (int row = column + 1; row < 3; ++row)
      {
        if (std::abs(this->Matrix[row][column]) > std::abs(this->Matrix[pivot][column]))
        {
          pivot = row;
        }
      }
      std::swap(this->Matrix[pivot], this->Matrix[column]);
      std::swap(this->Rows[pivot], this->Rows[column]);
      const double reciprocal = 1.0 / this->Matrix[column][column];
      if (!std::isfinite(reciprocal))
      {
        return false;
      }
      this->Matrix[column][column] = reciprocal;
      for (int row = column + 1; row < 3; ++row)
      {
        this->Matrix[row][column] *= reciprocal;
        for (int j = column + 1; j < 3; ++j)
        {
          this->Matrix[row][j] -= this->Matrix[row][column] * this->Matrix[column][j];
        }
      }
    }
    return true;
  }

  void Solve(double u[3]) const
  {
    double y[3];
    for (int i = 0; i < 3; ++i)
    {
      y[i] = u[this->Rows[i]];
      for (int j = 0; j < i; ++j)
      {
        y[i] -= this->Matrix[i][j] * y[j];
      }
    }
    for (int i = 2; i >= 0; --i)
    {
      for (int j = i + 1; j < 3; ++j)
      {
        y[i] -= this->Matrix[i][j] * u[j];
      }
      u[i] = y[i] * this->Matrix[i][i];
    }
  }

  double Start[3];
  double U[NumberOfStages][3];
  double Matrix[3][3];
  int Rows[3];
  /// Jacobian times the step, h J.
  double Jacobian[9] = {};
};

}

#endif
