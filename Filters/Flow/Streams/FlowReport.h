// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowReport_h
#define interlume_FlowReport_h

#include "Streams/SamplingReport.h"

#include "vtkFlowStatus.h"

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkInterlumeReport;

namespace interlume
{

struct AdvectionResult;

/**
 * @class   FlowReport
 * @brief   values that vtkImplicitFlowField reports
 *
 * Sums over all samples do not depend on the number of threads.
 */
struct FlowReport
{
  void CopyTo(vtkInterlumeReport* report) const;
  void Add(const FlowReport& other);
  /// Adds the result of one sample.
  void Add(const AdvectionResult& result);

  vtkIdType Samples = 0;
  /// Number of samples for each vtkFlowStatus.
  std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES> Statuses{};
  /// Number of samples that reached a surface, by TerminationId. CopyTo reports the ids as
  /// SurfaceIds.
  std::map<int, vtkIdType> SamplesBySurface;
  /// Number of samples whose streamlines left the field within ArrivalTolerance of a surface.
  vtkIdType ReachedWithinTolerance = 0;
  /// Numbers of accepted and rejected steps of the explicit method, and then of the Rosenbrock
  /// method.
  vtkIdType Steps = 0;
  vtkIdType RejectedSteps = 0;
  vtkIdType StiffSteps = 0;
  vtkIdType RejectedStiffSteps = 0;
  /// Number of steps, included in Steps, that were computed four at a time with SIMD instructions,
  /// on images and rectilinear grids. Their results are bit-identical to those of single steps.
  vtkIdType SimdSteps = 0;
  /// Number of samples with at least one Rosenbrock step.
  vtkIdType StiffSamples = 0;
  /// Number of samples that were interpolated from neighboring samples (InterpolateStreamlines),
  /// number of advected samples at which interpolation was checked and found accurate, and the
  /// largest and mean interpolation error there. The error is the distance between the end points
  /// or, if larger, the time difference multiplied by SpeedScale, in units of MaximumError times
  /// AdvectionTime.
  vtkIdType InterpolatedSamples = 0;
  vtkIdType InterpolationChecks = 0;
  double LargestInterpolationError = 0.0;
  double MeanInterpolationError = 0.0;
  /// Numbers of evaluations of the field, its Jacobian and surface distances.
  vtkIdType Evaluations = 0;
  vtkIdType JacobianEvaluations = 0;
  vtkIdType DistanceEvaluations = 0;
  /// Number of cells that streamlines entered.
  vtkIdType CellsVisited = 0;
  /// Number of input cells that are not part of the field because they have fewer than three
  /// dimensions.
  vtkIdType LowerDimensionalCells = 0;
  /// Numbers of refined (mixed) cells and of added samples for each level of refinement.
  std::vector<vtkIdType> RefinedCells;
  std::vector<vtkIdType> AddedSamples;
  /// Interpolation error between samples (SamplingChecks). The streamlines traced to measure it are
  /// not included in the other values of the report.
  SamplingReport Sampling;
  /// Number of executions that advected samples since the filter was created.
  vtkIdType Executions = 0;
  /// Largest speed at a point of the field, and number of points whose vectors look like fill
  /// values. Automatic settings ignore these points.
  double MaximumSpeed = 0.0;
  vtkIdType FillValues = 0;
  /// Number of faces of an unstructured grid whose neighbors an earlier execution of this or
  /// another filter found. 0 if this execution found the neighbors itself.
  vtkIdType ReusedFaceMatches = 0;
  /// Number of pairs of faces that match only within a tolerance, and the largest distance between
  /// matching corners of such faces, in cell widths.
  vtkIdType ToleranceMatchedFaces = 0;
  double LargestFaceGap = 0.0;
  /// Number of boundary faces that have a cell on the far side, but no matching face, and the cell
  /// of the first such face.
  vtkIdType NonconformingFaces = 0;
  vtkIdType FirstNonconformingCell = -1;
  /// Size in bytes of the vectors and averaged arrays that this process holds.
  vtkIdType FieldBytes = 0;
  /// Number of steps that each process took, including rejected steps and steps for samples of
  /// other processes, and total number of transfers of streamlines between processes. All processes
  /// report the same values. If each process holds the whole field, StepsPerProcess is empty and
  /// StreamlineTransfers is 0.
  std::vector<vtkIdType> StepsPerProcess;
  vtkIdType StreamlineTransfers = 0;
  /// Reason why every process holds the whole field instead of a partition. Empty if the field is
  /// partitioned or there is only one process.
  std::string WholeFieldReason;
  /// Number of streamlines that were read from a checkpoint, and number of checkpoints written. The
  /// other values in the report include the streamlines from the checkpoint.
  vtkIdType ResumedStreamlines = 0;
  vtkIdType Checkpoints = 0;
  /// Maximum error and minimum speed in use, including automatic values.
  double MaximumError = 0.0;
  double MinimumSpeed = 0.0;
  /// Component value that all fill values of the most frequent kind contain, or 0 if there is none,
  /// and the largest speed at points without fill values.
  double FillValue = 0.0;
  double SpeedScale = 0.0;
  /// Number of points of the field's cells with NaN or infinite vectors.
  vtkIdType NonFiniteVectors = 0;
  /// Names of the cell arrays that were averaged at the points.
  std::vector<std::string> ConvertedCellArrays;
};

}

#endif
