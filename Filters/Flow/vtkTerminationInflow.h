// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationInflow_h
#define vtkTerminationInflow_h

#include "vtkTerminationPlane.h"

/**
 * @class   vtkTerminationInflow
 * @brief   rectangle where the flow enters the field, placed automatically
 *
 * The rectangle is perpendicular to the coordinate axis with the largest flow through a plane, and
 * close to the position where that flow enters the field. It lies in the first plane, in flow
 * direction, with at least 40 % of the largest flow. For FORWARD streamlines it lies where the flow
 * leaves the field, so that streamlines end on it. With Size 1 it covers all cells in its plane
 * that this flow crosses.
 *
 * The parameters u and v run along the next two axes in cyclic order: y and z for a normal along x.
 * The normal points along the positive axis, regardless of the flow direction.
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
   * Size of the rectangle around its center, as a fraction of the width and height of the area that
   * the flow crosses. Default: 1. Valid: 0.001 to 10; clamped.
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
