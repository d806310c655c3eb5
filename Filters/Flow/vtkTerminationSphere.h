// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationSphere_h
#define vtkTerminationSphere_h

#include "vtkTerminationSurface.h"

#include <memory> // for the frame

namespace interlume
{
struct AxialFrame;
}

/**
 * @class   vtkTerminationSphere
 * @brief   a sphere, by longitude and latitude
 *
 * u is the longitude in turns, counterclockwise around Axis and periodic; v the latitude, 0 at the
 * pole against Axis to 1 at the pole along it. With the axis z, u = 0 is towards x; with another
 * one it is where the basis of T. Duff et al., "Building an orthonormal basis, revisited", JCGT
 * 6(1), 2017, has its first vector. The normal points outward; the distance is negative inside.
 *
 * Update reports a centre or an axis that is not finite, an axis of length 0, and a radius that is
 * not above 0.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationSphere : public vtkTerminationSurface
{
public:
  static vtkTerminationSphere* New();
  vtkTypeMacro(vtkTerminationSphere, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The centre and the radius of the sphere, in world units. Default (0, 0, 0), 0.5. Valid: finite;
   * above 0.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * The direction from pole to pole. Default (0, 0, 1). Valid: finite, any length above 0.
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  bool IsPeriodic(int direction, int part = 0) const override;
  void GetBounds(double bounds[6]) const override;

protected:
  vtkTerminationSphere();
  ~vtkTerminationSphere() override;

private:
  vtkTerminationSphere(const vtkTerminationSphere&) = delete;
  void operator=(const vtkTerminationSphere&) = delete;

  const std::unique_ptr<interlume::AxialFrame> Frame;

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.5;
  double Axis[3] = { 0.0, 0.0, 1.0 };
};

#endif
