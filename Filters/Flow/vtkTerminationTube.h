// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationTube_h
#define vtkTerminationTube_h

#include "vtkSmartPointer.h" // for the line
#include "vtkTerminationSurface.h"

#include <array>
#include <memory>
#include <vector>

class vtkPolyData;

namespace interlume
{
class TubeAxis;
}

/**
 * @class   vtkTerminationTube
 * @brief   the tube around a line, such as the axis of a vortex
 *
 * The tube is the set of points at Radius from a polyline; its distance is the distance from the
 * line less the radius, negative inside.
 *
 * Part 0 is the tube: u is the angle around the line in turns, periodic, counterclockwise along the
 * line in a frame that does not turn around it (the rotation-minimising frame); u = 0 at the start
 * is where the basis of T. Duff et al., "Building an orthonormal basis, revisited", JCGT 6(1),
 * 2017, has its first vector. v goes from 0 at the first to 1 at the last point by length: at a
 * bend the parts meet in the plane that bisects it, and between two such planes v is linear along
 * the line.
 *
 * A line whose last point is its first is closed: v is periodic, and the rotation that the frame
 * has made after one round is spread over the length.
 *
 * Beyond the ends is a half sphere around each. It is not on the surface unless Capped; then it is
 * part 1 at the first point and part 2 at the last. In these (u,v) = (1 + r d) / 2, d the direction
 * across the line in the frame and r the angle from the line over pi / 2; not periodic.
 *
 * Where the radius is more than the bends' the tube meets itself, and parameters jump there.
 *
 * Update reports a radius that is not above 0, a point that is not finite, fewer than two places, a
 * line that turns back on itself, and a dataset that has not one line.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationTube : public vtkTerminationSurface
{
public:
  static vtkTerminationTube* New();
  vtkTypeMacro(vtkTerminationTube, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The points of the line, in world units. Default none. Valid: finite. Points in the same place
   * as the one before count once. GetPoint leaves its argument as it is where there is no such
   * point.
   */
  void AddPoint(double x, double y, double z);
  void RemoveAllPoints();
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size()); }
  void GetPoint(int i, double x[3]) const;
  ///@}

  ///@{
  /**
   * A dataset with one line cell, which is taken instead of the points. Default null.
   */
  void SetLine(vtkPolyData* line);
  vtkPolyData* GetLine() const;
  ///@}

  ///@{
  /**
   * The radius of the tube, in world units. Default 0.5. Valid: finite, above 0.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Whether the round ends are part of the surface. A closed line has none. Default off.
   */
  vtkSetMacro(Capped, bool);
  vtkGetMacro(Capped, bool);
  vtkBooleanMacro(Capped, bool);
  ///@}

  enum Parts
  {
    TUBE = 0,
    CAP_1 = 1,
    CAP_2 = 2
  };

  int GetNumberOfParts() const override;
  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  bool IsOn(const double x[3]) const override;
  int EvaluatePart(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  bool IsPeriodic(int direction, int part = 0) const override;
  void GetBounds(double bounds[6]) const override;

  /// Returns the time of the last change, of the line too.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerminationTube();
  ~vtkTerminationTube() override;

private:
  vtkTerminationTube(const vtkTerminationTube&) = delete;
  void operator=(const vtkTerminationTube&) = delete;

  std::unique_ptr<interlume::TubeAxis> Axis;

  std::vector<std::array<double, 3>> Points;
  vtkSmartPointer<vtkPolyData> Line;
  double Radius = 0.5;
  bool Capped = false;
};

#endif
