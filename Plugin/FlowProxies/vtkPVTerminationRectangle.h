// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVTerminationRectangle_h
#define vtkPVTerminationRectangle_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkTerminationPlane.h"

/**
 * @class   vtkPVTerminationRectangle
 * @brief   a rectangle by what ParaView's plane widget gives: its centre and normal
 *
 * u goes along the first edge and v along the second, with u x v the normal. With an angle of 0 and
 * a normal along an axis u is along the next axis: x for the normal z.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVTerminationRectangle : public vtkTerminationPlane
{
public:
  static vtkPVTerminationRectangle* New();
  vtkTypeMacro(vtkPVTerminationRectangle, vtkTerminationPlane);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The centre, in world units, and the normal. Default (0, 0, 0), (0, 0, 1). Valid: finite; a
   * normal of any length above 0.
   */
  void SetCenter(double x, double y, double z);
  vtkGetVector3Macro(Center, double);
  void SetNormal(double x, double y, double z);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * The lengths of the edges along u and v, in world units. 0: from the first to the last place of
   * the field along that edge, whose middle then need not be Center; 1 where there is no field yet.
   * So a rectangle is at first as large as the plane that ParaView's widget draws. Default (0, 0).
   * Valid: 0 and above.
   */
  void SetLengths(double u, double v);
  vtkGetVector2Macro(Lengths, double);
  ///@}

  ///@{
  /**
   * The angle that the edges are turned by around the normal, in degrees. Default 0.
   */
  void SetAngle(double angle);
  vtkGetMacro(Angle, double);
  ///@}

  std::string PlaceIn(vtkDataSet* field, vtkDataArray* vectors, bool isBackward) override;

protected:
  vtkPVTerminationRectangle() = default;
  ~vtkPVTerminationRectangle() override = default;

private:
  vtkPVTerminationRectangle(const vtkPVTerminationRectangle&) = delete;
  void operator=(const vtkPVTerminationRectangle&) = delete;

  /// Sets the three corners of the base class.
  void PlaceCorners();

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Lengths[2] = { 0.0, 0.0 };
  /// The bounds of the field; empty without one.
  double FieldBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Angle = 0.0;
};

#endif
