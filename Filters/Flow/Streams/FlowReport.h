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
 * @brief   holds the values of the report of vtkImplicitFlowField
 *
 * Sums over all samples are the same for any number of threads.
 */
struct FlowReport
{
  void CopyTo(vtkInterlumeReport* report) const;
  void Add(const FlowReport& other);
  /// Adds the result of one sample.
  void Add(const AdvectionResult& result);

  vtkIdType Samples = 0;
  /// The number of samples for each vtkFlowStatus.
  std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES> Statuses{};
  /// The number of samples that reached a surface, by TerminationId. The report has the ids as
  /// SurfaceIds.
  std::map<int, vtkIdType> SamplesBySurface;
  /// The number of samples that reached a surface by ending at the end of the field within
  /// ArrivalTolerance of it.
  vtkIdType ReachedWithinTolerance = 0;
  /// The numbers of accepted and rejected steps of the explicit method, and of Rosenbrock's.
  vtkIdType Steps = 0;
  vtkIdType RejectedSteps = 0;
  vtkIdType StiffSteps = 0;
  vtkIdType RejectedStiffSteps = 0;
  /// The number of those among Steps that were taken together with steps of three other
  /// streamlines, on images and rectilinear grids. Their bytes are those of single steps.
  vtkIdType SimdSteps = 0;
  /// The number of samples that took at least one step of Rosenbrock's method.
  vtkIdType StiffSamples = 0;
  /// The number of samples whose answer was interpolated from those around (ShareStreamlines). The
  /// number of interpolations among these that were compared with a streamline, and their largest
  /// and mean error: the distance of the ends, or the difference of times at the field's largest
  /// speed, whichever is more, over MaximumError times the time of the streamline.
  vtkIdType InterpolatedSamples = 0;
  vtkIdType InterpolationChecks = 0;
  double LargestInterpolationError = 0.0;
  double MeanInterpolationError = 0.0;
  /// The numbers of evaluations of the field, of its Jacobian, and of surfaces' distances.
  vtkIdType Evaluations = 0;
  vtkIdType JacobianEvaluations = 0;
  vtkIdType DistanceEvaluations = 0;
  /// The number of cells that streamlines entered.
  vtkIdType CellsVisited = 0;
  /// The number of cells of the input that are not part of the field, having fewer than three
  /// dimensions.
  vtkIdType LowerDimensionalCells = 0;
  /// The numbers of cells that were mixed and of samples that were added, by level of refinement.
  std::vector<vtkIdType> RefinedCells;
  std::vector<vtkIdType> AddedSamples;
  /// The interpolation error between samples (SamplingChecks). The streamlines that it was compared
  /// with are in no other number of this report.
  SamplingReport Sampling;
  /// The number of executions that advected samples since the filter was made.
  vtkIdType Executions = 0;
  /// The largest speed at a point of the field; the number of points with vectors that look like
  /// fill values, which automatic settings ignore.
  double MaximumSpeed = 0.0;
  vtkIdType FillValues = 0;
  /// The number of faces of cells of an unstructured grid whose matches were known from an earlier
  /// execution of this or another filter; 0 if they were searched again.
  vtkIdType ReusedFaceMatches = 0;
  /// The number of pairs of cells' faces that are one face only within a tolerance, and the largest
  /// distance between corners of such faces, in widths of the cell.
  vtkIdType ToleranceMatchedFaces = 0;
  double LargestFaceGap = 0.0;
  /// The number of outer faces with a cell on their far side that has no face that fits, and the
  /// cell of the first.
  vtkIdType NonconformingFaces = 0;
  vtkIdType FirstNonconformingCell = -1;
  /// The bytes of the vectors, and of the arrays that means are taken of, that this process holds.
  vtkIdType FieldBytes = 0;
  /// If processes hold the field in parts: the number of steps that each took, rejected ones too,
  /// for any process's samples; and how often a streamline was handed on to the next process, in
  /// all of them. Both are the same in each process, and empty or 0 if a process holds all.
  std::vector<vtkIdType> StepsPerProcess;
  vtkIdType StreamlineTransfers = 0;
  /// The reason why each of several processes holds the whole field; empty if they hold parts, and
  /// for one process.
  std::string WholeFieldReason;
  /// The number of streamlines that were taken from a checkpoint instead of being followed, all of
  /// which count in the numbers above, and how often one was written.
  vtkIdType ResumedStreamlines = 0;
  vtkIdType Checkpoints = 0;
  /// The error and the speed in use, also if the settings are automatic.
  double MaximumError = 0.0;
  double MinimumSpeed = 0.0;
  /// The component that the vectors of FillValues have, 0 if they differ or there are none, and the
  /// largest speed at all other points.
  double FillValue = 0.0;
  double SpeedScale = 0.0;
  /// The number of points of the field's cells with vectors that are NaN or infinite.
  vtkIdType NonFiniteVectors = 0;
};

}

#endif
