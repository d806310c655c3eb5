// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationBox_h
#define vtkTerminationBox_h

#include "vtkTerminationSurface.h"

/**
 * @class   vtkTerminationBox
 * @brief   axis-aligned box as a termination surface
 *
 * Parts 0 to 5 are the faces -x, +x, -y, +y, -z, +z. On each face, u and v run along the other two
 * axes in the order x, y, z, from 0 at the lower to 1 at the upper bound. Normals point outward.
 * The distance is exact everywhere and negative inside. The face nearest to a point is the one with
 * the largest signed distance.
 *
 * Update reports bounds that are not finite, and lower bounds that are not below their upper
 * bounds.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationBox : public vtkTerminationSurface
{
public:
  static vtkTerminationBox* New();
  vtkTypeMacro(vtkTerminationBox, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Lower and upper bounds of x, y, z, in world units. Default: -0.5, 0.5 for each. Valid: finite,
   * lower < upper.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  int GetNumberOfParts() const override { return 6; }
  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  int EvaluatePart(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  void GetBounds(double bounds[6]) const override;

protected:
  vtkTerminationBox() = default;
  ~vtkTerminationBox() override = default;

private:
  vtkTerminationBox(const vtkTerminationBox&) = delete;
  void operator=(const vtkTerminationBox&) = delete;

  double Bounds[6] = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
};

#endif
