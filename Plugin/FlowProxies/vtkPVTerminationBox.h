// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationBox_h
#define vtkPVTerminationBox_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationBox.h"

/**
 * @class   vtkPVTerminationBox
 * @brief   termination box with the parameters of ParaView's box widget
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationBox : public vtkTerminationBox
{
public:
  static vtkPVTerminationBox* New();
  vtkTypeMacro(vtkPVTerminationBox, vtkTerminationBox);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the lower corner of the box and the lengths of its edges, in world units. Default:
   * (-0.5, -0.5, -0.5), (1, 1, 1). Valid: a finite corner, lengths above 0.
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

  /// Sets the bounds of the superclass.
  void PlaceFaces();

  double Position[3] = { -0.5, -0.5, -0.5 };
  double Lengths[3] = { 1.0, 1.0, 1.0 };
};

#endif
