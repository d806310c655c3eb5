// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationInflow_h
#define vtkTerminationInflow_h

#include "vtkTerminationPlane.h"

/**
 * @class   vtkTerminationInflow
 * @brief   a rectangle where the flow enters the field, placed by itself
 *
 * The rectangle lies across x, y or z, whichever has the most flow through a plane across it, close
 * to where that flow enters the field: the first plane along the flow of those through which at
 * least four tenths of the most goes (interlume::InflowFinder). Where streamlines are followed
 * along the vectors it is where the flow leaves instead, so that streamlines end on it. With Size 1
 * it has all cells that this flow goes through there.
 *
 * u goes along the axis after the normal's, v along the next one: for a normal along x along y and
 * z. The normal is along the axis, whether the flow is or not.
 *
 * Origin, Point1 and Point2 are replaced by PlaceIn, which vtkImplicitFlowField calls. It reports
 * a field without any flow.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationInflow : public vtkTerminationPlane
{
public:
  static vtkTerminationInflow* New();
  vtkTypeMacro(vtkTerminationInflow, vtkTerminationPlane);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The part of the flow's width and height that the rectangle takes, around its middle. Default 1.
   * Valid: 0.001 to 10.
   */
  vtkSetClampMacro(Size, double, 0.001, 10.0);
  vtkGetMacro(Size, double);
  ///@}

  std::string PlaceIn(vtkDataSet* field, vtkDataArray* vectors, bool isBackward) override;
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
