// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationCylinder_h
#define vtkPVTerminationCylinder_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationCylinder.h"

/**
 * @class   vtkPVTerminationCylinder
 * @brief   termination cylinder with the parameters of ParaView's cylinder widget
 *
 * Point1 and Point2 of the superclass lie on the axis, each at a distance of Length / 2 from the
 * center. If Length is 0, the cylinder spans the field along the axis.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationCylinder : public vtkTerminationCylinder
{
public:
  static vtkPVTerminationCylinder* New();
  vtkTypeMacro(vtkPVTerminationCylinder, vtkTerminationCylinder);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the center, in world units, and the direction of the axis. Default: (0, 0, 0), (0, 0,
   * 1). Valid: finite; an axis of any length above 0.
   */
  void SetCenter(double x, double y, double z);
  vtkGetVector3Macro(Center, double);
  void SetAxis(double x, double y, double z);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Set/Get the length of the cylinder, in world units. 0 selects the extent of the field along the
   * axis, or a length of 1 if the field is not available yet. Center is then not necessarily the
   * midpoint. Default: 0. Valid: 0 and above.
   */
  void SetLength(double length);
  vtkGetMacro(Length, double);
  ///@}

  std::string InitializeFromField(
    vtkDataSet* field, vtkDataArray* vectors, bool isBackward) override;

protected:
  vtkPVTerminationCylinder() = default;
  ~vtkPVTerminationCylinder() override = default;

private:
  vtkPVTerminationCylinder(const vtkPVTerminationCylinder&) = delete;
  void operator=(const vtkPVTerminationCylinder&) = delete;

  /// Sets Point1 and Point2 of the superclass.
  void PlacePoints();

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Axis[3] = { 0.0, 0.0, 1.0 };
  double Length = 0.0;
  /// Bounds of the field; empty (lower above upper) before InitializeFromField is called.
  double FieldBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

#endif
