// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ElementaryFields_h
#define interlume_ElementaryFields_h

#include "Common/Vectors.h"

#include "vtkMath.h"

#include <cmath>

namespace interlume
{

/**
 * Fields that are one line each; vtkAnalyticFieldSource has the formulas' meaning.
 */
namespace ElementaryFields
{
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
  glm::dvec3 Gradient;
  double Rate;

  double operator()(const double x[3]) const
  {
    return this->Constant + glm::dot(this->Gradient, glm::make_vec3(x)) + this->Rate * this->Time;
  }
};

/// Center and Radius are those at Time.
struct Ball
{
  glm::dvec3 Center;
  double Radius;

  double operator()(const double x[3]) const
  {
    return glm::distance(glm::make_vec3(x), this->Center) - this->Radius;
  }
};

/// Shift is the way gone at Time.
struct Gyroid
{
  glm::dvec3 Shift;

  double operator()(const double x[3]) const
  {
    const glm::dvec3 angle = 2.0 * vtkMath::Pi() * (glm::make_vec3(x) - this->Shift);
    return std::sin(angle[0]) * std::cos(angle[1]) + std::sin(angle[1]) * std::cos(angle[2]) +
      std::sin(angle[2]) * std::cos(angle[0]);
  }
};
}

}

#endif
