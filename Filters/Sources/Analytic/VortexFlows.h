// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VortexFlows_h
#define interlume_VortexFlows_h

#include "Analytic/DualNumber.h"

#include <array>
#include <cmath>

namespace interlume
{

/**
 * The vortices of vtkAnalyticFlowSource: velocities at x, relative to the centre, of numbers of any
 * kind.
 */
namespace VortexFlows
{
// For numbers that are not dual.
using std::cos;
using std::sin;

/**
 * An axis that leans and bends with height, and the change of a vortex around a straight axis to
 * one around it: coordinates are shifted with height, and the vertical velocity goes along the
 * axis. That keeps a field free of divergence.
 */
struct BentAxis
{
  double Height;
  std::array<double, 2> Tilt;
  std::array<double, 2> Bend;

  /// Returns the height: 0 at the ground, 1 at the top.
  template <typename Number>
  Number GetPart(const Number& z) const
  {
    return z / this->Height + 0.5;
  }

  /// Computes the place beside the axis.
  template <typename Number>
  void Shift(const Number x[3], Number beside[2]) const
  {
    const Number part = this->GetPart(x[2]);
    for (int i = 0; i < 2; ++i)
    {
      beside[i] = x[i] - this->Tilt[i] * (part - 0.5) - this->Bend[i] * sin(Pi * part);
    }
  }

  /// Computes the velocity from its parts by radius: inflow, swirl and rise.
  template <typename Number>
  void Compose(const Number x[3], const Number& radialByRadius, const Number& swirlByRadius,
    const Number& rise, Number v[3]) const
  {
    Number beside[2];
    this->Shift(x, beside);
    const Number bend = Pi * cos(Pi * this->GetPart(x[2]));
    const Number turned[2] = { -beside[1], beside[0] };
    for (int i = 0; i < 2; ++i)
    {
      v[i] = radialByRadius * beside[i] + swirlByRadius * turned[i] +
        (this->Tilt[i] + this->Bend[i] * bend) / this->Height * rise;
    }
    v[2] = rise;
  }

  static constexpr double Pi = 3.14159265358979323846;
};

/// The stream function's part by radius is G(s) = s (s - E) / (M + s)^2, s the radius squared.
struct Hurricane
{
  BentAxis Axis;
  double MaximumWind;
  double EyeRadius;
  double Updraft;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    Number beside[2];
    this->Axis.Shift(x, beside);
    const Number s =
      (beside[0] * beside[0] + beside[1] * beside[1]) / (this->EyeRadius * this->EyeRadius);
    const Number part = this->Axis.GetPart(x[2]);
    const Number sum = M + s;
    const double strongest = GetSlope((M * M + 2.0 * M * E) / (2.0 * M + E));
    const double inflow = 0.5 * BentAxis::Pi * this->Updraft / (this->Axis.Height * strongest);
    const Number radial = -inflow * cos(BentAxis::Pi * part) * (s - E) / (sum * sum);
    const Number swirl =
      2.0 * this->MaximumWind / this->EyeRadius / ((1.0 + s) * (1.0 + part * part));
    const Number rise = this->Updraft / strongest * sin(BentAxis::Pi * part) * GetSlope(s);
    this->Axis.Compose(x, radial, swirl, rise, v);
  }

private:
  static constexpr double E = 0.2;
  static constexpr double M = 2.0;

  // Computes dG/ds.
  template <typename Number>
  static Number GetSlope(const Number& s)
  {
    const Number sum = M + s;
    return ((2.0 * M + E) * s - E * M) / (sum * sum * sum);
  }
};

/// Burgers' vortex, from the ground up.
struct Tornado
{
  BentAxis Axis;
  double Circulation;
  double CoreRadius;
  double Strain;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    Number beside[2];
    this->Axis.Shift(x, beside);
    const double core2 = this->CoreRadius * this->CoreRadius;
    const Number s = (beside[0] * beside[0] + beside[1] * beside[1]) / core2;
    const Number swirl = this->Circulation / (2.0 * BentAxis::Pi * core2) * DualMath::Decay(s);
    const Number rise = this->Strain * this->Axis.Height * this->Axis.GetPart(x[2]);
    this->Axis.Compose(x, Number(-0.5 * this->Strain), swirl, rise, v);
  }
};
}

}

#endif
