// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AxialFrame_h
#define interlume_AxialFrame_h

namespace interlume
{

/**
 * @class   AxialFrame
 * @brief   an axis and two directions X, Y across it, orthonormal and right-handed
 */
struct AxialFrame
{
  double X[3] = { 1.0, 0.0, 0.0 };
  double Y[3] = { 0.0, 1.0, 0.0 };
  double Axis[3] = { 0.0, 0.0, 1.0 };

  /// Takes an axis of any length above 0; X and Y after T. Duff et al., "Building an orthonormal
  /// basis, revisited", JCGT 6(1), 2017: those of the axis z are x and y.
  void SetAxis(const double axis[3]);

  /// Takes an axis with X already across it, both of length 1.
  void SetAxis(const double axis[3], const double x[3]);

  /// Computes the components of \a x - \a origin along X, Y and the axis.
  void GetComponents(const double x[3], const double origin[3], double components[3]) const;

  /// Computes origin + a X + b Y + c Axis.
  void GetPoint(const double origin[3], double a, double b, double c, double x[3]) const;

  /// Returns the angle from X towards Y in turns, 0 to below 1; 0 for no direction.
  static double GetTurn(double x, double y);
};

}

#endif
