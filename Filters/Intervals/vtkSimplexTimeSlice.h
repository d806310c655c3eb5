// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSimplexTimeSlice_h
#define vtkSimplexTimeSlice_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkNew.h"                   // for the report
#include "vtkUnstructuredGridAlgorithm.h"

#include <array>  // for the normal
#include <string> // for messages

class vtkDataSet;

namespace interlume
{
class EmptyOutputDiagnosis;
class Error;
struct SimplexTimeSliceReport;
}

/**
 * @class   vtkSimplexTimeSlice
 * @brief   slice 4-simplices in space-time, by default at one time, to produce tetrahedra
 *
 * Cuts each 4-simplex by a hyperplane: at a time, at a position along x, y or z, or by any other
 * (see SliceAxis). The result is empty, a tetrahedron, or a triangular prism that is split into
 * three tetrahedra. The split of a face depends only on the ids of its points (the global ids, if
 * available), so tetrahedra of adjacent 4-simplices conform. vtkGeometryFilter therefore returns
 * the boundary of the slice; to get that of one interval, select its tetrahedra with vtkThreshold
 * first. vtkPlaneCutter and vtkContourFilter reduce the slice to triangles.
 *
 * Input: a vtkUnstructuredGrid with VTK_POLY_VERTEX cells of five points and a point array `Time`
 * (one component, any numeric type), as on port 2 of vtkTimeVaryingIntervalVolume, or a composite
 * dataset of such grids.
 *
 * Output: VTK_TETRA cells, with points in the precision of the input's points. A composite input
 * produces a composite output of the same structure. Arrays:
 * - point array `Time`: the time of the slice (double), interpolated if the slice is not at a time
 * - every other point array, interpolated linearly. Integers become float (8 and 16 bits) or
 *   double.
 * - every cell array except `AtStep`, copied from the 4-simplex
 *
 * Space consists of x, y and z for slices at a time. Otherwise, time replaces the coordinate with
 * the largest component of the normal, if it is larger than that of time: a slice along x has the
 * coordinates (t,y,z).
 *
 * A tetrahedron has the orientation of its 4-simplex: its volume is positive if det(p1-p0, p2-p0,
 * p3-p0, p4-p0) > 0 in (x,y,z,t).
 *
 * At the time of a time step, the slice consists of the faces of 4-simplices that lie at that time,
 * and likewise for other hyperplanes.
 * A face that several 4-simplices of one interval (cell array `IntervalId`) share is added once. A
 * 4-simplex that lies entirely at that time is ignored. The optional cell array `AtStep` (see
 * vtkTimeVaryingSettings::PartsAtStep) marks 4-simplices whose faces are ignored, and cells that
 * are themselves tetrahedra at a step. With it, the slice at a step is exactly the interval volume
 * of that step. Slices that are not at a time ignore it and cells that are tetrahedra. The result
 * does not depend on the number of threads.
 *
 * 4-simplices are skipped if they are ghost, hidden or blanked, or if a time or a coordinate is NaN
 * or infinite. A non-finite coordinate also causes a warning.
 *
 * Time: if FollowTime is on, the output has a TIME_RANGE: the range of the array `Time`, or
 * unlimited until the input has been updated.
 *
 * Errors (vtkErrorMacro, empty output): an invalid or missing point array `Time`, a cell that is
 * not a VTK_POLY_VERTEX of five points, or a slice time, position or normal that is not finite, or
 * a zero normal.
 *
 * Warning (vtkWarningMacro, once for a composite input): an empty output, with the reason. No
 * warning is issued if the input is one of several pieces.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
class INTERLUMEINTERVALS_EXPORT vtkSimplexTimeSlice : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSimplexTimeSlice* New();
  vtkTypeMacro(vtkSimplexTimeSlice, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Axes
  {
    X_AXIS = 0,
    Y_AXIS = 1,
    Z_AXIS = 2,
    TIME_AXIS = 3,
    HYPERPLANE = 4
  };
  ///@{
  /**
   * Set/get the hyperplane. TIME_AXIS slices at Time. X_AXIS, Y_AXIS and Z_AXIS slice where this
   * coordinate is Position. HYPERPLANE slices where Normal . (x,y,z,t) is Position; the normal need
   * not have unit length. Default: TIME_AXIS, position 0, normal (0,0,0,1).
   */
  vtkSetClampMacro(SliceAxis, int, X_AXIS, HYPERPLANE);
  vtkGetMacro(SliceAxis, int);
  vtkSetMacro(Position, double);
  vtkGetMacro(Position, double);
  vtkSetVector4Macro(Normal, double);
  vtkGetVector4Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Set/get the time of the slice, in the units of the array `Time`. Used unless FollowTime is on
   * and a time is requested. Default 0. Valid: any finite value.
   */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * If true, slice at the time requested downstream (UPDATE_TIME_STEP), as in an animation. The
   * time is clamped to the range of the array `Time`. Default on.
   */
  vtkSetMacro(FollowTime, bool);
  vtkGetMacro(FollowTime, bool);
  vtkBooleanMacro(FollowTime, bool);
  ///@}

  ///@{
  /**
   * If true, an execution with an empty output warns and reports the reason. Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  /**
   * Return the report of the last execution, for all datasets of a composite input:
   * - Time: time of the slice, or its Position if SliceAxis is not TIME_AXIS
   * - Simplices: number of input cells
   * - Tetrahedra: number of output cells
   * - NonFiniteSimplices: cells skipped because a time or a coordinate is NaN or infinite
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkSimplexTimeSlice();
  ~vtkSimplexTimeSlice() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Creates an unstructured grid for a dataset, or a composite dataset for a composite input.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Returns the time or position of the slice. \a output contains the requested time, if any.
  double GetPositionOfSlice(vtkInformation* output) const;
  /// Slices one dataset. \a request contains the requested time, or is null.
  void Slice(vtkDataSet* dataset, vtkInformation* request, vtkUnstructuredGrid* output,
    interlume::EmptyOutputDiagnosis& empty, interlume::SimplexTimeSliceReport& report);
  /// Returns the reason for an empty output at \a position.
  std::string ExplainEmpty(double position) const;

private:
  vtkSimplexTimeSlice(const vtkSimplexTimeSlice&) = delete;
  void operator=(const vtkSimplexTimeSlice&) = delete;

  bool IsAtTime() const { return this->SliceAxis == TIME_AXIS; }
  /// Returns the normal of the hyperplane in (x,y,z,t).
  std::array<double, 4> MakeNormal() const;

  int SliceAxis = TIME_AXIS;
  double Position = 0.0;
  double Normal[4] = { 0.0, 0.0, 0.0, 1.0 };
  double Time = 0.0;
  bool FollowTime = true;
  bool WarnOnEmptyOutput = true;
  /// Range of the times of the input, or of its positions along the normal. InputRange[0] >
  /// InputRange[1] if there are no times.
  double InputRange[2] = { 0.0, -1.0 };
  vtkNew<vtkInterlumeReport> Report;
};

#endif
