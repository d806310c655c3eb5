// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSimplexTimeSlice_h
#define vtkSimplexTimeSlice_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkNew.h"                   // for the report
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for messages

class vtkDataSet;

namespace interlume
{
class EmptyResult;
class Error;
struct SimplexTimeSliceReport;
}

/**
 * @class   vtkSimplexTimeSlice
 * @brief   4-simplices in space and time at one time: tetrahedra
 *
 * Takes the part of each 4-simplex at time t: nothing, a tetrahedron, or a prism over a triangle
 * that is cut into three tetrahedra. The cut of a face that two 4-simplices share depends on its
 * points' ids alone (the global ids where the point data has them), so no cracks appear.
 *
 * Input: a vtkUnstructuredGrid with VTK_POLY_VERTEX cells of five points and a point array `Time`
 * (one component, any numeric type), as port 2 of vtkTimeVaryingIntervalVolume gives them, or as
 * they were read back from a file; or a composite dataset of such, which gives a composite output
 * of the same structure.
 *
 * Output: VTK_TETRA cells, points in the precision of the input's, with
 * - point array `Time` (double): the time of the slice;
 * - every other point array, interpolated linearly; integers come out as float (8 and 16 bits) or
 *   double;
 * - every cell array, copied from the 4-simplex.
 *
 * A tetrahedron has the orientation of its 4-simplex: positive volume where that is positively
 * oriented in (x,y,z,t), det(p1-p0, p2-p0, p3-p0, p4-p0) > 0.
 *
 * At the time of a time step the slice is the faces of 4-simplices that lie in it, each once for
 * each interval (the cell array `IntervalId`, where there is one), whether 4-simplices end there,
 * begin there, or both. A 4-simplex that lies in the slice as a whole gives nothing. Where there is
 * the cell array `AtStep` (see vtkTimeVaryingIntervalVolume::PartsAtStep) it tells of 4-simplices
 * whose faces do not count, and of tetrahedra at a step, that are in the slice as they are. So of
 * vtkTimeVaryingIntervalVolume the slice at a step is the interval volume of that step, tetrahedron
 * by tetrahedron, whatever values equal bounds. The same input gives the same bytes whatever the
 * number of threads.
 *
 * 4-simplices with a time or, with a warning, a coordinate that is NaN or infinite are skipped and
 * counted in GetReport(). Ghost, hidden and blanked 4-simplices are skipped too.
 *
 * In a pipeline with time: where a time is asked for downstream, the slice is at that time, see
 * FollowTime. The output's information then has a range of times (TIME_RANGE): that of the array
 * `Time` where the input is there already, else any time.
 *
 * Warning (vtkWarningMacro, once for a composite input): an empty output, and why; a time outside
 * of all 4-simplices is one reason. One piece of several gives no warning.
 *
 * Errors (vtkErrorMacro, empty output): no point array `Time` with one component and a value for
 * each point, a cell that is not a VTK_POLY_VERTEX of five points (the message names the first), a
 * time of the slice that is not finite.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
class INTERLUMEINTERVALS_EXPORT vtkSimplexTimeSlice : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSimplexTimeSlice* New();
  vtkTypeMacro(vtkSimplexTimeSlice, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The time of the slice, in the units of the array `Time`, unless FollowTime finds another.
   * Default 0. Any finite value.
   */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * Whether the slice is at the time that is asked for downstream (UPDATE_TIME_STEP), as in an
   * animation, where one is asked for. A time before the first or after the last of the array
   * `Time` is taken as that one. Default on.
   */
  vtkSetMacro(FollowTime, bool);
  vtkGetMacro(FollowTime, bool);
  vtkBooleanMacro(FollowTime, bool);
  ///@}

  ///@{
  /**
   * Whether an execution that gives nothing warns, and says why. Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  /**
   * Returns the report of the last execution, over all datasets of a composite input:
   * - Time: the time of the slice
   * - Simplices: cells of the input
   * - Tetrahedra: cells of the output
   * - NonFiniteSimplices: cells skipped because a time or a coordinate is NaN or infinite
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkSimplexTimeSlice();
  ~vtkSimplexTimeSlice() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Creates an output that is an unstructured grid or a composite dataset, as the input is.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Returns the time to cut at for what is asked of the output.
  double GetTimeOfSlice(vtkInformation* output) const;
  /// Slices one dataset. \a request may have the time requested of the output; null for none.
  void Slice(vtkDataSet* dataset, vtkInformation* request, vtkUnstructuredGrid* output,
    interlume::EmptyResult& empty, interlume::SimplexTimeSliceReport& report);
  /// Returns why there is no output at a time.
  std::string ExplainEmpty(double time) const;

private:
  vtkSimplexTimeSlice(const vtkSimplexTimeSlice&) = delete;
  void operator=(const vtkSimplexTimeSlice&) = delete;

  double Time = 0.0;
  bool FollowTime = true;
  bool WarnOnEmptyOutput = true;
  /// The first and last time of the input; the first is above the last where the input has none.
  double InputRange[2] = { 0.0, -1.0 };
  vtkNew<vtkInterlumeReport> Report;
};

#endif
