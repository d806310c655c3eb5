// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeVaryingIntervalVolume_h
#define vtkTimeVaryingIntervalVolume_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkIntervalAlgorithm.h"
#include "vtkNew.h"                 // for the report
#include "vtkTimeVaryingSettings.h" // for the settings

#include <functional> // for estimates
#include <memory>     // for the state between time steps
#include <string>     // for messages
#include <vector>     // for the time steps

namespace interlume
{
class CoarseSeries;
class Error;
class SeriesEstimate;
class TimeVaryingRun;
struct TimeVaryingReport;
}

/**
 * @class   vtkTimeVaryingIntervalVolume
 * @brief   extract the space-time region between two isovalues, projected to space
 *
 * Extracts the set { (x,t) : lower <= f(x,t) <= upper } of a time-varying scalar as 4-simplices and
 * projects them along the time axis, or along ProjectionDirection, to tetrahedra that store their
 * duration. The scalar f is linear on every edge of a cell and linear in time between the time
 * steps. For the method, see Documentation/methods/time-varying-intervals.md; for timings, see
 * Documentation/measurements.md.
 *
 * Input: a temporal source with at least two time steps. For dataset types, cell types, the scalar
 * and skipped cells, see vtkIntervalVolume. All time steps are requested through the pipeline, one
 * after another; two are held in memory. Points may move between steps, but the cells must not
 * change.
 *
 * Output port 0, unless GenerateTetrahedra is off: VTK_TETRA cells with
 * - point array `DeltaT` (double, units of time): the duration of the 4-simplex at the point. It is
 *   nonzero at one point of each tetrahedron. The tetrahedra overlap. At any position, the sum of
 *   their interpolated DeltaT is the time that f spends in the interval there.
 * - point array `Time` (double): the time of the point; at a point with nonzero DeltaT, the mean
 *   over the duration
 * - every point array that all steps have, interpolated linearly. Integer arrays become float (8-
 *   and 16-bit types) or double. Unnamed arrays of different steps are matched by attribute type or
 *   by their order.
 * - cell arrays `SimplexClass` (unsigned char, see SimplexClasses), `IntervalId` (int) and
 *   `TimeSlab` (int; slab i lies between selected steps i and i + 1). Cell arrays of the input are
 *   not copied.
 *
 * Output port 1: the selected boundaries as triangles and tetrahedra in space, with `Time` and the
 * other point arrays, and cell arrays `BoundaryKind` (int, see BoundaryKinds), `IntervalId` and
 * `TimeSlab`. Start and end are the first and last selected time step. Surfaces in time where the
 * array of criterion i equals its bound have the kind 2 i + 8 (lower) or 2 i + 9 (upper).
 *
 * Output port 2, if GenerateSimplices is on: the 4-simplices as VTK_POLY_VERTEX cells of five
 * points, positively oriented in (x,y,z,t), with `Time` and the other point arrays, and cell arrays
 * `IntervalId`, `TimeSlab` and `AtStep` (unsigned char, see PartsAtStep). This is the input of
 * vtkSimplexTimeSlice. Adjacent slabs share their points.
 *
 * Values equal to a bound and distributed grids are treated as in vtkIntervalVolume. The processed
 * array is the active scalars. The result does not depend on the number of threads.
 *
 * Previews (PreviewCellLimit): the limit is the number of cells times the number of slabs. If there
 * are more, the preview uses fewer steps and coarser grids in turn. Copies of its steps remain in
 * memory, so only the first preview requests steps from the input.
 *
 * If the source overwrites the memory of the previous time step, the execution restarts and copies
 * every step.
 *
 * Errors (vtkErrorMacro, empty output): fewer than two time steps, times that decrease or are not
 * finite, a zero projection direction, and the errors of vtkIntervalVolume. A step without the
 * scalar is an error, and so is one whose grid type, number of points or cells, or connectivity
 * differs from the previous step.
 *
 * Warnings (vtkWarningMacro): an array that is skipped because it is missing in a step or named
 * `DeltaT` or `Time`; a slab that is skipped because its duration is zero; an empty output (see
 * WarnOnEmptyOutput); a large output (see SizeWarningLimit), estimated from the slabs so far; and
 * the warnings of vtkIntervalVolume, except for quadratic cells.
 *
 * @sa vtkIntervalVolume vtkSimplexTimeSlice vtkTimeWeightedTetrahedraMapper vtkTimeSlabWriter
 */
