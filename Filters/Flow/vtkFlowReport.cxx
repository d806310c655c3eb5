// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowReport.h"

#include "Advection/AdvectionOptions.h"

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
  os << indent << "ReachedWithinTolerance: " << this->ReachedWithinTolerance << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "RejectedSteps: " << this->RejectedSteps << "\n";
  os << indent << "StiffSteps: " << this->StiffSteps << "\n";
  os << indent << "RejectedStiffSteps: " << this->RejectedStiffSteps << "\n";
  os << indent << "StiffSamples: " << this->StiffSamples << "\n";
  os << indent << "Evaluations: " << this->Evaluations << "\n";
  os << indent << "JacobianEvaluations: " << this->JacobianEvaluations << "\n";
  os << indent << "DistanceEvaluations: " << this->DistanceEvaluations << "\n";
  os << indent << "CellsVisited: " << this->CellsVisited << "\n";
  os << indent << "CellsOfFewerDimensions: " << this->CellsOfFewerDimensions << "\n";
  for (std::size_t level = 0; level < this->RefinedCells.size(); ++level)
  {
    os << indent << "Refinement level " << level + 1 << ": " << this->RefinedCells[level]
       << " cells, " << this->AddedSamples[level] << " samples added\n";
  }
  os << indent << "Executions: " << this->Executions << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "MinimumSpeed: " << this->MinimumSpeed << "\n";
  os << indent << "MaximumSpeed: " << this->MaximumSpeed << "\n";
  os << indent << "FillValues: " << this->FillValues << "\n";
  os << indent << "JoinedFaces: " << this->JoinedFaces << "\n";
  os << indent << "LargestJoinedGap: " << this->LargestJoinedGap << "\n";
  os << indent << "OpenInterfaces: " << this->OpenInterfaces << "\n";
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
  this->RejectedSteps += result.RejectedSteps;
  this->StiffSteps += result.StiffSteps;
  this->RejectedStiffSteps += result.RejectedStiffSteps;
  this->StiffSamples += result.StiffSteps > 0 ? 1 : 0;
  this->Evaluations += result.Evaluations;
  this->JacobianEvaluations += result.JacobianEvaluations;
  this->DistanceEvaluations += result.DistanceEvaluations;
  this->CellsVisited += result.Cells;
}
