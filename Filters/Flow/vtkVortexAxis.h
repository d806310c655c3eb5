// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkVortexAxis_h
#define vtkVortexAxis_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkVortexAxis
 * @brief   find the axis of a vortex, such as the eye of a hurricane
 *
 * Finds points about which the flow rotates in planes perpendicular to Axis: the in-plane velocity
 * is 0, and its in-plane Jacobian has complex eigenvalues. The filter connects such points from
 * plane to plane, in both directions from the strongest one or from the one nearest to Seed. It
 * solves for the zeros in each cell, as vtkFlowCriticalPoints does, for any grid and axis; the
 * field is not resampled. See Documentation/methods/implicit-flow.md.
 *
 * Input: as for vtkFlowCriticalPoints.
 *
 * Output: polylines along Axis with the point arrays `CrossFlowSpeed` (double: speed in the plane,
 * 0 up to rounding error), `SwirlStrength` (double: imaginary part of the eigenvalues, radians per
 * unit of time; the active scalars) and `AxialVelocity` (double: velocity along Axis). Speed and
 * velocity are relative to FrameVelocity. If no point is found within SearchRadius in a plane, the
 * polyline ends, and a new one starts at the next plane with such a point. A point without
 * neighbors becomes a vertex. The output is identical for any number of threads.
 *
 * Warnings (vtkWarningMacro): no vortex was found (empty output; the message states the number of
 * zeros); cells skipped because vectors look like fill values (see
 * vtkImplicitFlowField::SetMaximumError), or are NaN or infinite.
 *
 * Errors (vtkErrorMacro, empty output): as for vtkFlowCriticalPoints; an Axis of length 0; settings
 * that are not finite.
 *
 * @sa vtkFlowCriticalPoints vtkTerminationTube
 */
class INTERLUMEFLOW_EXPORT vtkVortexAxis : public vtkPolyDataAlgorithm
{
public:
  static vtkVortexAxis* New();
  vtkTypeMacro(vtkVortexAxis, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Normal direction of the planes, of any length above 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Number of evenly spaced planes from the first to the last point along Axis; a single plane is
   * at the midpoint. 0 selects an automatic number. If Axis is parallel to a grid direction of
   * image data or a rectilinear grid, there is one plane per layer of points. Other structured
   * grids get as many planes as they have points in the grid direction closest to Axis, and all
   * other datasets the cube root of their number of points. Default: 0. Valid: 0 to 100000;
   * clamped.
   */
  vtkSetClampMacro(NumberOfPlanes, int, 0, 100000);
  vtkGetMacro(NumberOfPlanes, int);
  ///@}

  ///@{
  /**
   * If true, select the vortex nearest to Seed, in the nearest plane with a vortex, instead of the
   * vortex with the largest SwirlStrength. Seed is in world units. Default: off, (0, 0, 0).
   */
  vtkSetMacro(UseSeed, bool);
  vtkGetMacro(UseSeed, bool);
  vtkBooleanMacro(UseSeed, bool);
  vtkSetVector3Macro(Seed, double);
  vtkGetVector3Macro(Seed, double);
  ///@}

  ///@{
  /**
   * Velocity subtracted from all vectors, such as the velocity of a traveling vortex. Default: (0,
   * 0, 0).
   */
  vtkSetVector3Macro(FrameVelocity, double);
  vtkGetVector3Macro(FrameVelocity, double);
  ///@}

  ///@{
  /**
   * Maximum distance, perpendicular to Axis, between connected vortices in adjacent planes, in
   * world units; n times as much for vortices that are n planes apart. Connected vortices have the
   * same sense of rotation. 0 selects twice the sum of the distance between the planes and the cell
   * size. Default: 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(SearchRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SearchRadius, double);
  ///@}

  ///@{
  /**
   * Minimum SwirlStrength of a vortex, in radians per unit of time. Default: 0. Valid: 0 and above;
   * clamped.
   */
  vtkSetClampMacro(MinimumSwirlStrength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSwirlStrength, double);
  ///@}

  /**
   * Return the report of the last execution:
   * - Planes: planes perpendicular to Axis,
   * - CrossFlowZeros: points where the velocity in the plane is 0,
   * - PointsOnAxis: points of the output,
   * - NonFiniteCells: cells skipped because vectors are not finite,
   * - FillValueCells: cells skipped because the vector at a point is a fill value,
   * - ConvertedCellArrays: name of the vectors if they are a cell array.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkVortexAxis();
  ~vtkVortexAxis() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVortexAxis(const vtkVortexAxis&) = delete;
  void operator=(const vtkVortexAxis&) = delete;

  double Axis[3] = { 0.0, 0.0, 1.0 };
  int NumberOfPlanes = 0;
  bool UseSeed = false;
  double Seed[3] = { 0.0, 0.0, 0.0 };
  double FrameVelocity[3] = { 0.0, 0.0, 0.0 };
  double SearchRadius = 0.0;
  double MinimumSwirlStrength = 0.0;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
