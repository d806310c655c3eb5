// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AdvectionRate_h
#define interlume_AdvectionRate_h

#include "Advection/AdvectionOptions.h"

namespace interlume
{

/**
 * @class   AdvectionRate
 * @brief   right-hand side dp/dt of a streamline in the walker's current cell
 *
 * Applies the direction of integration and counts the evaluations.
 */
template <typename Walker>
class AdvectionRate
{
public:
  /// Evaluations are counted in \a counts.
  AdvectionRate(const Walker& field, bool isBackward, AdvectionEnd& counts)
    : Field(field)
    , Counts(counts)
    , Sign(isBackward ? -1.0 : 1.0)
  {
  }

  void operator()(const double p[3], double rate[3])
  {
    this->Field.GetVelocity(p, rate);
    for (int i = 0; i < 3; ++i)
    {
      rate[i] *= this->Sign;
    }
    ++this->Counts.Evaluations;
  }

  void GetJacobian(const double p[3], double jacobian[9])
  {
    this->Field.GetJacobian(p, jacobian);
    for (int i = 0; i < 9; ++i)
    {
      jacobian[i] *= this->Sign;
    }
    ++this->Counts.JacobianEvaluations;
  }

private:
  const Walker& Field;
  AdvectionEnd& Counts;
  double Sign;
};

}

#endif
