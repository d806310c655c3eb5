// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTaperedCylinderSource_h
#define vtkTaperedCylinderSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkTemporalGridSource.h"

/**
 * @class   vtkTaperedCylinderSource
 * @brief   the wake of a tapered cylinder: slanted, dislocating vortices on a curvilinear grid
 *
 * This is a stand-in, with a formula, for the NASA Tapered Cylinder data (D. C. Jespersen, C.
 * Levit, "Numerical simulation of flow past a tapered cylinder", AIAA 91-0751, 1991). The axis is
 * z, from 0 to H = Height, the free stream of speed U goes along x. The radius R(z) is linear
 * between Radii, the diameter D(z) = 2 R(z).
 *
 * Grid: i outward, j around, k up. With i', j', k' = 0 to 1 along each: z = k' H,
 *   r = R(z) + (OuterRadius - R(z)) (e^(2 i') - 1) / (e^2 - 1),
 *   angle = 2 pi j' - pi + 0.75 sin(2 pi j').
 * Points are dense at the wall and in the wake. The seam lies upstream; its points are there twice,
 * first and last in j, with the same coordinates and values. Cells are right-handed.
 *
 * Shedding follows the local diameter in three cells of constant frequency along the span, as
 * behind real tapered cylinders: cell c = 0, 1, 2 has f_c = StrouhalNumber U / D at its middle (c +
 * 1/2) H/3 and the weight w_c(z), with S(u) = (1 + tanh u) / 2 and p = z / H w_0 = 1 - S((p - 1/3)
 * / 0.08),  w_2 = S((p - 2/3) / 0.08),  w_1 = 1 - w_0 - w_2. Vortex n (any integer) of cell c has
 * at time t the age a = (2 f_c t - 2.2 p - n) / (2 f_c), so that vortices are slanted. Those with 0
 * <= a <= T = OuterRadius / (0.85 U) make the array density = 1 - sum_c w_c sum_n 0.018 (1 - exp(-a
 * U / (0.7 D))) (1 - (a/T)^2) exp(-d^2 / s^2), s^2 = (0.55 D)^2 + 4 (0.008 U D) a, where d is the
 * distance, to first order, from the line through (x_n, y_n) = (D/2 + 0.85 U a, 0.5 D (-1)^n) with
 * the slope dx/dz = -0.85 U 2.2 / (2 f_c H) of the slant; D is D(z). Lines of neighbouring cells
 * join or dislocate.
 *
 * With the defaults the interval 0.9934 to 0.9944, that of the original's pictures, gives about
 * 50,000 tetrahedra: four or five slanted rollers. In a unit of time they go 0.85 downstream, their
 * distance being about 2.
 *
 * Defaults: array "density", 64 x 64 x 32 points.
 *
 * @sa vtkTemporalGridSource
 */
class INTERLUMESOURCES_EXPORT vtkTaperedCylinderSource : public vtkTemporalGridSource
{
public:
  static vtkTaperedCylinderSource* New();
  vtkTypeMacro(vtkTaperedCylinderSource, vtkTemporalGridSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void GetPosition(const int ijk[3], double x[3]) const override;

  ///@{
  /**
   * The radius at z = 0 and at z = Height. Default 0.5, 0.3. Valid: 0.05 to 50; clamped.
   */
  void SetRadii(double bottom, double top);
  vtkGetVector2Macro(Radii, double);
  ///@}

  ///@{
  /**
   * The length of the cylinder along z. Default 12. Valid: 0.1 to 1000; clamped.
   */
  void SetHeight(double height);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * The radius of the grid. Default 9. Valid: 0.1 to 200; clamped. Twice the larger radius of the
   * cylinder is taken where that is more.
   */
  void SetOuterRadius(double radius);
  vtkGetMacro(OuterRadius, double);
  ///@}

  ///@{
  /**
   * The speed of the free stream, in units of length per unit of time. Default 1. Valid: 0.001 to
   * 1000; clamped.
   */
  void SetSpeed(double speed);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /**
   * The Strouhal number: shedding frequency times diameter over speed. Default 0.2. Valid: 0.01 to
   * 1; clamped.
   */
  void SetStrouhalNumber(double number);
  vtkGetMacro(StrouhalNumber, double);
  ///@}

protected:
  vtkTaperedCylinderSource();
  ~vtkTaperedCylinderSource() override = default;

  Field GetFieldAtTime(double t) const override;

private:
  vtkTaperedCylinderSource(const vtkTaperedCylinderSource&) = delete;
  void operator=(const vtkTaperedCylinderSource&) = delete;

  /// Returns the outer radius that is taken.
  double GetGridRadius() const;

  double Radii[2] = { 0.5, 0.3 };
  double Height = 12.0;
  double OuterRadius = 9.0;
  double Speed = 1.0;
  double StrouhalNumber = 0.2;
};

#endif
