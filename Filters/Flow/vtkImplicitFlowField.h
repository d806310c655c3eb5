// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImplicitFlowField_h
#define vtkImplicitFlowField_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkFlowSettings.h"    // for what is set
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report
#include "vtkSmartPointer.h"    // for the surfaces

#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkMultiProcessController;
class vtkTerminationSurface;

namespace interlume
{
class Error;
class FieldInput;
class MeshLinks;
struct AdvectionOptions;
struct FlowReport;
}

/**
 * @class   vtkImplicitFlowField
 * @brief   every sample of a field advected to a termination surface: which, where and when
 *
 * From each sample the streamline dx/dt = -v(x) (backward) or v(x) (forward) is followed until it
 * reaches a termination surface (C. Zhang, dissertation, Ohio State 2006, section 4.4; J. J. van
 * Wijk, "Implicit stream surfaces", IEEE Visualization 1993). The surface, the place on it and the
 * time, (f,u,v,t), are kept, which is all that stream volumes, stream surfaces, time surfaces and
 * textured flow need: see vtkInflowMapping and vtkFlowVolume.
 *
 * Input port 0: the field. vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, or
 * vtkUnstructuredGrid of tetrahedra, voxels, hexahedra, wedges and pyramids; vectors in the points
 * (SetInputArrayToProcess(0,
 * ...), by default the active vectors), three components, any numbers. Between points they are
 * interpolated as in VTK's cells. Cells of fewer dimensions are not part of the field and are
 * counted; where there are no others, as in a plane, the error says how to make some. Ghost, hidden
 * and blanked cells are not part of the field, but for duplicates of pieces. Input port 1,
 * optional: the samples of SAMPLES_OF_INPUT.
 *
 * **Blocks.** Port 0 takes composite datasets too, as vtkMultiBlockDataSet, of any of these: one
 * field, streamlines going from block to block where faces have the same corners. Blocks are merged
 * for that to one vtkUnstructuredGrid, without hidden and duplicate cells; points in the same
 * place, to the last bit, become one, with the values of the first block. Every block needs the
 * vectors, by one name; other arrays are kept where all have them. Numbers of different types
 * become doubles. SAMPLES_OF_FIELD gives that grid. Where faces do not fit, as between levels of
 * AMR, the field ends.
 *
 * **Seams.** Faces of two cells that have the same corners within a thousandth of the cell's width
 * there, and what rounding of the coordinates may be, are one face: between blocks, and where a
 * grid is closed on itself and its last angle is not quite its first. The report has how many are
 * joined so, and by how much. A sample in such a gap is OUTSIDE.
 *
 * Output: the samples, with the point data of their dataset, and the arrays of vtkFlowStatus. By
 * request MaximumSpeed, ArcLength, MeanVorticity and Mean<name> along the path (double; 0 for
 * samples OUTSIDE). Where streamlines come round to a surface again, time jumps on it from 0 to
 * what that takes, within one id: TerminationSide tells. What samples beside a surface would have
 * on its other side is in field arrays (vtkFlowStatus::BeyondPrefix): two short streamlines and one
 * as long as a sample's for each of them, of which there are as many as cells that surfaces pass
 * through. If the field has obstacles (hidden cells or points, vectors that are not finite), the
 * boundary of what reaches a surface is located on the edges of the samples' cells, with six
 * streamlines for each edge; the same arrays have the result. The field array TerminationSurfaces
 * tells the ids and what is periodic. Where the samples are the field's own points or port 1's, the
 * output has their type (vtkUnstructuredGrid for composite data); an image of samples is
 * vtkImageData, so the type of the output follows SampleMode, and RefinementLevels.
 *
 * **Method.** A streamline is followed from cell to cell in the cell's own coordinates, where the
 * interpolated field is smooth: the kinks at faces are never within a step, and the method keeps
 * its order. A step that goes on beyond the face is cut there by its dense output. So is a step
 * that crosses a surface. Tests with the signed distance are made only when the streamline can have
 * gone as far.
 *
 * **Error.** Steps are controlled so that the local error is at most MaximumError times the step,
 * in world units per unit of time. What the field damps within a cell does not add up from step to
 * step; such a part of the error, in stiff fields, counts by what is left of it.
 *
 * **Sizes.** Fields, surfaces and samples may have any size from 1e-160 to 1e160, with any speeds
 * whose times through the field are from 1e-280 to 1e280: answers are those at size 1 but for
 * rounding. Beyond that, numbers underflow, and streamlines may end too early.
 *
 * **Pieces.** A sample needs all of the field that its streamline meets: of port 0 the whole is
 * asked for, whatever the piece; samples are those of the piece.
 *
 * **Processes.** Where each process of the controller is asked for its own piece, the field stays
 * in parts: each process asks for its piece, of rows of cells with a layer around it, and
 * streamlines go from process to process (VTK's DIY). Answers have the bytes that one process gives
 * them. All processes have to execute at once; an abort in one ends all. Each holds the whole
 * field, and the report says why, with CriticalPointSpheres, ShareStreamlines, or a surface that is
 * placed by the vectors; and where VTK has no DIY.
 *
 * Of an unstructured grid and of blocks the parts are the pieces that the source gives, without
 * duplicates of others' cells, and samples at its points are those of the piece. Blocks are merged
 * in each process; where several have a point, the first one's values count. One process is one
 * that has all pieces as one grid: cells in the order of the pieces, and points of several pieces
 * that have the same coordinates, to the last bit, once. The order matters where cells lie within
 * each other, for the numbers of patches (DomainFaces), and for the points that are added to
 * refined cells other than tetrahedra. Each process holds the whole where the source gives all
 * cells to one process, or the same ones to several, where blocks of processes differ in arrays,
 * and where faces do not fit between pieces, as of tetrahedra that a filter has made in each by
 * itself. This is seen once the pieces are there: the input executes for them, then for the whole,
 * and for that alone until it is modified.
 *
 * **Checkpoints.** With CheckpointFileName the streamlines that have ended are written to a file
 * while others are followed, and at an abort. An execution that finds the file follows the others
 * alone. It has the bytes of one that was never stopped, and the numbers of its report, but for
 * those of SIMD steps, checkpoints and processes; so it is with refinement, shared streamlines,
 * further quantities and what lies beyond surfaces. When all is there the file is removed. The
 * output is whole or, after an abort, empty, never partial; the file is a table of streamlines, and
 * has the field array PartialImplicitFlow. A file is replaced by renaming the next one, so that a
 * process that is killed in writing leaves the file before, and a file that ends in .part. The file
 * is used only if field, vectors, ghost marks, samples, surfaces (what they print of themselves,
 * meshes and lines), settings and the versions of Interlume and VTK are those of the execution.
 * Otherwise, or if it is damaged, a warning says what differs, all streamlines are followed anew,
 * and the file is replaced when the next is due; one that never was a checkpoint is left as it is,
 * and none is written. For this 124 bytes a streamline are held, and 8 for each mean. Where
 * processes hold the field in parts each writes its own file, and what one refuses all do.
 *
 * The output is the same for any number of threads. AdvectionTime is left as the active scalars.
 *
 * **Walls.** Where walls do not slip, samples on them stagnate at once, and streamlines that come
 * close get ever slower and stagnate by MinimumSpeed: 39 in a hundred samples of the flow past a
 * post on a plate, against the vectors. Closer to a wall than the error that is allowed a
 * streamline may also come to a surface beside it. A wall that is a termination surface is reached.
 *
 * Warnings (vtkWarningMacro), but not for pieces: the input has no points; no sample reached a
 * surface, with how many ended in which way; faces that have a cell beyond them without a face that
 * fits, with their number; vectors that look like fill values, with the value, their number
 * and the remedy; vectors that are NaN or infinite, with their number and the remedy. For pieces
 * too: a checkpoint that is refused, and one that cannot be written.
 *
 * Errors (vtkErrorMacro, empty output): no vectors of that name or not of three components; a
 * surface that vtkTerminationSurface::PlaceIn or Update finds wrong; no surface and no domain
 * faces; cells of other types, with the block where there are several; SAMPLES_OF_INPUT without an
 * input.
 *
 * @sa vtkTerminationSurface vtkFlowStatus
 */
