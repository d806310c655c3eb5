// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationBox_h
#define vtkPVTerminationBox_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationBox.h"

/**
 * @class   vtkPVTerminationBox
 * @brief   a box by what ParaView's box widget gives: its lowest corner and the lengths of its
 * edges
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationBox : public vtkTerminationBox
{
public:
  static vtkPVTerminationBox* New();
  vtkTypeMacro(vtkPVTerminationBox, vtkTerminationBox);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The lowest corner of the box, and the lengths of its edges, in world units. Default (-0.5,
   * -0.5, -0.5), (1, 1, 1). Valid: finite; above 0.
   */
  void SetPosition(double x, double y, double z);
  vtkGetVector3Macro(Position, double);
  void SetLengths(double x, double y, double z);
  vtkGetVector3Macro(Lengths, double);
  ///@}

protected:
  vtkPVTerminationBox() = default;
  ~vtkPVTerminationBox() override = default;

private:
  vtkPVTerminationBox(const vtkPVTerminationBox&) = delete;
  void operator=(const vtkPVTerminationBox&) = delete;

  /// Sets the bounds of the base class.
  void PlaceFaces();

  double Position[3] = { -0.5, -0.5, -0.5 };
  double Lengths[3] = { 1.0, 1.0, 1.0 };
};

#endif
