#ifndef vtkFlowReport_h
#define vtkFlowReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkFlowStatus.h"
#include "vtkIndent.h"
#include "vtkType.h"

#include <array>
#include <map>
#include <ostream>
#include <vector>

namespace interlume
{
struct AdvectionResult;
}

/**
 * @class   vtkFlowReport
 * @brief   what an execution of vtkImplicitFlowField did
 *
 * Sums over all samples; the same for any number of threads.
 */
class INTERLUMEFLOW_EXPORT vtkFlowReport
{
public:
  void Print(std::ostream& os, vtkIndent indent) const;
  void Add(const vtkFlowReport& other);
  /// One sample more.
  void Add(const interlume::AdvectionResult& result);

  vtkIdType Samples = 0;
  /// By vtkFlowStatus.
  std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES> Statuses{};
  /// Samples that reached a surface, by TerminationId.
  std::map<int, vtkIdType> Reached;
  /// Those of them that ended at the end of the field within ArrivalTolerance of their surface.
  vtkIdType ReachedWithinTolerance = 0;
  /// Accepted and rejected steps of the explicit method, and of Rosenbrock's.
  vtkIdType Steps = 0;
  vtkIdType RejectedSteps = 0;
  vtkIdType StiffSteps = 0;
  vtkIdType RejectedStiffSteps = 0;
  /// Samples that took at least one step of Rosenbrock's method.
  vtkIdType StiffSamples = 0;
  /// Evaluations of the field, of its Jacobian, and of surfaces' distances.
  vtkIdType Evaluations = 0;
  vtkIdType JacobianEvaluations = 0;
  vtkIdType DistanceEvaluations = 0;
  /// Cells that streamlines entered.
  vtkIdType CellsVisited = 0;
  /// Cells of the field that are not part of it, having fewer than three dimensions.
  vtkIdType CellsOfFewerDimensions = 0;
  /// By level of refinement: the cells that were mixed, and the samples that were added.
  std::vector<vtkIdType> RefinedCells;
  std::vector<vtkIdType> AddedSamples;
  /// How often samples were advected since the filter was made: what else changes does not count.
  vtkIdType Executions = 0;
  /// The largest speed at a point of the field, and how many points have speeds that automatic
  /// values leave aside as fill values.
  double MaximumSpeed = 0.0;
  vtkIdType FillValues = 0;
  /// Pairs of cells' faces that are one face within a tolerance only, and how far apart corners of
  /// such are at most, in widths of the cell.
  vtkIdType JoinedFaces = 0;
  double LargestJoinedGap = 0.0;
  /// Outer faces with a cell beyond them that has no face that fits, and the cell of the first.
  vtkIdType OpenInterfaces = 0;
  vtkIdType FirstOpenCell = -1;
  /// The error and the speed in use, where those that were set are automatic.
  double MaximumError = 0.0;
  double MinimumSpeed = 0.0;
};

#endif
