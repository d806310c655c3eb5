// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationInflow_h
#define vtkTerminationInflow_h

#include "vtkTerminationPlane.h"

/**
 * @class   vtkTerminationInflow
 * @brief   rectangle where the flow enters the field, placed automatically
 *
 * The rectangle lies near the place where the flow enters the field. Among all planes perpendicular
 * to a coordinate axis, the plane with the largest flow determines the axis and the direction of
 * the flow. The rectangle is in the first plane along this direction through which at least 40 % of
 * the largest flow passes. If that plane is not close to the boundary of the field, as in a vortex
 * or a field of gradients, the rectangle is in the plane with the largest flow. With Size 1, it
 * covers all cells that intersect its plane and have flow in this direction. For FORWARD
 * streamlines, it lies near the place where the flow leaves the field instead, so that streamlines
 * end on it.
 *
 * The parameter u runs along x or, if the flow is along x, along y. Bands of u are therefore side
 * by side when seen along z, as by ParaView's initial camera. The parameter v runs along the third
 * axis, against z if the flow is along y. The normal points along the positive axis, regardless of
 * the flow direction.
 *
 * vtkImplicitFlowField calls InitializeFromField, which sets Origin, Point1 and Point2, or returns
 * an error if the field has no flow.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationInflow : public vtkTerminationPlane
{
public:
  static vtkTerminationInflow* New();
  vtkTypeMacro(vtkTerminationInflow, vtkTerminationPlane);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Factor that scales the width and the height of the rectangle about its center. Default: 1.
   * Valid: 0.001 to 10; clamped.
   */
  vtkSetClampMacro(Size, double, 0.001, 10.0);
  vtkGetMacro(Size, double);
  ///@}

  std::string InitializeFromField(
    vtkDataSet* field, vtkDataArray* vectors, bool isBackward) override;
  bool IsPlacedByVectors() const override { return true; }

protected:
  vtkTerminationInflow() = default;
  ~vtkTerminationInflow() override = default;

private:
  vtkTerminationInflow(const vtkTerminationInflow&) = delete;
  void operator=(const vtkTerminationInflow&) = delete;

  double Size = 1.0;
};

#endif