class INTERLUMEFLOW_EXPORT vtkImplicitFlowField
  : public vtkDataSetAlgorithm
  , private vtkFlowSettings
{
public:
  static vtkImplicitFlowField* New();
  vtkTypeMacro(vtkImplicitFlowField, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surfaces that streamlines end on. Where a step crosses several, the first along the
   * streamline counts, of equal ones that added first. Default none. Null adds nothing.
   */
  void AddTerminationSurface(vtkTerminationSurface* surface);
  void RemoveTerminationSurface(vtkTerminationSurface* surface);
  void RemoveAllTerminationSurfaces();
  int GetNumberOfTerminationSurfaces() const { return static_cast<int>(this->Surfaces.size()); }
  vtkTerminationSurface* GetTerminationSurface(int i) const;
  ///@}

  ///@{
  /**
   * Whether the outer faces of the field are surfaces too, where streamlines leave the domain. For
   * an image, a rectilinear or a structured grid these are six, with the ids DomainFaceId + 0 ... 5
   * for -i, +i, -j, +j, -k, +k; (u,v) are the other two directions in parts of the grid's points.
   * For an unstructured grid, and for several blocks, they are the patches that edges sharper than
   * 30 degrees bound, with the ids DomainFaceId + 0, 1, ... by their first cell; (u,v) are the two
   * of x, y, z that the patch looks along less, in parts of its bounds. TerminationSurfaces has
   * their ids. Default off, 1000.
   */
  vtkSetMacro(DomainFaces, bool);
  vtkGetMacro(DomainFaces, bool);
  vtkBooleanMacro(DomainFaces, bool);
  vtkSetClampMacro(DomainFaceId, int, 0, 1000000000);
  vtkGetMacro(DomainFaceId, int);
  ///@}

  ///@{
  /**
   * Whether a sphere stands around each critical point of the field that streamlines of this
   * direction end in (vtkFlowCriticalPoints: sources for BACKWARD, sinks for FORWARD, saddles
   * never), with ids CriticalPointId + 0, 1, ...; CriticalPointRadius is in lengths of the cell
   * that the point lies in. Default off, 2000, 1. Valid: above 0 to 1000.
   */
  vtkSetMacro(CriticalPointSpheres, bool);
  vtkGetMacro(CriticalPointSpheres, bool);
  vtkBooleanMacro(CriticalPointSpheres, bool);
  vtkSetClampMacro(CriticalPointId, int, 0, 1000000000);
  vtkGetMacro(CriticalPointId, int);
  vtkSetClampMacro(CriticalPointRadius, double, 1e-6, 1000.0);
  vtkGetMacro(CriticalPointRadius, double);
  ///@}

  enum SampleModes
  {
    SAMPLES_OF_FIELD = 0,
    SAMPLES_OF_IMAGE = 1,
    SAMPLES_OF_INPUT = 2,
    SAMPLES_AUTOMATIC = 3
  };
  ///@{
  /**
   * Which points the samples are: the field's points, those of an image over SampleBounds, or the
   * points of port 1. SAMPLES_AUTOMATIC, for a first look in seconds: the field's points where
   * there are no more than 32768; else every n-th point along the directions of a rectilinear or
   * structured grid that have most, a coarser image for image data, the voxels of an image over the
   * bounds as vtkUnstructuredGrid for unstructured grids and composite data, so that fewer than
   * that are left. The type of the output is that of SAMPLES_OF_FIELD. Default SAMPLES_AUTOMATIC.
   */
  vtkSetClampMacro(SampleMode, int, SAMPLES_OF_FIELD, SAMPLES_AUTOMATIC);
  vtkGetMacro(SampleMode, int);
  ///@}

  ///@{
  /**
   * The number of points of the image along each axis, and its bounds in world units; empty bounds
   * (lower above upper): those of the field. Default 64, 64, 64; empty. Valid: 1 to 100000.
   */
  void SetSampleDimensions(int x, int y, int z);
  vtkGetVector3Macro(SampleDimensions, int);
  vtkSetVector6Macro(SampleBounds, double);
  vtkGetVector6Macro(SampleBounds, double);
  ///@}

  ///@{
  /**
   * The number of cells of samples in whose middles what is interpolated between the samples is
   * compared with a streamline from there, where the samples are made by the filter:
   * SAMPLES_OF_IMAGE, and SAMPLES_AUTOMATIC of a field with more points. The report has the errors
   * (SamplingErrorU and so on), and so have the field arrays SamplingChecks and SamplingErrors of
   * vtkFlowStatus. The cells are spread over all that have a corner in the field, always the same
   * ones. Cells that are refined are not compared. Default 1000. Valid: 0, for no comparison, to
   * 1000000.
   */
  vtkSetClampMacro(SamplingChecks, int, 0, 1000000);
  vtkGetMacro(SamplingChecks, int);
  ///@}

  /// Sets the dataset of the samples, on port 1, for SAMPLES_OF_INPUT.
  void SetSampleConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSampleData(vtkDataSet* data);

  using vtkFlowSettings::BACKWARD;
  using vtkFlowSettings::Directions;
  using vtkFlowSettings::FORWARD;
  ///@{
  /**
   * Whether streamlines are followed against the vectors or along them. Default BACKWARD. Valid:
   * see Directions; clamped.
   */
  vtkSetClampMacro(Direction, int, BACKWARD, FORWARD);
  vtkGetMacro(Direction, int);
  void SetDirectionToBackward() { this->SetDirection(BACKWARD); }
  void SetDirectionToForward() { this->SetDirection(FORWARD); }
  ///@}

  using vtkFlowSettings::AUTOMATIC;
  using vtkFlowSettings::DORMAND_PRINCE;
  using vtkFlowSettings::Integrators;
  using vtkFlowSettings::ROSENBROCK;
  using vtkFlowSettings::RUNGE_KUTTA_4;
  ///@{
  /**
   * The method of integration. DORMAND_PRINCE: order 5(4) with dense output of order 4.
   * RUNGE_KUTTA_4: the classical method, with the error by doubling the step (C. Zhang,
   * dissertation, Ohio State 2006). ROSENBROCK: RODAS, order 4(3), L-stable.
   * AUTOMATIC: Dormand and Prince's where the test of Hairer and Wanner finds no stiffness,
   * Rosenbrock's where it does. Default AUTOMATIC.
   */
  vtkSetClampMacro(Integrator, int, AUTOMATIC, ROSENBROCK);
  vtkGetMacro(Integrator, int);
  ///@}

  ///@{
  /**
   * The largest local error, in world units per unit of time. 0: a millionth of the field's
   * largest speed without fill values. These are much faster than all other points, and either at
   * most one point in a hundred, or at most half of the points with the same number in their
   * largest components (1e20, -9999). A number of at least 1e10 may be at nearly all points.
   * Default 0. Valid: 0 and above.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * The time, and the number of steps, rejected ones too, after which a streamline ends. Closed
   * orbits are found before (vtkFlowStatus::CLOSED_ORBIT), once they cannot come to a surface with
   * the steps that are left, but not those within one cell of the field, nor those that the time
   * ends first. Default 0 and 0: no limit of time, and automatic, 2000 steps or 20 times the cube
   * root of the number of the field's cells, whichever is more. That is too few only where the
   * field is stiff, for an explicit method, or for errors of a billionth of the speed. Valid: 0 and
   * above; 0 to 1000000000.
   */
  vtkSetClampMacro(MaximumTime, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumTime, double);
  vtkSetClampMacro(MaximumNumberOfSteps, int, 0, 1000000000);
  vtkGetMacro(MaximumNumberOfSteps, int);
  ///@}

  ///@{
  /**
   * The speed below which a streamline ends, in world units per unit of time. 0: 1e-9 of the
   * field's largest speed that is no fill value. Default 0. Valid: 0 and above.
   */
  vtkSetClampMacro(MinimumSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSpeed, double);
  ///@}

  ///@{
  /**
   * How near to a surface a streamline has reached it that ends where the field ends, because it
   * leaves or stagnates there, or is on the outer faces of cells to begin with: in widths of the
   * cell there, the narrow side of its face or its height. How far the face is from flat is added
   * (a mesh of the field's own faces has triangles where those are bilinear), and so is what
   * rounding of coordinates that are floats may be; a surface across the face has less. Without it
   * rounding decides whether a surface on the skin of the field is met. 0: only what is met.
   * Default 0.01. Valid: 0 to 1.
   */
  vtkSetClampMacro(ArrivalTolerance, double, 0.0, 1.0);
  vtkGetMacro(ArrivalTolerance, double);
  ///@}

  ///@{
  /**
   * The further quantities that are kept of a path: its largest speed (MaximumSpeed), its length
   * (ArcLength), the mean over time of the vorticity's magnitude (MeanVorticity), and the mean over
   * time of any point array of the field with one component (Mean and its name). Default off, none.
   */
  vtkSetMacro(ComputeMaximumSpeed, bool);
  vtkGetMacro(ComputeMaximumSpeed, bool);
  vtkBooleanMacro(ComputeMaximumSpeed, bool);
  vtkSetMacro(ComputeArcLength, bool);
  vtkGetMacro(ComputeArcLength, bool);
  vtkBooleanMacro(ComputeArcLength, bool);
  vtkSetMacro(ComputeMeanVorticity, bool);
  vtkGetMacro(ComputeMeanVorticity, bool);
  vtkBooleanMacro(ComputeMeanVorticity, bool);
  void AddMeanArray(const char* name);
  void RemoveAllMeanArrays();
  int GetNumberOfMeanArrays() const { return static_cast<int>(this->MeanArrays.size()); }
  const char* GetMeanArrayName(int i) const;
  ///@}

  ///@{
  /**
   * How often cells of the samples whose corners differ in FlowStatus or TerminationId, or that lie
   * across their surface with a jump in time (as vtkFlowVolume has it), are refined with new
   * samples, but for those that vtkFlowVolume cuts at their surface: all their edges are halved,
   * and cells beside them are cut so that faces fit. Only new samples are advected. What is between
   * surfaces gets half as thick with each level, and the new samples of a level are two to four
   * times those of the level before. Point arrays of the samples are interpolated, cell arrays
   * copied; hidden cells, polyhedra, quadratic cells, and those of fewer dimensions stay. Above 0
   * the output is vtkUnstructuredGrid, of voxels, hexahedra, wedges, pyramids and tetrahedra.
   * Default 0. Valid: 0 to 6.
   *
   * Pieces of the samples are refined each for itself: at their borders cells do not fit, unless
   * the samples have a layer of ghost cells for each level.
   */
  vtkSetClampMacro(RefinementLevels, int, 0, 6);
  vtkGetMacro(RefinementLevels, int);
  ///@}

  ///@{
  /**
   * Whether samples of an image, a rectilinear or a structured grid may take the answers of those
   * around them, by interpolation of (u,v) and the time, instead of being advected. That is done
   * in blocks in whose middle a streamline shows it to be off by no more than MaximumError allows
   * for the time there, if at the block's corners, from samples twice as far apart, it is off by no
   * more than four times that; never where samples that are interpolated from differ in FlowStatus
   * or TerminationId, lie across a seam, or what is interpolated is not on the surface. Samples are
   * to be dense for the tolerance: interpolated fields have second derivatives that jump between
   * cells, so that at the default MaximumError hardly any are shared that are as far apart as the
   * field's points, and nothing is gained. Thin layers between samples at which streamlines part
   * may be missed. Errors are those of the interpolation on top of those of advection; the report
   * has them. Samples that are refined are advected; so are all where further quantities of paths
   * are kept. Default off.
   */
  vtkSetMacro(ShareStreamlines, bool);
  vtkGetMacro(ShareStreamlines, bool);
  vtkBooleanMacro(ShareStreamlines, bool);
  ///@}

  ///@{
  /**
   * Whether the numbers of all steps and of Rosenbrock's steps of each sample are kept, in the
   * point arrays AdvectionSteps, StiffSteps (int). Default off.
   */
  vtkSetMacro(KeepSteps, bool);
  vtkGetMacro(KeepSteps, bool);
  vtkBooleanMacro(KeepSteps, bool);
  ///@}

  ///@{
  /**
   * The file that finished streamlines are kept in, so that an execution that was aborted or killed
   * is resumed by the next one, in this or another process: see **Checkpoints**. The extension is
   * that of a vtkTable in VTK's XML format, vtt; with several pieces _0, _1, ... stand before it.
   * Null or empty: there is none, nothing is written and nothing kept for it. Default null.
   */
  void SetCheckpointFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetCheckpointFileName() const;
  ///@}

  ///@{
  /**
   * The least number of seconds between two writings of that file, or ten times what the last took
   * where that is more. 0: after every part of the streamlines, of about a second. After an abort
   * it is always written. Default 60. Valid: 0 and above.
   */
  vtkSetClampMacro(CheckpointInterval, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CheckpointInterval, double);
  ///@}

  ///@{
  /**
   * The processes that hold a field in parts together. Default: the global controller at the time
   * of construction; null: none.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /// Returns the time of the last change, of the surfaces too.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The surfaces of the last execution in the order in which they count, and the TerminationId of
   * the first part of each, automatic ones too. Spheres around critical points are among them, the
   * faces of the domain are not. Null and -1 beyond them.
   */
  int GetNumberOfUsedSurfaces() const { return static_cast<int>(this->UsedSurfaces.size()); }
  vtkTerminationSurface* GetUsedSurface(int i) const;
  int GetUsedSurfaceId(int i) const;
  ///@}

  /**
   * Returns what the last execution did:
   * - Samples: samples that were advected,
   * - Statuses: samples by vtkFlowStatus,
   * - SurfaceIds, SamplesBySurface: TerminationIds that were reached, and the samples of each,
   * - SamplingErrorU, SamplingErrorV, SamplingErrorTime: interpolation error between samples, if
   *   SamplingChecks compared it: the mean, the 99th percentile and the largest,
   * - MaximumError, MinimumSpeed: the values in use, also if the settings are automatic,
   * - WholeFieldReason: the reason why each of several processes holds the whole field, if so.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkImplicitFlowField();
  ~vtkImplicitFlowField() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkImplicitFlowField(const vtkImplicitFlowField&) = delete;
  void operator=(const vtkImplicitFlowField&) = delete;

  /// Returns an error if a block of composite input cannot be used.
  interlume::Error CheckBlocks(const interlume::FieldInput& input);
  /// Makes a dataset of the type that samples have before they are refined.
  vtkSmartPointer<vtkDataSet> MakeSamples(vtkInformationVector** inputs) const;
  /// Returns whether the field stays in parts that processes hold. Sets \a error if several
  /// processes cannot hold parts.
  bool IsInParts(
    vtkInformationVector** inputs, vtkInformationVector* outputs, interlume::Error& error) const;
  ///@{
  /// Only the parts may show that the field cannot be in parts. Then the pipeline requests the
  /// whole field and executes again (AskForWhole), and does so at once as long as the input is not
  /// modified (IsPartitionErrorKnown). IsAskedForWhole returns whether this process has to request
  /// the whole field since another process has it. Otherwise sets \a error if this process has the
  /// whole field. Collective except for the second execution.
  bool IsPartitionErrorKnown();
  vtkMTimeType GetInputTime();
  bool IsAskedForWhole(vtkInformation* request, interlume::Error& error);
  void AskForWhole(vtkInformation* request, const interlume::Error& error);
  ///@}
  /// What an execution is given, and what its steps find. Defined where it is used.
  struct Execution;
  /// How a step ended; only after COMPLETE the next one follows. NEEDS_WHOLE: streamlines need
  /// the whole field instead of parts. EMPTY: there is nothing to follow.
  enum class Outcome
  {
    COMPLETE,
    EMPTY,
    NEEDS_WHOLE,
    FAILED,
    ABORTED
  };
  ///@{
  /// The steps of an execution, in their order. Finish cleans up after any outcome, and returns
  /// what RequestData is to return.
  Outcome CheckInput(Execution& execution);
  Outcome FindField(Execution& execution);
  Outcome PrepareSamples(Execution& execution);
  Outcome FollowSamples(Execution& execution);
  int Finish(Execution& execution, Outcome outcome);
  ///@}
  /// Gives the samples their geometry and point data. Returns an error if there are no samples.
  interlume::Error SetSamples(Execution& execution);
  void SetImageSamples(Execution& execution);
  /// Cuts the whole field down to the piece that is asked for. \a whole is the whole extent, where
  /// \a output is not the whole.
  void CutPiece(vtkInformation* info, const int* whole, vtkDataSet* output) const;
  /// Computes the part of a whole extent that is asked for; the piece's part where cells are
  /// refined.
  void GetExtent(vtkInformation* info, const int whole[6], int extent[6]) const;
  /// Places the surfaces in the field. Returns an error if a surface cannot be used.
  interlume::Error PlaceSurfaces(Execution& execution);
  /// Makes the checkpoint and reads its file, if there is one.
  void OpenCheckpoint(Execution& execution);
  /// Warns of fill values, of vectors that are not finite and of open interfaces. \a vectors is the
  /// name of the vectors.
  void WarnOfField(const interlume::FlowReport& report, const char* vectors);
  void WarnIfNoneReached(const interlume::FlowReport& report);
  void AddSpheres(vtkDataSet* field, interlume::AdvectionOptions& options);
  /// Adds a surface to the options, and keeps it as long as they last.
  void UseSurface(vtkTerminationSurface* surface, int id, interlume::AdvectionOptions& options);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::vector<vtkSmartPointer<vtkTerminationSurface>> Surfaces;
  std::vector<std::pair<vtkSmartPointer<vtkTerminationSurface>, int>> UsedSurfaces;
  bool CriticalPointSpheres = false;
  int CriticalPointId = 2000;
  double CriticalPointRadius = 1.0;
  int SampleMode = SAMPLES_AUTOMATIC;
  int SampleDimensions[3] = { 64, 64, 64 };
  double SampleBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  std::string CheckpointFileName;
  double CheckpointInterval = 60.0;
  vtkNew<vtkInterlumeReport> Report;
  vtkIdType Executions = 0;
  /// Message of the error for which the field could not be in parts, the time when the input was
  /// modified then, and whether the whole is requested after the parts.
  std::string PartitionError;
  vtkMTimeType PartitionErrorTime = 0;
  bool IsAskingAgain = false;
  /// What was found of the last field's mesh, for the next execution.
  std::shared_ptr<const interlume::MeshLinks> Mesh;
};

#endif