class INTERLUMEINTERVALS_EXPORT vtkTimeVaryingIntervalVolume
  : public vtkIntervalAlgorithm
  , private vtkTimeVaryingSettings
{
public:
  static vtkTimeVaryingIntervalVolume* New();
  vtkTypeMacro(vtkTimeVaryingIntervalVolume, vtkIntervalAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Enumerations that are documented in vtkTimeVaryingSettings.
   */
  using vtkTimeVaryingSettings::BoundaryKinds;
  using vtkTimeVaryingSettings::CLASS_1;
  using vtkTimeVaryingSettings::CLASS_2;
  using vtkTimeVaryingSettings::CLASS_3A;
  using vtkTimeVaryingSettings::CLASS_3B;
  using vtkTimeVaryingSettings::CLASS_4;
  using vtkTimeVaryingSettings::CLASS_5;
  using vtkTimeVaryingSettings::FACES_AT_STEP;
  using vtkTimeVaryingSettings::LOWER_SURFACE_AT_END;
  using vtkTimeVaryingSettings::LOWER_SURFACE_AT_START;
  using vtkTimeVaryingSettings::LOWER_SURFACE_IN_TIME;
  using vtkTimeVaryingSettings::NOTHING_AT_STEP;
  using vtkTimeVaryingSettings::NUMBER_OF_BOUNDARY_KINDS;
  using vtkTimeVaryingSettings::PartsAtStep;
  using vtkTimeVaryingSettings::SimplexClasses;
  using vtkTimeVaryingSettings::TETRAHEDRON_AT_STEP;
  using vtkTimeVaryingSettings::UPPER_SURFACE_AT_END;
  using vtkTimeVaryingSettings::UPPER_SURFACE_AT_START;
  using vtkTimeVaryingSettings::UPPER_SURFACE_IN_TIME;
  using vtkTimeVaryingSettings::VOLUME_AT_END;
  using vtkTimeVaryingSettings::VOLUME_AT_START;
  ///@}

  ///@{
  /**
   * Set/get the indices of the first and the last time step to use. A last index past the end
   * selects the last step of the input. Default (0, VTK_INT_MAX). Valid: 0 <= first < last.
   */
  vtkSetVector2Macro(TimeStepRange, int);
  vtkGetVector2Macro(TimeStepRange, int);
  ///@}

  ///@{
  /**
   * Set/get the stride of the time steps: every TimeStepStride-th step of TimeStepRange is used,
   * and always the last one. Larger strides make fewer and longer slabs. Default 1.
   */
  vtkSetClampMacro(TimeStepStride, int, 1, VTK_INT_MAX);
  vtkGetMacro(TimeStepStride, int);
  ///@}

  /**
   * Estimate the number of tetrahedra that an execution with the current settings creates. Updates
   * the input at up to twelve time steps, and extracts a sample of cells. The number does
   * not consider criteria, nor does the warning about a large output. Returns 0 if an execution
   * would report an error, except about the array of a criterion. With several processes, the
   * number refers to this process, and all processes must call the function.
   */
  vtkIdType EstimateNumberOfTetrahedra();

  /**
   * Choose time steps for which the estimated number of tetrahedra is at most SizeWarningLimit, and
   * return the estimate. Sets TimeStepStride to the lowest sufficient value. If fewer than four
   * slabs would remain, it shortens TimeStepRange instead, to at least one slab. Updates the input
   * at some of its time steps; see EstimateNumberOfTetrahedra() for processes and errors.
   */
  vtkIdType LimitTimeSteps();

  ///@{
  /**
   * Set/get the direction (x,y,z,t) along which 4-simplices are projected. It can have any nonzero
   * length. For the default (0,0,0,1), the time axis, the result lies in space. For another
   * direction d, it lies in the space orthogonal to d. The axes of that space are x, y, z rotated
   * by the smallest rotation that takes the time axis to d, or to -d if that is closer. DeltaT is
   * then the Euclidean length of the 4-simplex along d.
   */
  vtkSetVector4Macro(ProjectionDirection, double);
  vtkGetVector4Macro(ProjectionDirection, double);
  ///@}

  ///@{
  /**
   * If true, generate the tetrahedra on port 0. Default on.
   */
  vtkSetMacro(GenerateTetrahedra, bool);
  vtkGetMacro(GenerateTetrahedra, bool);
  vtkBooleanMacro(GenerateTetrahedra, bool);
  ///@}

  ///@{
  /**
   * If true, generate the 4-simplices on port 2. Default off.
   */
  vtkSetMacro(GenerateSimplices, bool);
  vtkGetMacro(GenerateSimplices, bool);
  vtkBooleanMacro(GenerateSimplices, bool);
  ///@}

  ///@{
  /**
   * If true, port 1 contains the boundary cells of kind \a kind (see BoundaryKinds). Default off.
   * SetGenerateBoundaries sets the flags of all kinds. It is an error to set an invalid kind. With
   * UNION, the surfaces of the intervals are complete, and those of a criterion are the ones
   * outside of the intervals and of earlier criteria. A cell that equals the value of an interval
   * of zero width at one step only is then part of both regions at that step.
   */
  void SetGenerateBoundary(int kind, bool on);
  bool GetGenerateBoundary(int kind) const;
  void GenerateBoundaryOn(int kind) { this->SetGenerateBoundary(kind, true); }
  void GenerateBoundaryOff(int kind) { this->SetGenerateBoundary(kind, false); }
  void SetGenerateBoundaries(bool on);
  vtkBooleanMacro(GenerateBoundaries, bool);
  ///@}

  /**
   * Return the report of the last execution, summed over the slabs:
   * - TimeSteps, Slabs: number of requested time steps, and of slabs that were not skipped
   * - CellsWithOutput: cells with at least one simplex, before criteria
   * - BlankedCells: cells skipped because the cell or one of its points is blanked, hidden or a
   *   ghost
   * - NonFiniteCells: cells skipped because a value or a coordinate is NaN or infinite
   * - UnsupportedCells: cells skipped because of their type
   * - ConcavePolyhedra: polyhedra whose simplices overlap
   * - Simplices, FlatSimplices, InvertedSimplices: number of all 4-simplices, of degenerate
   *   4-simplices, which yield no tetrahedra, and of negatively oriented 4-simplices, which yield
   *   inverted tetrahedra
   * - ConvertedCellArrays: name of the scalar if it is a cell array, averaged at the points
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /// Return the value NonFiniteCells of the report.
  vtkIdType GetNumberOfNonFiniteCells() { return this->Report->GetCount("NonFiniteCells"); }

protected:
  vtkTimeVaryingIntervalVolume();
  ~vtkTimeVaryingIntervalVolume() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /// Processes one time step, then requests the next one or fills the outputs. Sets \a report to
  /// the counts of the time steps processed so far.
  void ProcessStep(vtkInformation*, vtkInformationVector**, vtkInformationVector*,
    interlume::TimeVaryingReport& report);

  /// Returns an error if there are fewer than two steps, or if their times decrease or are not
  /// finite.
  interlume::Error CheckTimes(const std::vector<int>& steps) const;
  interlume::Error CheckDirection() const;
  /// Returns an error if criteria have an operation or an array that is not possible over time.
  interlume::Error CheckCriteriaSettings() const;
  /// Returns the indices of the steps of TimeStepRange with the given stride.
  std::vector<int> GetSelectedSteps(int stride) const;
  std::vector<double> GetTimes(const std::vector<int>& steps) const;
  /// Starts an execution, which copies the time steps if \a copiesSteps is true. Reports an error
  /// and returns false if a parameter is invalid.
  bool Begin(bool copiesSteps);
  /// Returns whether the last execution processed all steps and filled its outputs.
  bool HasFilledOutputs() const { return this->IsFilled; }
  /// Returns why all outputs of a complete run are empty, or an empty string if no warning is due.
  std::string ExplainEmpty(interlume::TimeVaryingRun& run);

private:
  /// Samples the input. \a chooseDistances returns the distances of the slabs to sample, up to \a
  /// lastStep. Returns null if the input cannot be extracted.
  std::unique_ptr<interlume::SeriesEstimate> EstimateSeries(
    const std::function<std::vector<int>(int lastStep)>& chooseDistances);

  /// Starts a preview if PreviewCellLimit is not 0, and otherwise ends it. \a input is the
  /// information of the input. Returns true if there are coarse copies of all steps.
  bool BeginPreview(const std::vector<int>& steps, vtkInformation* input);

  vtkTimeVaryingIntervalVolume(const vtkTimeVaryingIntervalVolume&) = delete;
  void operator=(const vtkTimeVaryingIntervalVolume&) = delete;

  vtkNew<vtkInterlumeReport> Report;
  /// Times of the input's time steps.
  std::vector<double> TimeSteps;
  /// State between time steps; null between executions.
  std::unique_ptr<interlume::TimeVaryingRun> Run;
  /// Coarse copies of the steps; null if the last execution was not a preview.
  std::unique_ptr<interlume::CoarseSeries> Coarse;
  bool IsFilled = false;
  /// If true, this execution was already restarted. It is restarted at most once.
  bool IsRestarted = false;
};

#endif
