// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowReport_h
#define vtkFlowReport_h

#include "InterlumeFlowModule.h"   // for the export macro
#include "vtkFlowSamplingReport.h" // for the error of sampling
#include "vtkFlowStatus.h"
#include "vtkIndent.h"
#include "vtkType.h"

#include <array>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace interlume
{
struct AdvectionResult;
}

/**
 * @class   vtkFlowReport
 * @brief   what an execution of vtkImplicitFlowField did
 *
 * Holds sums over all samples, which are the same for any number of threads.
 */
class INTERLUMEFLOW_EXPORT vtkFlowReport
{
public:
  void Print(std::ostream& os, vtkIndent indent) const;
  void Add(const vtkFlowReport& other);
  /// Adds the result of one sample.
  void Add(const interlume::AdvectionResult& result);

  vtkIdType Samples = 0;
  /// The number of samples for each vtkFlowStatus.
  std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES> Statuses{};
  /// The number of samples that reached a surface, by TerminationId.
  std::map<int, vtkIdType> Reached;
  /// The number of samples that reached a surface by ending at the end of the field within
  /// ArrivalTolerance of it.
  vtkIdType ReachedWithinTolerance = 0;
  /// The numbers of accepted and rejected steps of the explicit method, and of Rosenbrock's.
  vtkIdType Steps = 0;
  vtkIdType RejectedSteps = 0;
  vtkIdType StiffSteps = 0;
  vtkIdType RejectedStiffSteps = 0;
  /// Those of Steps that were taken with steps of three other streamlines at once, on images and
  /// rectilinear grids. They have the bytes that they would have alone.
  vtkIdType LaneSteps = 0;
  /// The number of samples that took at least one step of Rosenbrock's method.
  vtkIdType StiffSamples = 0;
  /// The number of samples whose answer was interpolated from those around (ShareStreamlines). The
  /// number of interpolations among these that were compared with a streamline, and their largest
  /// and mean error: the distance of the ends, or the difference of times at the field's largest
  /// speed, whichever is more, over MaximumError times the time of the streamline.
  vtkIdType SharedSamples = 0;
  vtkIdType SharedChecks = 0;
  double LargestSharedError = 0.0;
  double MeanSharedError = 0.0;
  /// The numbers of evaluations of the field, of its Jacobian, and of surfaces' distances.
  vtkIdType Evaluations = 0;
  vtkIdType JacobianEvaluations = 0;
  vtkIdType DistanceEvaluations = 0;
  /// The number of cells that streamlines entered.
  vtkIdType CellsVisited = 0;
  /// The number of cells of the input that are not part of the field, having fewer than three
  /// dimensions.
  vtkIdType CellsOfFewerDimensions = 0;
  /// The numbers of cells that were mixed and of samples that were added, by level of refinement.
  std::vector<vtkIdType> RefinedCells;
  std::vector<vtkIdType> AddedSamples;
  /// What interpolation between samples is off by (SamplingChecks). The streamlines that it was
  /// compared with are in no other number of this report.
  vtkFlowSamplingReport Sampling;
  /// How often samples were advected since the filter was made; an execution that advects none does
  /// not count.
  vtkIdType Executions = 0;
  /// The largest speed at a point of the field; the number of points with vectors that look like
  /// fill values, which automatic settings ignore.
  double MaximumSpeed = 0.0;
  vtkIdType FillValues = 0;
  /// The number of faces of cells of an unstructured grid of which it was known from an execution
  /// before, of this filter or another, which of them are one face; 0 where that was found anew.
  vtkIdType KeptFaces = 0;
  /// The number of pairs of cells' faces that are one face within a tolerance only, and the largest
  /// distance between corners of such faces, in widths of the cell.
  vtkIdType JoinedFaces = 0;
  double LargestJoinedGap = 0.0;
  /// The number of outer faces with a cell beyond them that has no face that fits, and the cell of
  /// the first.
  vtkIdType OpenInterfaces = 0;
  vtkIdType FirstOpenCell = -1;
  /// The bytes of the vectors, and of the arrays that means are taken of, that this process holds.
  vtkIdType FieldBytes = 0;
  /// Of processes that hold the field in parts: the steps that each took, rejected ones too, for
  /// whichever samples; and how often a streamline was handed on to the next process, in all of
  /// them. Both are the same in each process, and 0 or empty where a process holds all.
  std::vector<vtkIdType> StepsOfRanks;
  vtkIdType HandedOn = 0;
  /// Why each of several processes holds the whole field; empty where they hold parts, and for one
  /// process.
  std::string WholeFieldReason;
  /// The number of streamlines that were taken from a checkpoint instead of being followed, all of
  /// which count in the numbers above, and how often one was written.
  vtkIdType ResumedStreamlines = 0;
  vtkIdType Checkpoints = 0;
  /// The error and the speed in use, which tell what was taken for automatic settings.
  double MaximumError = 0.0;
  double MinimumSpeed = 0.0;
  /// The component that the vectors of FillValues have, 0 if they differ or there are none, and the
  /// largest speed at all other points.
  double FillValue = 0.0;
  double SpeedScale = 0.0;
  /// The number of points of the field's cells with vectors that are NaN or infinite.
  vtkIdType NonFiniteVectors = 0;
};

#endif
