// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ElementaryFields_h
#define interlume_ElementaryFields_h

#include "vtkMath.h"

#include <array>
#include <cmath>

namespace interlume
{

/**
 * Fields that are one line each; vtkAnalyticFieldSource has the formulas' meaning.
 */
namespace ElementaryFields
{
using Vector = std::array<double, 3>;

struct Wave
{
  double Time;

  double operator()(const double x[3]) const
  {
    return x[2] - 0.4 * std::cos(vtkMath::Pi() * (x[0] + 0.25 * x[1] - 0.5 * this->Time));
  }
};

struct Linear
{
  double Time;
  double Constant;
  Vector Gradient;
  double Rate;

  double operator()(const double x[3]) const
  {
    return this->Constant + vtkMath::Dot(this->Gradient.data(), x) + this->Rate * this->Time;
  }
};

/// Center and Radius are those at Time.
struct Ball
{
  Vector Center;
  double Radius;

  double operator()(const double x[3]) const
  {
    return std::sqrt(vtkMath::Distance2BetweenPoints(x, this->Center.data())) - this->Radius;
  }
};

/// Shift is the way gone at Time.
struct Gyroid
{
  Vector Shift;

  double operator()(const double x[3]) const
  {
    Vector angle;
    for (int axis = 0; axis < 3; ++axis)
    {
      angle[axis] = 2.0 * vtkMath::Pi() * (x[axis] - this->Shift[axis]);
    }
    return std::sin(angle[0]) * std::cos(angle[1]) + std::sin(angle[1]) * std::cos(angle[2]) +
      std::sin(angle[2]) * std::cos(angle[0]);
  }
};
}

}

#endif
