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
 * @brief   sphere as a termination surface, with longitude and latitude as parameters
 *
 * The parameter u is the longitude in turns, counterclockwise around Axis, and periodic. The
 * parameter v is the latitude, from 0 at the pole opposite to Axis to 1 at the pole in the
 * direction of Axis. The direction u = 0 is x for an axis along z, otherwise the first vector of
 * the basis in T. Duff et al., "Building an orthonormal basis, revisited", JCGT 6(1), 2017. The
 * normal points outward. The distance is negative inside.
 *
 * Update reports a center or an axis that is not finite, an axis of length 0, and a radius that is
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
   * Center and radius of the sphere, in world units. Default: (0, 0, 0), 0.5. Valid: a finite
   * center, and a finite radius above 0.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Direction from the pole with v = 0 to the pole with v = 1. Default: (0, 0, 1). Valid: finite,
   * with any length above 0.
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
