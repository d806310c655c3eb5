// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/FlowReport.h"

#include "Advection/AdvectionOptions.h"
#include "Common/ReportValue.h"

namespace interlume
{

void FlowReport::CopyTo(vtkInterlumeReport* report) const
{
  std::vector<int> ids;
  std::vector<vtkIdType> samples;
  for (const auto& surface : this->SamplesBySurface)
  {
    ids.push_back(surface.first);
    samples.push_back(surface.second);
  }
  const auto list = [](const SamplingReport::Error& error) {
    return std::array<double, 3>{ { error.Mean, error.Percentile99, error.Largest } };
  };
  ReportValue::Set(report,
    { { "Samples", this->Samples }, { "Statuses", this->Statuses }, { "SurfaceIds", ids },
      { "SamplesBySurface", samples }, { "ReachedWithinTolerance", this->ReachedWithinTolerance },
      { "Steps", this->Steps }, { "RejectedSteps", this->RejectedSteps },
      { "StiffSteps", this->StiffSteps }, { "RejectedStiffSteps", this->RejectedStiffSteps },
      { "SimdSteps", this->SimdSteps }, { "StiffSamples", this->StiffSamples },
      { "InterpolatedSamples", this->InterpolatedSamples },
      { "InterpolationChecks", this->InterpolationChecks },
      { "LargestInterpolationError", this->LargestInterpolationError },
      { "MeanInterpolationError", this->MeanInterpolationError },
      { "Evaluations", this->Evaluations }, { "JacobianEvaluations", this->JacobianEvaluations },
      { "DistanceEvaluations", this->DistanceEvaluations }, { "CellsVisited", this->CellsVisited },
      { "LowerDimensionalCells", this->LowerDimensionalCells },
      { "RefinedCells", this->RefinedCells }, { "AddedSamples", this->AddedSamples },
      { "SamplingChecks", this->Sampling.Checks },
      { "SamplingSplitCells", this->Sampling.SplitCells },
      { "SamplingMismatchedCenters", this->Sampling.MismatchedCenters },
      { "SamplingCompared", this->Sampling.Compared }, { "SamplingErrorU", list(this->Sampling.U) },
      { "SamplingErrorV", list(this->Sampling.V) },
      { "SamplingErrorTime", list(this->Sampling.Time) }, { "Executions", this->Executions },
      { "MaximumSpeed", this->MaximumSpeed }, { "FillValues", this->FillValues },
      { "ReusedFaceMatches", this->ReusedFaceMatches },
      { "ToleranceMatchedFaces", this->ToleranceMatchedFaces },
      { "LargestFaceGap", this->LargestFaceGap },
      { "NonconformingFaces", this->NonconformingFaces },
      { "FirstNonconformingCell", this->FirstNonconformingCell },
      { "FieldBytes", this->FieldBytes }, { "StepsPerProcess", this->StepsPerProcess },
      { "StreamlineTransfers", this->StreamlineTransfers },
      { "WholeFieldReason", this->WholeFieldReason },
      { "ResumedStreamlines", this->ResumedStreamlines }, { "Checkpoints", this->Checkpoints },
      { "MaximumError", this->MaximumError }, { "MinimumSpeed", this->MinimumSpeed },
      { "FillValue", this->FillValue }, { "SpeedScale", this->SpeedScale },
      { "NonFiniteVectors", this->NonFiniteVectors },
      { "ConvertedCellArrays", this->ConvertedCellArrays } });
}

void FlowReport::Add(const FlowReport& other)
{
  this->Samples += other.Samples;
  for (std::size_t status = 0; status < this->Statuses.size(); ++status)
  {
    this->Statuses[status] += other.Statuses[status];
  }
  for (const auto& surface : other.SamplesBySurface)
  {
    this->SamplesBySurface[surface.first] += surface.second;
  }
  this->ReachedWithinTolerance += other.ReachedWithinTolerance;
  this->Steps += other.Steps;
  this->SimdSteps += other.SimdSteps;
  this->RejectedSteps += other.RejectedSteps;
  this->StiffSteps += other.StiffSteps;
  this->RejectedStiffSteps += other.RejectedStiffSteps;
  this->StiffSamples += other.StiffSamples;
  this->Evaluations += other.Evaluations;
  this->JacobianEvaluations += other.JacobianEvaluations;
  this->DistanceEvaluations += other.DistanceEvaluations;
  this->CellsVisited += other.CellsVisited;
}

void FlowReport::Add(const AdvectionResult& result)
{
  ++this->Samples;
  ++this->Statuses[static_cast<std::size_t>(result.Status)];
  if (result.Status == vtkFlowStatus::REACHED_SURFACE)
  {
    ++this->SamplesBySurface[result.Id];
    this->ReachedWithinTolerance += result.Nearness > 0.0 ? 1 : 0;
  }
  this->Steps += result.Steps;
  this->SimdSteps += result.SimdSteps;
  this->RejectedSteps += result.RejectedSteps;
  this->StiffSteps += result.StiffSteps;
  this->RejectedStiffSteps += result.RejectedStiffSteps;
  this->StiffSamples += result.StiffSteps > 0 ? 1 : 0;
  this->Evaluations += result.Evaluations;
  this->JacobianEvaluations += result.JacobianEvaluations;
  this->DistanceEvaluations += result.DistanceEvaluations;
  this->CellsVisited += result.Cells;
}

}
