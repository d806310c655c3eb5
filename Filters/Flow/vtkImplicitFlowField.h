// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImplicitFlowField_h
#define vtkImplicitFlowField_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeDeprecation.h"
#include "vtkDataSetAlgorithm.h"
#include "vtkFlowSettings.h"    // for the settings
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
 * @brief   advect every sample of a vector field to a termination surface
 *
 * The filter follows the streamline through each sample, backward or forward, until it reaches a
 * termination surface. It stores the surface id f, the position (u,v) on the surface and the
 * advection time t in the arrays of vtkFlowStatus. vtkInflowMapping and vtkFlowVolume then extract
 * stream volumes, stream surfaces and time surfaces without further advection.
 * Documentation/methods/implicit-flow.md explains the method, error control, parallel execution and
 * limits. See Documentation/measurements.md for measured times.
 *
 * Input port 0: the field, as vtkImageData, vtkRectilinearGrid, vtkStructuredGrid,
 * vtkUnstructuredGrid of tetrahedra, voxels, hexahedra, wedges and pyramids, or a composite dataset
 * of these. The vectors are an array with three components: SetInputArrayToProcess(0, ...), by
 * default the active vectors. Cell vectors are averaged at the points of each dataset, see
 * vtkIntervalAlgorithm. Vectors are interpolated in cells as in VTK. Lower-dimensional cells are
 * skipped and counted. Ghost, hidden and blanked cells are not part of the field, except ghost
 * cells that duplicate cells of other pieces. Optional input port 1: the samples of
 * SAMPLES_OF_INPUT.
 *
 * The blocks of composite input are merged into one field and must have the vectors under the same
 * name. Streamlines cross block boundaries where faces have the same points. The field ends at
 * nonconforming faces, for example between AMR levels.
 *
 * Output: the samples with their point data and the arrays of vtkFlowStatus. Optional point arrays
 * (double; 0 for samples OUTSIDE): MaximumSpeed, ArcLength, MeanVorticity, Mean<name>, LocalSpeed,
 * LocalVorticity. Field array TerminationSurfaces: the ids in use and their periodic directions.
 * Field arrays with the prefix vtkFlowStatus::FarSidePrefix: far-side values of samples near a
 * surface. AdvectionTime becomes the active scalars. The output type is that of the field or of
 * port 1 (vtkUnstructuredGrid for composite data), vtkImageData for SAMPLES_OF_IMAGE, and
 * vtkUnstructuredGrid with UnstructuredOutput or RefinementLevels.
 *
 * Notes:
 * - On a surface to which streamlines return, AdvectionTime jumps: it is 0 on one side.
 *   TerminationSide marks the sides.
 * - On no-slip walls samples stagnate, and streamlines close to such walls stagnate when their
 *   speed falls below MinimumSpeed. Make the wall a termination surface to get values there.
 * - The filter requests all of port 0 for any output piece, because streamlines may visit all of
 *   it. If each process requests its own piece, the field stays distributed unless it has to be
 *   averaged at the points, and streamlines move between processes (VTK's DIY). Then all processes
 * must execute together, and an abort in one process aborts all processes.
 * - The output is identical for any number of threads and processes.
 * - With CheckpointFileName, an aborted or killed execution resumes from its finished streamlines.
 *
 * Warnings (vtkWarningMacro, not if one of several pieces is requested): no points; no sample
 * reached a surface; nonconforming faces; vectors that look like fill values, or are NaN or
 * infinite. Also for single pieces: a checkpoint that cannot be used or written.
 *
 * Errors (vtkErrorMacro, empty output): missing vectors, or vectors without three components; a
 * surface rejected by vtkTerminationSurface::InitializeFromField or Update; neither surfaces nor
 * domain faces nor critical-point spheres; unsupported cells; SAMPLES_OF_INPUT without an input.
 *
 * @sa vtkTerminationSurface vtkFlowStatus vtkInflowMapping vtkFlowVolume
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
   * Add, remove or get the surfaces on which streamlines end. If a step crosses several surfaces,
   * the streamline ends on the first one; at equal positions, the surface added first takes
   * precedence. Default: none. A null surface is ignored. GetTerminationSurface returns null for an
   * invalid index.
   */
  void AddTerminationSurface(vtkTerminationSurface* surface);
  void RemoveTerminationSurface(vtkTerminationSurface* surface);
  void RemoveAllTerminationSurfaces();
  int GetNumberOfTerminationSurfaces() const { return static_cast<int>(this->Surfaces.size()); }
  vtkTerminationSurface* GetTerminationSurface(int i) const;
  ///@}

  ///@{
  /**
   * If true, the outer faces of the field are termination surfaces too. On an image, a rectilinear
   * or a structured grid, the faces have the ids DomainFaceId + 0 ... 5 for -i, +i, -j, +j, -k, +k.
   * Their (u,v) are the other two grid directions, as fractions of the grid. An unstructured grid
   * or composite input has one surface per boundary patch. Patches are bounded by edges sharper
   * than 30 degrees and numbered DomainFaceId + 0, 1, ... by their first cell. Their (u,v) are the
   * two axes least aligned with the patch normal, as fractions of the patch's bounds. The field
   * array TerminationSurfaces lists the ids. Default: off, 1000. Valid ids: 0 to 1000000000;
   * clamped.
   */
  vtkSetMacro(DomainFaces, bool);
  vtkGetMacro(DomainFaces, bool);
  vtkBooleanMacro(DomainFaces, bool);
  vtkSetClampMacro(DomainFaceId, int, 0, 1000000000);
  vtkGetMacro(DomainFaceId, int);
  ///@}

  ///@{
  /**
   * If true, add a sphere around each critical point where streamlines of the current Direction
   * end: sources for BACKWARD, sinks for FORWARD, never saddles (see vtkFlowCriticalPoints). The
   * ids are CriticalPointId + 0, 1, ...; CriticalPointRadius is in units of the size of the cell
   * that contains the point. Default: off, 2000, 1. Valid: ids from 0 to 1000000000, radius from
   * 1e-6 to 1000; clamped.
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
   * Set the samples: the points of the field, of an image over SampleBounds, or of port 1.
   * SAMPLES_AUTOMATIC is a fast preview. It uses the points of the field if there are at most
   * 32768, otherwise fewer points: every n-th point of a rectilinear or structured grid, a coarser
   * image for image data, or voxels over the bounds of unstructured and composite data. The output
   * type is the same as for SAMPLES_OF_FIELD. Default: SAMPLES_AUTOMATIC. Valid: see SampleModes;
   * clamped.
   */
  vtkSetClampMacro(SampleMode, int, SAMPLES_OF_FIELD, SAMPLES_AUTOMATIC);
  vtkGetMacro(SampleMode, int);
  ///@}

  ///@{
  /**
   * Dimensions (number of points along each axis) of the sample image for SAMPLES_OF_IMAGE, and its
   * bounds in world units. Empty bounds (lower above upper) select the bounds of the field.
   * Default: 64, 64, 64; empty. Valid dimensions: 1 to 100000; clamped.
   */
  void SetSampleDimensions(int x, int y, int z);
  vtkGetVector3Macro(SampleDimensions, int);
  vtkSetVector6Macro(SampleBounds, double);
  vtkGetVector6Macro(SampleBounds, double);
  ///@}

  ///@{
  /**
   * Number of sample cells at whose centers the filter compares interpolation between the samples
   * with a streamline. This applies to samples that the filter creates: SAMPLES_OF_IMAGE, and
   * SAMPLES_AUTOMATIC if the field has more than 32768 points. The errors are in the report
   * (SamplingErrorU and so on) and in the field arrays SamplingChecks and SamplingErrors of
   * vtkFlowStatus. The cells are spread over all cells with a corner in the field and are the same
   * in each execution. RefinementLevels above 0 turns the comparison off. Default: 1000. Valid: 0
   * (no comparison) to 1000000; clamped.
   */
  vtkSetClampMacro(SamplingChecks, int, 0, 1000000);
  vtkGetMacro(SamplingChecks, int);
  ///@}

  /// Set the dataset of the samples for SAMPLES_OF_INPUT, on port 1.
  void SetSampleConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSampleData(vtkDataSet* data);

  using vtkFlowSettings::BACKWARD;
  using vtkFlowSettings::Directions;
  using vtkFlowSettings::FORWARD;
  ///@{
  /**
   * Follow streamlines against the vectors or along them. Default: BACKWARD. Valid: see Directions;
   * clamped.
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
   * Integration method. DORMAND_PRINCE: order 5(4), dense output of order 4. RUNGE_KUTTA_4: the
   * classical method, with the error estimated by step doubling. ROSENBROCK: RODAS, order 4(3),
   * L-stable. AUTOMATIC: Dormand-Prince, and Rosenbrock where the test of Hairer and Wanner detects
   * stiffness. Default: AUTOMATIC. Valid: see Integrators; clamped.
   */
  vtkSetClampMacro(Integrator, int, AUTOMATIC, ROSENBROCK);
  vtkGetMacro(Integrator, int);
  ///@}

  ///@{
  /**
   * Maximum local error, in world units per unit of time. 0 selects 1e-6 times the largest speed of
   * the field, ignoring fill values. Fill values are vectors much faster than all others, at up to
   * 1 % of the points, or at up to half of the points if their largest components are the same
   * number (1e20, -9999). If that number is at least 1e10, fill values may be at nearly all points.
   * Default: 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * Maximum advection time, and maximum number of steps per streamline, including rejected ones.
   * Streamlines on closed orbits end earlier, with vtkFlowStatus::CLOSED_ORBIT, except on orbits
   * within one cell of the field. For the time, 0 means no limit. For the steps, 0 selects 2000, or
   * 20 times the cube root of the field's number of cells if that is more. More steps are needed
   * only with an explicit method in a stiff field, or with a very small MaximumError. Default: 0,
   * 0. Valid: 0 and above; 0 to 1000000000; clamped.
   */
  vtkSetClampMacro(MaximumTime, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumTime, double);
  vtkSetClampMacro(MaximumNumberOfSteps, int, 0, 1000000000);
  vtkGetMacro(MaximumNumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Speed below which a streamline ends, in world units per unit of time. 0 selects 1e-9 times the
   * largest speed of the field, ignoring fill values. Default: 0. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(MinimumSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSpeed, double);
  ///@}

  ///@{
  /**
   * Distance within which a streamline that ends at the boundary of the field counts as having
   * reached a surface, in units of the cell width there. Without a tolerance, rounding would decide
   * whether streamlines reach a surface on the boundary of the field. The deviation of the boundary
   * face from a plane and the rounding error of single-precision coordinates are added to it. It is
   * reduced for surfaces that cross the face. 0: streamlines must cross the surface. Default: 0.01.
   * Valid: 0 to 1; clamped.
   */
  vtkSetClampMacro(ArrivalTolerance, double, 0.0, 1.0);
  vtkGetMacro(ArrivalTolerance, double);
  ///@}

  ///@{
  /**
   * Optional quantities along the path: the largest speed (MaximumSpeed), the length (ArcLength),
   * the time average of the vorticity magnitude (MeanVorticity), and time averages of one-component
   * arrays of the field (Mean and the array's name). Arrays are point arrays, or cell arrays if no
   * point array has the name. ComputeLocalAttributes stores the speed and the vorticity magnitude
   * at the sample, in the cell of the field that contains it (LocalSpeed, LocalVorticity). They can
   * be too small where the cell is collapsed, such as at the pole of a spherical grid. Default:
   * off, none.
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
  vtkSetMacro(ComputeLocalAttributes, bool);
  vtkGetMacro(ComputeLocalAttributes, bool);
  vtkBooleanMacro(ComputeLocalAttributes, bool);
  void AddMeanArray(const char* name);
  void RemoveAllMeanArrays();
  int GetNumberOfMeanArrays() const { return static_cast<int>(this->MeanArrays.size()); }
  const char* GetMeanArrayName(int i) const;
  ///@}

  enum Refinements
  {
    CUT_BOUNDARY = -1
  };
  ///@{
  /**
   * Number of refinement levels for sample cells that cannot be interpolated: their corners differ
   * in FlowStatus or TerminationId, or time jumps within them. Cells that vtkFlowVolume cuts at a
   * surface are not refined. Each level bisects all edges of such cells and cuts their neighbors so
   * that faces conform. Only new samples are advected. Each level halves the thickness of the
   * unresolved layer and adds two to four times as many samples as the level before. Point arrays
   * of the samples are interpolated, cell arrays copied. Hidden cells, polyhedra, quadratic and
   * lower-dimensional cells remain unchanged. Above 0 the output is a vtkUnstructuredGrid. Default:
   * 0. Valid: CUT_BOUNDARY (-1) to 6; clamped.
   *
   * CUT_BOUNDARY refines nothing. Instead, the boundary of the region whose streamlines reach a
   * surface is located by bisection, as behind hidden cells, and vtkFlowVolume cuts cells there.
   * The output type is the same as for 0.
   *
   * Each piece of the samples is refined, and its boundary located, separately. Cells do not
   * conform at piece boundaries unless the samples have one layer of ghost cells per level.
   */
  vtkSetClampMacro(RefinementLevels, int, CUT_BOUNDARY, 6);
  vtkGetMacro(RefinementLevels, int);
  ///@}

  ///@{
  /**
   * If true, the output is a vtkUnstructuredGrid for any input, with the same samples, cells and
   * arrays. Points and cells of structured samples are then stored. Default: off.
   */
  vtkSetMacro(UnstructuredOutput, bool);
  vtkGetMacro(UnstructuredOutput, bool);
  vtkBooleanMacro(UnstructuredOutput, bool);
  ///@}

  ///@{
  /**
   * If true, samples on an image, a rectilinear or a structured grid may be interpolated from
   * surrounding samples, where comparison with a streamline shows that MaximumError holds. Samples
   * are never interpolated between different FlowStatus or TerminationId values, across a seam, or
   * where the interpolated end is not on the surface. This pays off only if samples are much denser
   * than the field's points or MaximumError is large. It may miss thin layers between samples at
   * which streamlines separate. The interpolation error adds to the advection error; the report
   * contains it. Samples added by refinement are always advected; with optional quantities of the
   * path, all samples are. Default: off.
   */
  vtkSetMacro(InterpolateStreamlines, bool);
  vtkGetMacro(InterpolateStreamlines, bool);
  vtkBooleanMacro(InterpolateStreamlines, bool);
  interlumeDeprecatedBooleanMacro(ShareStreamlines, InterpolateStreamlines);
  ///@}

  ///@{
  /**
   * If true, store the number of steps and of Rosenbrock steps of each sample in the point arrays
   * AdvectionSteps and StiffSteps (int). Default: off.
   */
  vtkSetMacro(StoreStepCounts, bool);
  vtkGetMacro(StoreStepCounts, bool);
  vtkBooleanMacro(StoreStepCounts, bool);
  interlumeDeprecatedBooleanMacro(KeepSteps, StoreStepCounts);
  ///@}

  ///@{
  /**
   * File of finished streamlines. After an aborted or killed execution, the next one, in this or
   * another process, resumes from this file. It is a vtkTable in VTK's XML format (vtt). With
   * several pieces, the piece number (_0, _1, ...) precedes the extension. The file is used only if
   * field, surfaces, samples, settings and the versions of Interlume and VTK are the same.
   * Otherwise a warning names the difference, and the file is replaced. A file that is not a
   * checkpoint is never overwritten. A complete execution removes the file. Null or empty: no
   * checkpoints. Default: null.
   */
  void SetCheckpointFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetCheckpointFileName() const;
  ///@}

  ///@{
  /**
   * Minimum time between two writes of the checkpoint, in seconds, or ten times the duration of the
   * last write, if that is longer. 0: write after each batch of streamlines, about once a second.
   * An abort always writes. Default: 60. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(CheckpointInterval, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CheckpointInterval, double);
  ///@}

  ///@{
  /**
   * Controller of the processes that together hold a distributed field. Default: the global
   * controller at construction. Null: this process only.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /// Return the modification time of the filter and its surfaces.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Return the surfaces of the last execution in order of precedence, and the TerminationId of
   * their first part, including automatic ids. Spheres around critical points are included, domain
   * faces are not. For an invalid index the results are null and -1.
   */
  int GetNumberOfUsedSurfaces() const { return static_cast<int>(this->UsedSurfaces.size()); }
  vtkTerminationSurface* GetUsedSurface(int i) const;
  int GetUsedSurfaceId(int i) const;
  ///@}

  /**
   * Return the report of the last execution:
   * - Samples: samples that were advected,
   * - Statuses: number of samples per vtkFlowStatus value,
   * - InitialStatuses: the same without samples that refinement added,
   * - SurfaceIds, SamplesBySurface: TerminationIds reached, and the number of samples of each,
   * - SamplingErrorU, SamplingErrorV, SamplingErrorTime: interpolation error between samples
   *   (SamplingChecks): mean, 99th percentile, largest,
   * - MaximumError, MinimumSpeed: values in use, with automatic values resolved,
   * - WholeFieldReason: reason why every process holds the whole field; empty if the field is
   *   distributed or there is only one process,
   * - ConvertedCellArrays: names of the cell arrays that were averaged at the points.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * Return a sentence about the last execution: the percentages of samples that reached a surface,
   * left the field, stagnated, or ended otherwise. Empty before the first execution. The text is
   * valid until the next call.
   */
  const char* GetSummary();

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
  bool IsOutputUnstructured() const
  {
    return this->UnstructuredOutput || this->RefinementLevels > 0;
  }
  /// Creates an empty dataset of the type that samples have before refinement.
  vtkSmartPointer<vtkDataSet> MakeSamples(vtkInformationVector** inputs) const;
  /// Returns true if the field is distributed over the processes. If not, and there are several
  /// processes, sets \a error to the reason.
  bool IsDistributed(
    vtkInformationVector** inputs, vtkInformationVector* outputs, interlume::Error& error);
  ///@{
  /// Sometimes only the partitions themselves show that the field cannot be distributed. Then the
  /// pipeline requests the whole field and executes again (RequestWholeField). Until the input is
  /// modified, later updates request the whole field immediately (IsPartitionErrorKnown).
  /// MustRequestWholeField returns true if this process must request the whole field because
  /// another process already did, or if \a error is not empty in any process. Otherwise, if this
  /// process holds the whole field, it sets \a error to the reason. The call is collective, except
  /// in the second execution.
  bool IsPartitionErrorKnown();
  vtkMTimeType GetInputTime();
  bool MustRequestWholeField(vtkInformation* request, interlume::Error& error);
  void RequestWholeField(vtkInformation* request, const interlume::Error& error);
  ///@}
  /// Inputs of an execution, and the results of its steps. Defined in the source file.
  struct Execution;
  /// Outcome of a step. The next step follows only after COMPLETE. NEEDS_WHOLE_FIELD: the field
  /// cannot be distributed. EMPTY: there is nothing to advect in this execution.
  enum class Outcome
  {
    COMPLETE,
    EMPTY,
    NEEDS_WHOLE_FIELD,
    FAILED,
    ABORTED
  };
  ///@{
  /// Steps of an execution, in order. Finish cleans up after any outcome and returns the result of
  /// RequestData.
  Outcome CheckInput(Execution& execution);
  Outcome FindField(Execution& execution);
  Outcome PrepareSamples(Execution& execution);
  Outcome FollowSamples(Execution& execution);
  int Finish(Execution& execution, Outcome outcome);
  ///@}
  /// Sets the geometry and the point data of the samples. Returns an error if they cannot be used.
  interlume::Error SetSamples(Execution& execution);
  void SetImageSamples(Execution& execution);
  /// Reduces the samples to the requested piece. \a whole is the whole extent if \a output has only
  /// a part of it, otherwise null.
  void CutPiece(vtkInformation* info, const int* whole, vtkDataSet* output) const;
  /// Computes the requested part of a whole extent: the update extent or, with refinement, the part
  /// that belongs to the requested piece.
  void GetExtent(vtkInformation* info, const int whole[6], int extent[6]) const;
  /// Initializes the surfaces from the field, and assigns automatic ids. Returns an error if a
  /// surface cannot be used.
  interlume::Error PlaceSurfaces(Execution& execution);
  /// Creates the checkpoint, and reads its file if it exists.
  void OpenCheckpoint(Execution& execution);
  /// Warns about fill values, non-finite vectors and nonconforming faces. \a vectors is the name of
  /// the vector array.
  void WarnOfField(const interlume::FlowReport& report, const char* vectors);
  void WarnIfNoneReached(const interlume::FlowReport& report);
  void AddSpheres(vtkDataSet* field, interlume::AdvectionOptions& options);
  /// Adds a surface to the options and retains it for GetUsedSurface.
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
  bool UnstructuredOutput = false;
  std::string CheckpointFileName;
  double CheckpointInterval = 60.0;
  vtkNew<vtkInterlumeReport> Report;
  std::string Summary;
  vtkIdType Executions = 0;
  /// Reason why the field could not be distributed, the input's modification time in that
  /// execution, and a flag that is true while the pipeline executes again for the whole field.
  std::string PartitionError;
  vtkMTimeType PartitionErrorTime = 0;
  bool IsRequestingWholeField = false;
  /// Mesh topology of the last field, cached for the next execution.
  std::shared_ptr<const interlume::MeshLinks> Mesh;
};

#endif
