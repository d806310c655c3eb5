// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowReport.h"

#include "Advection/AdvectionOptions.h"
#include "Common/NamedValue.h"

void vtkFlowReport::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Samples: " << this->Samples << "\n";
  for (int status = 0; status < vtkFlowStatus::NUMBER_OF_VALUES; ++status)
  {
    os << indent << "Samples, " << vtkFlowStatus::GetName(status) << ": "
       << this->Statuses[static_cast<std::size_t>(status)] << "\n";
  }
  for (const auto& surface : this->Reached)
  {
    os << indent << "Reached surface " << surface.first << ": " << surface.second << "\n";
  }
  interlume::NamedValue::Print(os, indent,
    { { "ReachedWithinTolerance", this->ReachedWithinTolerance }, { "Steps", this->Steps },
      { "RejectedSteps", this->RejectedSteps }, { "StiffSteps", this->StiffSteps },
      { "RejectedStiffSteps", this->RejectedStiffSteps }, { "StiffSamples", this->StiffSamples },
      { "LaneSteps", this->LaneSteps }, { "SharedSamples", this->SharedSamples },
      { "SharedChecks", this->SharedChecks }, { "LargestSharedError", this->LargestSharedError },
      { "MeanSharedError", this->MeanSharedError }, { "Evaluations", this->Evaluations },
      { "JacobianEvaluations", this->JacobianEvaluations },
      { "DistanceEvaluations", this->DistanceEvaluations }, { "CellsVisited", this->CellsVisited },
      { "CellsOfFewerDimensions", this->CellsOfFewerDimensions } });
  for (std::size_t level = 0; level < this->RefinedCells.size(); ++level)
  {
    os << indent << "Refinement level " << level + 1 << ": " << this->RefinedCells[level]
       << " cells, " << this->AddedSamples[level] << " samples added\n";
  }
  interlume::NamedValue::Print(os, indent,
    { { "SamplingChecks", this->Sampling.Checks },
      { "SamplingSplitCells", this->Sampling.SplitCells },
      { "SamplingDifferentMiddles", this->Sampling.DifferentMiddles },
      { "SamplingCompared", this->Sampling.Compared } });
  const auto printError = [&](const char* quantity, const vtkFlowSamplingReport::Error& error)
  {
    os << indent << "Sampling error, " << quantity << ": mean " << error.Mean << ", 99 % "
       << error.Percentile99 << ", largest " << error.Largest << "\n";
  };
  printError("u", this->Sampling.U);
  printError("v", this->Sampling.V);
  printError("time", this->Sampling.Time);
  interlume::NamedValue::Print(os, indent,
    { { "Executions", this->Executions }, { "MaximumError", this->MaximumError },
      { "MinimumSpeed", this->MinimumSpeed }, { "MaximumSpeed", this->MaximumSpeed },
      { "FillValues", this->FillValues }, { "FillValue", this->FillValue },
      { "SpeedScale", this->SpeedScale }, { "NonFiniteVectors", this->NonFiniteVectors },
      { "KeptFaces", this->KeptFaces }, { "JoinedFaces", this->JoinedFaces },
      { "LargestJoinedGap", this->LargestJoinedGap }, { "OpenInterfaces", this->OpenInterfaces },
      { "FieldBytes", this->FieldBytes }, { "ResumedStreamlines", this->ResumedStreamlines },
      { "Checkpoints", this->Checkpoints } });
  for (std::size_t rank = 0; rank < this->StepsOfRanks.size(); ++rank)
  {
    os << indent << "Steps of process " << rank << ": " << this->StepsOfRanks[rank] << "\n";
  }
  if (!this->StepsOfRanks.empty())
  {
    os << indent << "HandedOn: " << this->HandedOn << "\n";
  }
  if (!this->WholeFieldReason.empty())
  {
    os << indent << "Each process holds the whole field: " << this->WholeFieldReason << "\n";
  }
}

void vtkFlowReport::Add(const vtkFlowReport& other)
{
  this->Samples += other.Samples;
  for (std::size_t status = 0; status < this->Statuses.size(); ++status)
  {
    this->Statuses[status] += other.Statuses[status];
  }
  for (const auto& surface : other.Reached)
  {
    this->Reached[surface.first] += surface.second;
  }
  this->ReachedWithinTolerance += other.ReachedWithinTolerance;
  this->Steps += other.Steps;
  this->LaneSteps += other.LaneSteps;
  this->RejectedSteps += other.RejectedSteps;
  this->StiffSteps += other.StiffSteps;
  this->RejectedStiffSteps += other.RejectedStiffSteps;
  this->StiffSamples += other.StiffSamples;
  this->Evaluations += other.Evaluations;
  this->JacobianEvaluations += other.JacobianEvaluations;
  this->DistanceEvaluations += other.DistanceEvaluations;
  this->CellsVisited += other.CellsVisited;
}

void vtkFlowReport::Add(const interlume::AdvectionResult& result)
{
  ++this->Samples;
  ++this->Statuses[static_cast<std::size_t>(result.Status)];
  if (result.Status == vtkFlowStatus::REACHED_SURFACE)
  {
    ++this->Reached[result.Id];
    this->ReachedWithinTolerance += result.Nearness > 0.0 ? 1 : 0;
  }
  this->Steps += result.Steps;
  this->LaneSteps += result.LaneSteps;
  this->RejectedSteps += result.RejectedSteps;
  this->StiffSteps += result.StiffSteps;
  this->RejectedStiffSteps += result.RejectedStiffSteps;
  this->StiffSamples += result.StiffSteps > 0 ? 1 : 0;
  this->Evaluations += result.Evaluations;
  this->JacobianEvaluations += result.JacobianEvaluations;
  this->DistanceEvaluations += result.DistanceEvaluations;
  this->CellsVisited += result.Cells;
}
