// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationCylinder_h
#define vtkPVTerminationCylinder_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationCylinder.h"

/**
 * @class   vtkPVTerminationCylinder
 * @brief   a cylinder by what ParaView's cylinder widget gives: its centre, axis and radius
 *
 * Point1 and Point2 of the base class are half of Length before and behind the centre, or where the
 * field ends along the axis.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationCylinder : public vtkTerminationCylinder
{
public:
  static vtkPVTerminationCylinder* New();
  vtkTypeMacro(vtkPVTerminationCylinder, vtkTerminationCylinder);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The centre and the axis, in world units. Default (0, 0, 0), (0, 0, 1). Valid: finite; an axis
   * of any length above 0.
   */
  void SetCenter(double x, double y, double z);
  vtkGetVector3Macro(Center, double);
  void SetAxis(double x, double y, double z);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * The length from end to end, in world units. 0: from the first to the last place of the field
   * along the axis, whose middle then need not be Center; 1 where there is no field yet. Default 0.
   * Valid: 0 and above.
   */
  void SetLength(double length);
  vtkGetMacro(Length, double);
  ///@}

  std::string PlaceIn(vtkDataSet* field, vtkDataArray* vectors, bool isBackward) override;

protected:
  vtkPVTerminationCylinder() = default;
  ~vtkPVTerminationCylinder() override = default;

private:
  vtkPVTerminationCylinder(const vtkPVTerminationCylinder&) = delete;
  void operator=(const vtkPVTerminationCylinder&) = delete;

  /// Sets the two points of the base class.
  void PlacePoints();

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Axis[3] = { 0.0, 0.0, 1.0 };
  double Length = 0.0;
  /// The bounds of the field; empty without one.
  double FieldBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

#endif
