// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkVortexAxis_h
#define vtkVortexAxis_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkVortexAxis
 * @brief   the axis of a vortex, as the eye of a hurricane: the line of vanishing cross-flow speed
 *
 * C. Zhang, dissertation, Ohio State 2006, section 4.6 takes "the path of the zero-velocity points"
 * for a hurricane's eye. On planes across Axis, the places are found where the velocity in the
 * plane is 0 and turns around there: where its Jacobian in the plane has complex eigenvalues. One
 * of them is followed from plane to plane, from the one nearest to Seed or the strongest one, up
 * and down.
 *
 * The places are the zeros of the interpolated velocity in the plane, solved for in each cell as in
 * vtkFlowCriticalPoints: exact on any grid, for any axis. Nothing is sampled.
 *
 * Input: as for vtkFlowCriticalPoints.
 *
 * Output: a polyline along Axis, with the point arrays `CrossFlowSpeed` (double: the speed in the
 * plane, 0 to rounding), `SwirlStrength` (double: the imaginary part of the eigenvalues, radians in
 * a unit of time) and `AxialVelocity` (double: the velocity along Axis), both velocities less
 * FrameVelocity. Where no plane's place is near enough the polyline ends, and another begins where
 * there is one again; a place alone is a vertex. SwirlStrength is the active scalars. Without a
 * vortex the output is empty, and a warning (vtkWarningMacro) says how many places were looked at.
 * Cells with vectors that look like fill values (as for vtkImplicitFlowField::SetMaximumError), or
 * that are NaN or infinite, are skipped, with a warning.
 *
 * The same bytes for any number of threads.
 *
 * Errors (vtkErrorMacro, empty output): those of vtkFlowCriticalPoints; an Axis that is 0; values
 * that are not finite.
 *
 * @sa vtkFlowCriticalPoints
 */
class INTERLUMEFLOW_EXPORT vtkVortexAxis : public vtkPolyDataAlgorithm
{
public:
  static vtkVortexAxis* New();
  vtkTypeMacro(vtkVortexAxis, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The direction that the planes are perpendicular to; its length does not matter. Default (0, 0,
   * 1).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * The number of evenly spaced planes from the first to the last point along Axis; one plane is in
   * the middle. 0: one for each layer of points, in images and rectilinear grids along one of whose
   * directions Axis is. In other grids with an order there are as many planes as points in the
   * direction nearest to Axis, elsewhere as the cube root of the number of points. Default 0.
   * Valid: 0 to 100000.
   */
  vtkSetClampMacro(NumberOfPlanes, int, 0, 100000);
  vtkGetMacro(NumberOfPlanes, int);
  ///@}

  ///@{
  /**
   * Whether the vortex is the one nearest to Seed, in the plane nearest to it that has one, rather
   * than the one with the largest SwirlStrength. Default off, (0, 0, 0).
   */
  vtkSetMacro(UseSeed, bool);
  vtkGetMacro(UseSeed, bool);
  vtkBooleanMacro(UseSeed, bool);
  vtkSetVector3Macro(Seed, double);
  vtkGetVector3Macro(Seed, double);
  ///@}

  ///@{
  /**
   * The velocity that is subtracted from all velocities, such as that of a vortex that travels.
   * Default (0, 0, 0).
   */
  vtkSetVector3Macro(FrameVelocity, double);
  vtkGetVector3Macro(FrameVelocity, double);
  ///@}

  ///@{
  /**
   * The largest distance across Axis to the place in the next plane, in units of length; n times as
   * much for a place n planes on. 0: two distances of the planes, and two lengths of the cell. It
   * also has to turn in the same sense. Default 0. Valid: 0 and above.
   */
  vtkSetClampMacro(SearchRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SearchRadius, double);
  ///@}

  ///@{
  /**
   * The least SwirlStrength of a vortex, in radians in a unit of time; weaker places are no
   * vortices. Default 0. Valid: 0 and above.
   */
  vtkSetClampMacro(MinimumSwirlStrength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSwirlStrength, double);
  ///@}

  /**
   * Returns what the last execution did:
   * - Planes: planes across Axis,
   * - CrossFlowZeros: places in the planes where the velocity across Axis is 0,
   * - PointsOnAxis: those among them that belong to one vortex, which are the points of the line,
   * - NonFiniteCells: cells that were skipped because they are not finite,
   * - FillValueCells: cells that were skipped because a point has fill values.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkVortexAxis();
  ~vtkVortexAxis() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
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
