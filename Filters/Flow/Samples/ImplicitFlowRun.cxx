// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ImplicitFlowRun.h"

#include "Advection/AdvectionOptions.h"
#include "Checkpoint/CheckpointedStreamlines.h"
#include "Checkpoint/FlowCheckpoint.h"
#include "Common/ArrayCheck.h"
#include "Common/CellArrayConversion.h"
#include "Common/Vectors.h"
#include "Fields/BoundaryPatches.h"
#include "Fields/FieldDispatch.h"
#include "Fields/NonconformingInterfaces.h"
#include "Samples/CellRefinement.h"
#include "Samples/FarSideStage.h"
#include "Samples/SampleArrays.h"
#include "Samples/SampleIntegration.h"
#include "Samples/SamplingCheck.h"
#include "Streams/LocalStreamlines.h"
#include "Streams/DistributedField.h"
#include "Streams/DistributedStreamlines.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTerminationSurface.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

namespace interlume
{

namespace
{
constexpr double AutomaticError = 1e-6;
constexpr double AutomaticSpeed = 1e-9;
/// Number of bisection steps that locate the boundary of the reached region without obstacles.
constexpr int PreviewBisections = 3;
/// Their streamlines may have this fraction of MaximumNumberOfSteps, since most of those that need
/// more never reach a surface. It does not depend on the samples, so that all pieces are equal.
constexpr int PreviewStepsDivisor = 16;
constexpr int MinimumPreviewSteps = 20;

int GetAutomaticSteps(vtkIdType cells)
{
  constexpr double minimum = 2000.0;
  return static_cast<int>(std::max(minimum, 20.0 * std::cbrt(static_cast<double>(cells))));
}
}

ImplicitFlowRun::ImplicitFlowRun(
  vtkAlgorithm* owner, const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors)
  : Owner(owner)
  , Options(options)
  , Field(field)
  , Data(field)
  , Vectors(vectors)
{
}

void ImplicitFlowRun::SetDistributedField(DistributedField* ranks)
{
  this->Ranks = ranks;
  this->Field = ranks->GetFullGrid();
  this->Data = ranks->GetData();
}

void ImplicitFlowRun::ReplaceAutomaticValues(double speed)
{
  const auto replace = [](auto& value, auto automatic) { value = value > 0 ? value : automatic; };
  // Values must be above 0 even if all vectors are 0.
  constexpr double minimum = std::numeric_limits<double>::min();
  replace(this->Options.MaximumError, std::max(AutomaticError * speed, minimum));
  replace(this->Options.MinimumSpeed, std::max(AutomaticSpeed * speed, minimum));
  replace(this->Options.MaximumTime, VTK_DOUBLE_MAX);
  const vtkIdType cells =
    this->Ranks ? this->Ranks->GetNumberOfCells() : this->Field->GetNumberOfCells();
  replace(this->Options.MaximumNumberOfSteps, GetAutomaticSteps(cells));
  this->Report.MaximumError = this->Options.MaximumError;
  this->Report.MinimumSpeed = this->Options.MinimumSpeed;
}

Error ImplicitFlowRun::FindArrays(std::vector<vtkDataArray*>& means) const
{
  for (const std::string& mean : this->Options.MeanArrays)
  {
    // Valid cell arrays have been converted to point arrays.
    const auto found = CellArrayConversion::FindByName(this->Data, mean);
    const Error error = found.Array
      ? ArrayCheck::FindError(this->Data, found.Array, found.Association, 1)
      : "the field has no point or cell array \"" + mean + "\"";
    if (error)
    {
      return error.Within("Cannot compute a mean along streamlines: ", ".");
    }
    means.push_back(vtkDataArray::SafeDownCast(found.Array));
  }
  return {};
}

Error ImplicitFlowRun::Execute(vtkDataSet* samples)
{
  std::vector<vtkDataArray*> means;
  const bool isEmpty = this->Ranks && this->Ranks->IsEmpty();
  Error error = isEmpty ? Error() : this->FindArrays(means);
  error = this->Ranks ? this->Ranks->GetExchange().FindFirst(error) : error;
  if (error)
  {
    return error;
  }
  for (std::size_t i = 0; i < this->Options.MeanArrays.size(); ++i)
  {
    this->Options.MeanNumbers.push_back(static_cast<int>(i));
  }
  const auto count = [this](vtkDataArray* array)
  { this->Report.FieldBytes += array->GetNumberOfValues() * array->GetDataTypeSize(); };
  if (!isEmpty)
  {
    count(this->Vectors);
    std::for_each(means.begin(), means.end(), count);
  }
  SampleArrays::Make(this->Options, samples->GetPointData(), samples->GetNumberOfPoints());
  return this->Ranks ? this->ExecuteDistributed(means, samples)
                     : this->ExecuteLocal(means, samples);
}

Error ImplicitFlowRun::ExecuteLocal(const std::vector<vtkDataArray*>& means, vtkDataSet* samples)
{
  return FieldDispatch::Execute(
    this->Field, this->Vectors, means,
    [&](const auto& walker)
    {
      auto own = walker;
      int domainFaces = 6;
      BoundaryPatches patches;
      this->Describe(walker.GetField());
      if constexpr (std::is_same_v<decltype(own), UnstructuredWalker>)
      {
        this->Mesh = walker.GetField().GetMesh();
        if (this->Options.DomainFaces)
        {
          const UnstructuredFlowField& field = walker.GetField();
          patches.Build(
            field.GetOuterFaces(),
            [&field](vtkIdType face, vtkIdType* points)
            { return field.GetFacePoints(face, points); },
            field.GetPositions());
          own.SetPatches(&patches);
          domainFaces = patches.GetNumberOfPatches();
        }
      }
      LocalStreamlines<decltype(own)> streamlines(own, this->Owner);
      this->RunStagesWithCheckpoint(streamlines, samples, domainFaces);
    },
    StageProgress(this->Owner, 0.0, FieldDispatch::BuildingPart));
}

Error ImplicitFlowRun::ExecuteDistributed(
  const std::vector<vtkDataArray*>& means, vtkDataSet* samples)
{
  Error error;
  const std::unique_ptr<DistributedStreamlines> streamlines =
    DistributedStreamlines::Make(*this->Ranks, this->Vectors, means, this->Owner, error);
  if (!streamlines)
  {
    return error;
  }
  this->HasObstacles = this->Ranks->GetExchange().IsAnywhere(this->HasObstacles);
  this->Describe(streamlines->GetField());
  streamlines->Describe(this->Report);
  const int domainFaces = this->Options.DomainFaces ? streamlines->FindDomainFaces() : 0;
  this->RunStagesWithCheckpoint(*streamlines, samples, domainFaces);
  RankExchange& exchange = this->Ranks->GetExchange();
  std::vector<vtkIdType> steps(static_cast<std::size_t>(exchange.GetNumberOfRanks()), 0);
  steps[static_cast<std::size_t>(exchange.GetRank())] = streamlines->GetNumberOfSteps();
  exchange.ReduceSum(steps);
  std::vector<vtkIdType> transfers{ streamlines->GetNumberOfTransfers() };
  exchange.ReduceSum(transfers);
  this->Report.StepsPerProcess = steps;
  this->Report.StreamlineTransfers = transfers[0];
  return {};
}

void ImplicitFlowRun::RunStagesWithCheckpoint(
  Streamlines& streamlines, vtkDataSet* samples, int domainFaces)
{
  if (!this->Checkpoint)
  {
    this->RunStages(streamlines, samples, domainFaces);
    return;
  }
  CheckpointedStreamlines recorded(
    streamlines, *this->Checkpoint, this->Ranks ? &this->Ranks->GetExchange() : nullptr);
  this->RunStages(recorded, samples, domainFaces);
  this->Report.ResumedStreamlines = this->Checkpoint->GetNumberOfResumed();
  this->Report.Checkpoints = this->Checkpoint->GetNumberOfFiles();
}

void ImplicitFlowRun::RunStages(Streamlines& streamlines, vtkDataSet* samples, int domainFaces)
{
  this->ReplaceAutomaticValues(streamlines.GetField().GetSpeedScale());
  this->AddSurfacesArray(samples, this->Options.DomainFaces ? domainFaces : 0);
  StageContext context{ streamlines, this->Options, this->Report, this->GetFieldLength(),
    FieldDispatch::BuildingPart };
  SampleIntegration integration(context, samples);
  bool isActive = integration.Run(samples, 0, 0);
  this->InitialStatuses = this->Report.Statuses;
  if (!this->HasObstacles)
  {
    const int steps = this->Options.MaximumNumberOfSteps / PreviewStepsDivisor;
    context.Boundary = { PreviewBisections, std::max(steps, MinimumPreviewSteps), true };
  }
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  if (isActive && this->Options.RefinementLevels > 0)
  {
    grid = CellRefinement::MakeGrid(samples);
    isActive = this->Refine(context, integration, grid);
    samples = grid;
  }
  isActive = isActive &&
    FarSideStage::Run(context, samples, this->HasObstacles || this->LocatesBoundary) &&
    (grid || SamplingCheck::Run(context, samples));
  if (isActive && this->Options.ComputeLocalAttributes)
  {
    ImplicitFlowRun::AddLocalAttributes(streamlines, samples);
  }
  this->Refined = isActive ? grid : nullptr;
  this->Aborted = !isActive;
}

void ImplicitFlowRun::AddLocalAttributes(Streamlines& streamlines, vtkDataSet* samples)
{
  const std::vector<Streamlines::Velocity> velocities = streamlines.GetVelocities(
    samples->GetNumberOfPoints(), [samples](vtkIdType i, double x[3]) { samples->GetPoint(i, x); },
    true);
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName("LocalSpeed");
  vtkNew<vtkDoubleArray> vorticities;
  vorticities->SetName("LocalVorticity");
  for (const Streamlines::Velocity& velocity : velocities)
  {
    speeds->InsertNextValue(Vectors::SafeLength(glm::make_vec3(velocity.V)));
    vorticities->InsertNextValue(velocity.Vorticity);
  }
  samples->GetPointData()->AddArray(speeds);
  samples->GetPointData()->AddArray(vorticities);
}

bool ImplicitFlowRun::Refine(
  StageContext& context, SampleIntegration& integration, vtkSmartPointer<vtkUnstructuredGrid>& grid)
{
  bool isActive = true;
  for (int level = 1; isActive && level <= this->Options.RefinementLevels; ++level)
  {
    isActive = FarSideStage::Run(context, grid, false);
    if (isActive)
    {
      const CellRefinement::Result refined = CellRefinement::Refine(grid);
      const vtkIdType before = grid->GetNumberOfPoints();
      this->Report.RefinedCells.push_back(refined.MixedCells);
      this->Report.AddedSamples.push_back(refined.Grid->GetNumberOfPoints() - before);
      grid = refined.Grid;
      isActive = integration.Run(grid, before, level);
    }
  }
  return isActive;
}

template <typename FieldType>
void ImplicitFlowRun::Describe(const FieldType& field)
{
  this->Report.NonFiniteVectors = field.GetNumberOfNonFiniteVectors();
  this->HasObstacles = this->HasObstacles || this->Report.NonFiniteVectors > 0;
  this->Report.MaximumSpeed = field.GetMaximumSpeed();
  this->Report.FillValues = field.GetFillValues().Number;
  this->Report.FillValue = field.GetFillValues().Value;
  this->Report.SpeedScale = field.GetSpeedScale();
  this->Report.LowerDimensionalCells = field.GetNumberOfFlatCells();
  if constexpr (std::is_same_v<FieldType, StructuredFlowField> ||
    std::is_same_v<FieldType, UnstructuredFlowField>)
  {
    this->Report.ToleranceMatchedFaces = field.GetMatchGaps().Number;
    this->Report.LargestFaceGap = field.GetMatchGaps().LargestGap;
    const auto find = [&field]() -> std::pair<vtkIdType, vtkIdType>
    {
      const interlume::NonconformingInterfaces open =
        interlume::NonconformingInterfaces::Find(field);
      return { open.Number, open.FirstCell };
    };
    if constexpr (std::is_same_v<FieldType, UnstructuredFlowField>)
    {
      this->Report.ReusedFaceMatches = field.GetNumberOfReusedFaceMatches();
      std::tie(this->Report.NonconformingFaces, this->Report.FirstNonconformingCell) =
        field.GetMesh()->GetNonconformingInterfaces(find);
    }
    else
    {
      std::tie(this->Report.NonconformingFaces, this->Report.FirstNonconformingCell) = find();
    }
  }
}

double ImplicitFlowRun::GetFieldLength() const
{
  double bounds[6];
  this->Field->GetBounds(bounds);
  return Vectors::SafeLength(
    { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

void ImplicitFlowRun::AddSurfacesArray(vtkDataSet* samples, int domainFaces) const
{
  vtkNew<vtkIntArray> table;
  table->SetName(vtkFlowStatus::SurfacesArray());
  table->SetNumberOfComponents(3);
  std::set<int> known;
  const auto add = [&](int id, bool isPeriodicU, bool isPeriodicV)
  {
    if (known.insert(id).second)
    {
      const int tuple[3] = { id, isPeriodicU ? 1 : 0, isPeriodicV ? 1 : 0 };
      table->InsertNextTypedTuple(tuple);
    }
  };
  for (const AdvectionOptions::Surface& surface : this->Options.Surfaces)
  {
    for (int part = 0; part < surface.Shape->GetNumberOfParts(); ++part)
    {
      add(
        surface.Id + part, surface.Shape->IsPeriodic(0, part), surface.Shape->IsPeriodic(1, part));
    }
  }
  for (int face = 0; face < domainFaces; ++face)
  {
    add(this->Options.DomainFaceId + face, false, false);
  }
  samples->GetFieldData()->AddArray(table);
}

}
