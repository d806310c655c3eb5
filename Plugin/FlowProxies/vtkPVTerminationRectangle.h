// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationRectangle_h
#define vtkPVTerminationRectangle_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationPlane.h"

/**
 * @class   vtkPVTerminationRectangle
 * @brief   termination rectangle with the parameters of ParaView's plane widget
 *
 * The parameter u runs along the first edge and v along the second; u x v is the normal. If Angle
 * is 0 and the normal is a coordinate axis, u runs along the next coordinate axis: along x for a
 * normal along z.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationRectangle : public vtkTerminationPlane
{
public:
  static vtkPVTerminationRectangle* New();
  vtkTypeMacro(vtkPVTerminationRectangle, vtkTerminationPlane);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the center, in world units, and the normal. Default: (0, 0, 0), (0, 0, 1). Valid:
   * finite; a normal of any length above 0.
   */
  void SetCenter(double x, double y, double z);
  vtkGetVector3Macro(Center, double);
  void SetNormal(double x, double y, double z);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Set/Get the lengths of the edges along u and v, in world units. 0 selects the extent of the
   * field along the edge, or a length of 1 if the field is not available yet. Center is then not
   * necessarily the midpoint. By default, the rectangle is as large as the plane that ParaView's
   * widget shows. Default: (0, 0). Valid: 0 and above.
   */
  void SetLengths(double u, double v);
  vtkGetVector2Macro(Lengths, double);
  ///@}

  ///@{
  /**
   * Set/Get the rotation of the edges about the normal, in degrees. Default: 0.
   */
  void SetAngle(double angle);
  vtkGetMacro(Angle, double);
  ///@}

  std::string InitializeFromField(
    vtkDataSet* field, vtkDataArray* vectors, bool isBackward) override;

protected:
  vtkPVTerminationRectangle() = default;
  ~vtkPVTerminationRectangle() override = default;

private:
  vtkPVTerminationRectangle(const vtkPVTerminationRectangle&) = delete;
  void operator=(const vtkPVTerminationRectangle&) = delete;

  /// Sets Origin, Point1 and Point2 of the superclass.
  void PlaceCorners();

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Lengths[2] = { 0.0, 0.0 };
  /// Bounds of the field; empty (lower above upper) before InitializeFromField is called.
  double FieldBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Angle = 0.0;
};

#endif
