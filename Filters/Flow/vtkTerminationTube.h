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
 * @brief   tube around a polyline, such as a vortex axis, as a termination surface
 *
 * The tube is the set of points at distance Radius from a polyline. The signed distance is the
 * distance from the line minus the radius, negative inside.
 *
 * Part 0 is the tube. The parameter u is the periodic angle around the line in turns,
 * counterclockwise about the line's direction, in a rotation-minimizing frame. At the start of the
 * line, u = 0 is the first vector of the basis in T. Duff et al., "Building an orthonormal basis,
 * revisited", JCGT 6(1), 2017. The parameter v is the fraction of the line's length, from 0 at the
 * first point to 1 at the last point. At a bend, the segments meet in the bisecting plane, and v is
 * linear between two such planes.
 *
 * A line whose first and last points coincide is closed. Then v is periodic, and the rotation of
 * the frame after one loop is distributed over the length.
 *
 * Hemispheres close the ends of the tube around an open line. They belong to the surface only if
 * Capped is on: part 1 is at the first point, and part 2 at the last point. The parameters of a
 * hemisphere are (u,v) = (1 + r d) / 2, where d is the unit direction perpendicular to the line, in
 * coordinates of the frame, and r is the angle from the line divided by pi / 2; neither u nor v is
 * periodic.
 *
 * If the radius of the tube exceeds the bend radius of the line, the tube intersects itself, and
 * the parameters jump.
 *
 * Update reports a radius that is not above 0, points that are not finite, fewer than two distinct
 * points, a line that reverses its direction at a point, and a dataset that does not have exactly
 * one line.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationTube : public vtkTerminationSurface
{
public:
  static vtkTerminationTube* New();
  vtkTypeMacro(vtkTerminationTube, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points of the line, in world units. Default: none. Valid: finite. A point at the position of
   * the previous one is skipped. GetPoint does not change \a x if the index is invalid.
   */
  void AddPoint(double x, double y, double z);
  void RemoveAllPoints();
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size()); }
  void GetPoint(int i, double x[3]) const;
  ///@}

  ///@{
  /**
   * Dataset with one line cell, used instead of the points. Default: null.
   */
  void SetLine(vtkPolyData* line);
  vtkPolyData* GetLine() const;
  ///@}

  ///@{
  /**
   * Radius of the tube, in world units. Default: 0.5. Valid: finite, above 0.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * If true, the hemispheres at the ends are part of the surface. Closed lines have no ends.
   * Default: off.
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

  /// Return the modification time, including that of the line.
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
