// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceContourSurfaces_h
#define ReferenceContourSurfaces_h

#include "vtkTerminationSurface.h"

namespace reference
{

/**
 * @class   Plane
 * @brief   rectangle in the plane x = 0 with a corner at the origin, u along y and v along z
 */
class Plane : public vtkTerminationSurface
{
public:
  static Plane* New();
  vtkTypeMacro(Plane, vtkTerminationSurface);

  void SetSize(double u, double v);

  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  void GetBounds(double bounds[6]) const override;

private:
  double Size[2] = { 1.0, 1.0 };
};

/**
 * @class   Cylinder
 * @brief   cylinder around the z-axis from z = 0 to 1, where u is the angle in turns and v is z; a
 * range of u can be removed
 */
class Cylinder : public vtkTerminationSurface
{
public:
  static Cylinder* New();
  vtkTypeMacro(Cylinder, vtkTerminationSurface);

  void SetRadius(double radius);
  void SetGap(double from, double to);

  double EvaluateDistance(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  void GetBounds(double bounds[6]) const override;

private:
  double Radius = 1.0;
  double Gap[2] = { 2.0, 2.0 };
};

}

#endif
