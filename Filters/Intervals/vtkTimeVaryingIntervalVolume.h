// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeVaryingIntervalVolume_h
#define vtkTimeVaryingIntervalVolume_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkIntervalAlgorithm.h"
#include "vtkNew.h"                 // for the report
#include "vtkTimeVaryingSettings.h" // for what is set

#include <memory> // for the state between time steps
#include <string> // for messages
#include <vector> // for the time steps

namespace interlume
{
class Error;
class TimeVaryingRun;
struct TimeVaryingReport;
}

/**
 * @class   vtkTimeVaryingIntervalVolume
 * @brief   the region between two isovalues of a field in space and time, projected to space
 *
 * The set { (x,t) : lower <= f(x,t) <= upper } of a scalar point array that changes in time is four
 * dimensional. It is made slab by slab, between two time steps at a time: each cell times the slab
 * is lifted to five dimensions, F(x,t,w) = f(x,t) - (lower (1-w) + upper w), the isosurface F = 0
 * there is taken from an isotable that is filled at run time, and projected back along w. This
 * gives 4-simplices. Each is projected along the time axis (or another direction) to space, where
 * it is cut into at most six tetrahedra around the one point where it is thickest (C. Zhang,
 * dissertation, Ohio State 2006, chapter 3.5; here the cut is that of the Radon partition of the
 * five points, which has the six classes of figure 3.15 as its sign patterns).
 *
 * Input: a temporal source with at least two time steps, of vtkImageData, vtkRectilinearGrid,
 * vtkStructuredGrid, vtkUnstructuredGrid with tetrahedra, voxels, hexahedra, wedges, pyramids and
 * convex polyhedra, and composite datasets of them, which give composite outputs of the same
 * structure. All time steps are requested through the pipeline, one after the other; two are held.
 * Points may move from step to step, cells may not change. The scalar: SetInputArrayToProcess(0,
 * ...), by default the active point scalars, one component. It is taken to be linear between steps
 * on every edge.
 *
 * Output port 0, made unless GenerateTetrahedra is off: VTK_TETRA cells with
 * - point array `DeltaT` (double, units of time): how long the 4-simplex lasts there; zero at all
 *   points of a tetrahedron but one, linear in between. Tetrahedra overlap: over all of them the
 * sum of DeltaT at a point of space is the time that f is in the interval there.
 * - point array `Time` (double): the time of a point; at the thick point the mean over DeltaT;
 * - every point array that all steps have, interpolated; at the thick point its mean over DeltaT.
 *   Integers come out as float (8 and 16 bits) or double. An array that a step lacks, or that is
 *   named as one of the two above, is left out with a warning. Arrays without a name correspond by
 *   their role (scalars, vectors, ...), or else by their order;
 * - cell arrays `SimplexClass` (unsigned char, see SimplexClasses), `IntervalId` (int), `TimeSlab`
 *   (int; slab i lies between steps i and i+1 of those that are taken). The input's cell arrays
 * belong to one step each, and are not carried.
 *
 * The integral of DeltaT over a tetrahedron is a quarter of its volume times its one DeltaT, and
 * the sum over the tetrahedra of a 4-simplex is its hypervolume. On cells with arbitrary values a
 * few 4-simplices come out inverted, as in vtkIntervalVolume; their tetrahedra are inverted too, so
 * that signed sums are right.
 *
 * Output port 1: the boundaries that are asked for, triangles and tetrahedra in space, with the
 * points, `Time` and other point arrays of port 2, and cell arrays `BoundaryKind` (int, see
 * BoundaryKinds), `IntervalId`, `TimeSlab`. Start and end are the first and the last of the time
 * steps taken.
 *
 * Output port 2, made only when GenerateSimplices is on: the 4-simplices as VTK_POLY_VERTEX cells
 * of five points, positively oriented in (x,y,z,t), with point array `Time` and all other point
 * arrays, cell arrays `IntervalId`, `TimeSlab`, `AtStep` (unsigned char, see PartsAtStep). Ready
 * for a writer, and for vtkSimplexTimeSlice. Points that two slabs share are one point. Where
 * values equal bounds, faces of 4-simplices are not all of the interval volume at a step, nor all
 * in it: it is there as cells of its own, without hypervolume.
 *
 * Values equal to a bound, and the identity of points: as in vtkIntervalVolume, one dimension up.
 * [a, a] is the cells whose corners are all equal to a at both steps of a slab. Counted with their
 * orientation the faces of an interval's 4-simplices cancel over all slabs, but for the surfaces in
 * time and the volumes at start and end of port 1, and those in side walls of the domain. Surfaces
 * in time are such faces, each once, never turned over as well; volumes and surfaces at start and
 * end are the outputs of vtkIntervalVolume at that step, of parts too that are in the interval at
 * that step only. The same input gives the same bytes whatever the number of threads.
 *
 * Pieces of a distributed grid: as in vtkIntervalVolume, with a layer of ghost cells at each step.
 *
 * Cells with NaN or infinity in the scalar or, with a warning, in a coordinate of a corner at one
 * of the two steps, ghost, hidden and blanked cells are left out of that slab and counted in
 * GetReport(). A slab of no duration (two steps of equal time) is left out with a warning.
 *
 * A source that writes each step into the memory of the one before is found out by that memory and
 * the time of its change (of the scalars by the memory alone); the execution then begins anew and
 * copies every step.
 *
 * Errors (vtkErrorMacro, empty output): fewer than two time steps, steps whose times decrease or
 * are not finite, a step without the scalar array or of another type of grid, number of points or
 * cells, or connectivity than the step before (the message names the step), and those of
 * vtkIntervalVolume. Warning (vtkWarningMacro, once for a composite input): empty outputs and why,
 * see WarnOnEmptyOutput, also when no output is asked for or all 4-simplices are flat; what
 * vtkIntervalVolume warns of for each dataset, except quadratic cells.
 *
 * The scalar is the active one on each output.
 *
 * @sa vtkIntervalVolume vtkSimplexTimeSlice vtkTimeWeightedTetrahedraMapper
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
   * The kinds and classes, as vtkTimeVaryingSettings has them.
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
   * The first and last time step taken, by index. A last step beyond the last one of the input
   * stands for that. Default 0, VTK_INT_MAX. Valid: 0 <= first < last.
   */
  vtkSetVector2Macro(TimeStepRange, int);
  vtkGetVector2Macro(TimeStepRange, int);
  ///@}

  ///@{
  /**
   * The direction (x,y,z,t) along which 4-simplices are projected, of any length but zero. Along
   * time, the default (0,0,0,1), the result is in space. Along any other direction d it is in the
   * space orthogonal to it, whose axes are those of x, y, z turned by the smallest rotation that
   * takes t to d (or to -d, where that is nearer); DeltaT is then the extent along d, in the length
   * of (x,y,z,t).
   */
  vtkSetVector4Macro(ProjectionDirection, double);
  vtkGetVector4Macro(ProjectionDirection, double);
  ///@}

  ///@{
  /**
   * Whether port 0 is made. Default on.
   */
  vtkSetMacro(GenerateTetrahedra, bool);
  vtkGetMacro(GenerateTetrahedra, bool);
  vtkBooleanMacro(GenerateTetrahedra, bool);
  ///@}

  ///@{
  /**
   * Whether port 2 carries the 4-simplices. Default off.
   */
  vtkSetMacro(GenerateSimplices, bool);
  vtkGetMacro(GenerateSimplices, bool);
  vtkBooleanMacro(GenerateSimplices, bool);
  ///@}

  ///@{
  /**
   * Whether port 1 carries the boundaries of a kind, or of all kinds. Default off. A kind that is
   * not in BoundaryKinds is an error.
   */
  void SetGenerateBoundary(int kind, bool on);
  bool GetGenerateBoundary(int kind) const;
  void GenerateBoundaryOn(int kind) { this->SetGenerateBoundary(kind, true); }
  void GenerateBoundaryOff(int kind) { this->SetGenerateBoundary(kind, false); }
  void SetGenerateBoundaries(bool on);
  vtkBooleanMacro(GenerateBoundaries, bool);
  ///@}

  /**
   * Returns the report of the last execution, summed over the slabs:
   * - TimeSteps, Slabs: time steps requested, and slabs between them that were not skipped
   * - CellsWithOutput: cells that give at least one simplex
   * - BlankedCells: cells skipped because they or a point are blanked, hidden or a ghost
   * - NonFiniteCells: cells skipped because a value or a coordinate is NaN or infinite
   * - UnsupportedCells: cells skipped because of their type
   * - ConcavePolyhedra: polyhedra whose parts overlap
   * - Simplices, FlatSimplices, InvertedSimplices: all 4-simplices, those without tetrahedra, and
   *   those with inverted tetrahedra
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkTimeVaryingIntervalVolume();
  ~vtkTimeVaryingIntervalVolume() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /// Takes one time step, requests the next, or fills the outputs. Sets the report so far.
  void TakeStep(vtkInformation*, vtkInformationVector**, vtkInformationVector*,
    interlume::TimeVaryingReport& report);

  /// Returns an error if times cannot be used.
  interlume::Error CheckTimes(const std::vector<double>& times) const;
  interlume::Error CheckDirection() const;
  int GetFirstStep() const;
  /// Returns the times of the steps in the range.
  std::vector<double> GetTimesTaken() const;
  /// Begins an execution, which copies steps if \a copiesSteps. Returns false, after an error,
  /// where parameters do not allow it.
  bool Begin(bool copiesSteps);
  /// Returns whether the last execution took all steps and filled its outputs.
  bool HasFilledOutputs() const { return this->IsFilled; }
  /// Returns why there is no output after all steps, or nothing.
  std::string ExplainEmpty(interlume::TimeVaryingRun& run);

private:
  vtkTimeVaryingIntervalVolume(const vtkTimeVaryingIntervalVolume&) = delete;
  void operator=(const vtkTimeVaryingIntervalVolume&) = delete;

  vtkNew<vtkInterlumeReport> Report;
  /// The times of the input's steps.
  std::vector<double> TimeSteps;
  /// The state that is kept from one time step to the next; null between executions.
  std::unique_ptr<interlume::TimeVaryingRun> Run;
  bool IsFilled = false;
  /// Whether an execution was begun anew because the input changed meanwhile.
  bool IsRestarted = false;
};

#endif
