// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VortexFlows_h
#define interlume_VortexFlows_h

#include "Analytic/DualNumber.h"

#include <array>
#include <cmath>

namespace interlume
{

/**
 * The vortices of vtkAnalyticFlowSource: functors that compute the velocity at a position relative
 * to the center, for double and DualNumber.
 */
namespace VortexFlows
{
// These functions are for double. Those for DualNumber are found by argument-dependent lookup.
using std::cos;
using std::sin;

/**
 * A vortex axis that is tilted and bent from the vertical. A vortex around a vertical axis is
 * mapped to a vortex around this axis: horizontal coordinates are shifted depending on the height,
 * and the vertical velocity is redirected along the axis. The map preserves the divergence.
 */
struct BentAxis
{
  double Height;
  std::array<double, 2> Tilt;
  std::array<double, 2> Bend;

  /// Returns the relative height: 0 at the ground and 1 at the top.
  template <typename Number>
  Number GetRelativeHeight(const Number& z) const
  {
    return z / this->Height + 0.5;
  }

  /// Computes the horizontal offset of \a x from the axis.
  template <typename Number>
  void Shift(const Number x[3], Number offset[2]) const
  {
    const Number height = this->GetRelativeHeight(x[2]);
    for (int i = 0; i < 2; ++i)
    {
      offset[i] = x[i] - this->Tilt[i] * (height - 0.5) - this->Bend[i] * sin(Pi * height);
    }
  }

  /// Computes the velocity from its components. \a radialByRadius and \a swirlByRadius are the
  /// radial and tangential velocity divided by the distance from the axis. \a rise is the vertical
  /// velocity.
  template <typename Number>
  void ComposeVelocity(const Number x[3], const Number& radialByRadius, const Number& swirlByRadius,
    const Number& rise, Number v[3]) const
  {
    Number offset[2];
    this->Shift(x, offset);
    const Number bend = Pi * cos(Pi * this->GetRelativeHeight(x[2]));
    const Number rotated[2] = { -offset[1], offset[0] };
    for (int i = 0; i < 2; ++i)
    {
      v[i] = radialByRadius * offset[i] + swirlByRadius * rotated[i] +
        (this->Tilt[i] + this->Bend[i] * bend) / this->Height * rise;
    }
    v[2] = rise;
  }

  static constexpr double Pi = 3.14159265358979323846;
};

/// Vortex with an eye. Its stream function is proportional to G(s) = s (s - E) / (M + s)^2, where s
/// is the squared distance from the axis, in units of EyeRadius squared. E and M are constants.
struct Hurricane
{
  BentAxis Axis;
  double MaximumWind;
  double EyeRadius;
  double Updraft;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    Number offset[2];
    this->Axis.Shift(x, offset);
    const Number s =
      (offset[0] * offset[0] + offset[1] * offset[1]) / (this->EyeRadius * this->EyeRadius);
    const Number height = this->Axis.GetRelativeHeight(x[2]);
    const Number sum = M + s;
    const double strongest = GetSlope((M * M + 2.0 * M * E) / (2.0 * M + E));
    const double inflow = 0.5 * BentAxis::Pi * this->Updraft / (this->Axis.Height * strongest);
    const Number radial = -inflow * cos(BentAxis::Pi * height) * (s - E) / (sum * sum);
    const Number swirl =
      2.0 * this->MaximumWind / this->EyeRadius / ((1.0 + s) * (1.0 + height * height));
    const Number rise = this->Updraft / strongest * sin(BentAxis::Pi * height) * GetSlope(s);
    this->Axis.ComposeVelocity(x, radial, swirl, rise, v);
  }

private:
  static constexpr double E = 0.2;
  static constexpr double M = 2.0;

  // Returns dG/ds.
  template <typename Number>
  static Number GetSlope(const Number& s)
  {
    const Number sum = M + s;
    return ((2.0 * M + E) * s - E * M) / (sum * sum * sum);
  }
};

/// Burgers' vortex, rising from the ground.
struct Tornado
{
  BentAxis Axis;
  double Circulation;
  double CoreRadius;
  double Strain;

  template <typename Number>
  void operator()(const Number x[3], Number v[3]) const
  {
    Number offset[2];
    this->Axis.Shift(x, offset);
    const double core2 = this->CoreRadius * this->CoreRadius;
    const Number s = (offset[0] * offset[0] + offset[1] * offset[1]) / core2;
    const Number swirl =
      this->Circulation / (2.0 * BentAxis::Pi * core2) * DualMath::MeanExponentialDecay(s);
    const Number rise = this->Strain * this->Axis.Height * this->Axis.GetRelativeHeight(x[2]);
    this->Axis.ComposeVelocity(x, Number(-0.5 * this->Strain), swirl, rise, v);
  }
};
}

}

#endif
