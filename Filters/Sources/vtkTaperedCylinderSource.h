// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTaperedCylinderSource_h
#define vtkTaperedCylinderSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkTemporalGridSource.h"

/**
 * @class   vtkTaperedCylinderSource
 * @brief   generate the wake of a tapered cylinder on a curvilinear grid
 *
 * An analytic replacement for the NASA Tapered Cylinder data (D. C. Jespersen, C. Levit, "Numerical
 * simulation of flow past a tapered cylinder", AIAA 91-0751, 1991). The cylinder's axis is z, from
 * 0 to Height, and the free stream runs along x. The radius changes linearly between Radii.
 *
 * The grid runs outward in i, around the cylinder in j and up in k. Points are dense at the wall
 * and in the wake. The seam lies upstream: there, the first and last points in j have identical
 * coordinates and values. Cells are right-handed.
 *
 * The span is divided into three shedding cells, in which vortices are shed at a constant
 * frequency, as behind real tapered cylinders. The vortices are slanted. Between shedding cells,
 * vortex lines join or dislocate. They reach both ends of the cylinder, where the data end, so the
 * vortices have flat ends there. The array is the density, which is below 1 in the vortices. See
 * Documentation/methods/sources.md for the formulas.
 *
 * Defaults: array "density", 64 x 64 x 32 points. The interval 0.9934 to 0.9944, as in C. Zhang's
 * dissertation, Ohio State 2006, consists of four or five slanted rollers.
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
   * Set/Get the radius at z = 0 and at z = Height. Default 0.5, 0.3. Valid: 0.05 to 50; clamped.
   */
  void SetRadii(double bottom, double top);
  vtkGetVector2Macro(Radii, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of the cylinder along z. Default 12. Valid: 0.1 to 1000; clamped.
   */
  void SetHeight(double height);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Set/Get the outer radius of the grid. At least twice the cylinder's maximum radius is used.
   * Default 9. Valid: 0.1 to 200; clamped.
   */
  void SetOuterRadius(double radius);
  vtkGetMacro(OuterRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the speed of the free stream, in units of length per unit of time. Default 1. Valid:
   * 0.001 to 1000; clamped.
   */
  void SetSpeed(double speed);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /**
   * Set/Get the Strouhal number: shedding frequency times diameter divided by speed. Default 0.2.
   * Valid: 0.01 to 1; clamped.
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

  /// Returns OuterRadius, or twice the cylinder's maximum radius if that is larger.
  double GetGridRadius() const;

  double Radii[2] = { 0.5, 0.3 };
  double Height = 12.0;
  double OuterRadius = 9.0;
  double Speed = 1.0;
  double StrouhalNumber = 0.2;
};

#endif
