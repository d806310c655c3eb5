// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationPlane_h
#define vtkTerminationPlane_h

#include "vtkTerminationSurface.h"

/**
 * @class   vtkTerminationPlane
 * @brief   parallelogram or infinite plane as a termination surface
 *
 * The parallelogram is defined as in vtkPlaneSource: u runs from 0 at Origin to 1 at Point1, and v
 * from 0 at Origin to 1 at Point2. The two edges need not be perpendicular. The normal is (Point1 -
 * Origin) x (Point2 - Origin).
 *
 * The parameters of a point are those of its projection onto the plane, clamped to [0, 1] unless
 * Unbounded is on.
 *
 * Update reports points that are not finite, an edge of length 0, and parallel edges (the sine of
 * their angle is below 1e-12).
 */
class INTERLUMEFLOW_EXPORT vtkTerminationPlane : public vtkTerminationSurface
{
public:
  static vtkTerminationPlane* New();
  vtkTypeMacro(vtkTerminationPlane, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Three corners of the parallelogram, in world units. Default: (-0.5, -0.5, 0), (0.5, -0.5, 0),
   * (-0.5, 0.5, 0). Valid: finite, not collinear.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /**
   * If true, the surface is the infinite plane, and its parameters may be outside [0, 1].
   * Default: off.
   */
  vtkSetMacro(Unbounded, bool);
  vtkGetMacro(Unbounded, bool);
  vtkBooleanMacro(Unbounded, bool);
  ///@}

  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  bool IsOn(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  void GetBounds(double bounds[6]) const override;

protected:
  vtkTerminationPlane() = default;
  ~vtkTerminationPlane() override = default;

private:
  vtkTerminationPlane(const vtkTerminationPlane&) = delete;
  void operator=(const vtkTerminationPlane&) = delete;

  /// Computes the parameters of the projection of \a x onto the plane, without clamping them.
  void GetFoot(const double x[3], double uv[2]) const;

  double Normal[3] = { 0.0, 0.0, 1.0 };
  /// Gradients of u and v.
  double Gradients[2][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };

  double Origin[3] = { -0.5, -0.5, 0.0 };
  double Point1[3] = { 0.5, -0.5, 0.0 };
  double Point2[3] = { -0.5, 0.5, 0.0 };
  bool Unbounded = false;
};

#endif
