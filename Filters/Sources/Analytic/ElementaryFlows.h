// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ElementaryFlows_h
#define interlume_ElementaryFlows_h

#include "Analytic/DualNumber.h"

#include <cmath>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * The flows of vtkAnalyticFlowSource other than vortices: functors that compute the velocity at a
 * position relative to the center, for double and DualNumber. Directions must be normalized.
 */
namespace ElementaryFlows
{
// These functions are for double. Those for DualNumber are found by argument-dependent lookup.
using std::cos;
using std::sin;
using std::sqrt;
using std::tanh;

template <typename Number>
Number Dot(const glm::dvec3& a, const Number x[3])
{
  return a[0] * x[0] + a[1] * x[1] + a[2] * x[2];
}

template <typename Number>
Number SquaredLength(const Number x[3])
{
  return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}

template <typename Number>
void Fill(const glm::dvec3& value, Number v[3])
{
  for (int i = 0; i < 3; ++i)
  {
    v[i] = value[i];
  }
}

struct Uniform
{
  glm::dvec3 Velocity;

  template <typename Number>
  void operator()(const Number*, Number v[3]) const
  {
    Fill(this->Velocity, v);
  }
};

/// Linear flow with a rate along each coordinate axis, plus a rotation.
struct Linear
{
  glm::dvec3 Rates;
  glm::dvec3 AngularVelocity;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      v[i] =
        this->Rates[i] * x[i] + this->AngularVelocity[j] * x[k] - this->AngularVelocity[k] * x[j];
    }
  }
};

/// A source at -Separation / 2 and a sink at +Separation / 2.
struct Pair
{
  double Strength;
  glm::dvec3 Separation;
  double CoreRadius;
  /// If true, the cores are softened (Plummer); otherwise, they are spheres of constant divergence.
  bool IsSoftened;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    Fill(glm::dvec3(0.0), v);
    for (const double sign : { 1.0, -1.0 })
    {
      Number d[3];
      for (int i = 0; i < 3; ++i)
      {
        d[i] = x[i] + 0.5 * sign * this->Separation[i];
      }
      const Number factor = this->GetFactor(SquaredLength(d));
      for (int i = 0; i < 3; ++i)
      {
        v[i] = v[i] + sign * factor * d[i];
      }
    }
  }

private:
  // Returns the speed due to the source, divided by the distance from the source. \a r2 is the
  // squared distance.
  template <typename Number>
  Number GetFactor(const Number& r2) const
  {
    const double core2 = this->CoreRadius * this->CoreRadius;
    if (this->IsSoftened)
    {
      const Number sum = r2 + core2;
      return this->Strength / (sum * sqrt(sum));
    }
    const double charge = this->Strength / (16.0 * std::atan(1.0));
    if (DualMath::GetValue(r2) < core2)
    {
      return Number(charge / (core2 * this->CoreRadius));
    }
    return charge / (r2 * sqrt(r2));
  }
};

/// Potential flow around a sphere; 0 inside.
struct Sphere
{
  glm::dvec3 Velocity;
  double Radius;

  bool IsInside(const double x[3]) const { return SquaredLength(x) < this->Radius * this->Radius; }

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    const Number r2 = SquaredLength(x);
    if (DualMath::GetValue(r2) < this->Radius * this->Radius)
    {
      Fill(glm::dvec3(0.0), v);
      return;
    }
    const Number factor = 0.5 * this->Radius * this->Radius * this->Radius / (r2 * sqrt(r2));
    const Number along = 3.0 * factor / r2 * Dot(this->Velocity, x);
    for (int i = 0; i < 3; ++i)
    {
      v[i] = this->Velocity[i] * (1.0 + factor) - along * x[i];
    }
  }
};

/// Potential flow around an infinite cylinder; 0 inside.
struct Cylinder
{
  /// Components of the far-field velocity perpendicular and parallel to the axis.
  glm::dvec3 Across;
  glm::dvec3 Along;
  glm::dvec3 Axis;
  double Radius;

  bool IsInside(const double x[3]) const
  {
    double radial[3];
    this->GetRadialOffset(x, radial);
    return SquaredLength(radial) < this->Radius * this->Radius;
  }

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    Number radial[3];
    this->GetRadialOffset(x, radial);
    const Number r2 = SquaredLength(radial);
    if (DualMath::GetValue(r2) < this->Radius * this->Radius)
    {
      Fill(glm::dvec3(0.0), v);
      return;
    }
    const Number factor = this->Radius * this->Radius / r2;
    const Number along = 2.0 * factor / r2 * Dot(this->Across, radial);
    for (int i = 0; i < 3; ++i)
    {
      v[i] = this->Across[i] * (1.0 + factor) - along * radial[i] + this->Along[i];
    }
  }

private:
  template <typename Number>
  void GetRadialOffset(const Number x[3], Number radial[3]) const
  {
    const Number height = Dot(this->Axis, x);
    for (int i = 0; i < 3; ++i)
    {
      radial[i] = x[i] - height * this->Axis[i];
    }
  }
};

/// Arnold-Beltrami-Childress (ABC) flow.
struct Beltrami
{
  glm::dvec3 Amplitudes;
  double WaveNumber;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      v[i] = this->Amplitudes[i] * sin(this->WaveNumber * x[k]) +
        this->Amplitudes[k] * cos(this->WaveNumber * x[j]);
    }
  }
};

/// Two opposite streams and the shear layer between them.
struct Shear
{
  /// Velocity component perpendicular to the normal.
  glm::dvec3 Velocity;
  glm::dvec3 Normal;
  double Thickness;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    const Number profile = tanh(Dot(this->Normal, x) / this->Thickness);
    for (int i = 0; i < 3; ++i)
    {
      v[i] = this->Velocity[i] * profile;
    }
  }
};
}

}

#endif
