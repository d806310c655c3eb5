// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationCylinder_h
#define vtkTerminationCylinder_h

#include "vtkTerminationSurface.h"

#include <memory> // for the frame

namespace interlume
{
struct AxialFrame;
}

/**
 * @class   vtkTerminationCylinder
 * @brief   cylinder between two points, with optional caps, as a termination surface
 *
 * Part 0 is the wall. The parameter u is the angle in turns, counterclockwise around the axis from
 * Point1 to Point2, and periodic. The parameter v runs from 0 at Point1 to 1 at Point2. The
 * direction u = 0 is x for an axis along z, otherwise the first vector of the basis in T. Duff et
 * al., "Building an orthonormal basis, revisited", JCGT 6(1), 2017. The distance is measured from
 * the wall extended to infinity, and is negative inside.
 *
 * If Capped is on, parts 1 and 2 are the disks at Point1 and Point2, and the distance is measured
 * from the closed cylinder. On a disk, u = (x / Radius + 1) / 2 and v = (y / Radius + 1) / 2, where
 * x points toward u = 0 of the wall and y toward u = 1/4; neither is periodic. Normals point
 * outward.
 *
 * Update reports points that are not finite or that coincide, and a radius that is not above 0.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationCylinder : public vtkTerminationSurface
{
public:
  static vtkTerminationCylinder* New();
  vtkTypeMacro(vtkTerminationCylinder, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Ends of the axis, and the radius, in world units. Default: (0, 0, -0.5), (0, 0, 0.5), 0.5.
   * Valid: finite ends that do not coincide, and a finite radius above 0.
   */
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * If true, disks close the cylinder. Default: off.
   */
  vtkSetMacro(Capped, bool);
  vtkGetMacro(Capped, bool);
  vtkBooleanMacro(Capped, bool);
  ///@}

  enum Parts
  {
    WALL = 0,
    CAP_1 = 1,
    CAP_2 = 2
  };

  int GetNumberOfParts() const override { return this->Capped ? 3 : 1; }
  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  bool IsOn(const double x[3]) const override;
  int EvaluatePart(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  bool IsPeriodic(int direction, int part = 0) const override;
  void GetBounds(double bounds[6]) const override;

protected:
  vtkTerminationCylinder();
  ~vtkTerminationCylinder() override;

private:
  vtkTerminationCylinder(const vtkTerminationCylinder&) = delete;
  void operator=(const vtkTerminationCylinder&) = delete;

  /// Position of a point in the cylinder's coordinates.
  struct LocalPosition
  {
    /// Components of the offset from the axis, perpendicular to it.
    double Offset[2];
    /// Distance from Point1 along the axis.
    double Along;
    /// Signed distances from the wall, extended to infinity, and from the plane of the nearer end.
    /// Both are negative inside.
    double Wall;
    double End;
    int Part;
  };
  LocalPosition GetLocalPosition(const double x[3]) const;

  const std::unique_ptr<interlume::AxialFrame> Frame;
  double Length = 1.0;

  double Point1[3] = { 0.0, 0.0, -0.5 };
  double Point2[3] = { 0.0, 0.0, 0.5 };
  double Radius = 0.5;
  bool Capped = false;
};

#endif
