// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeVaryingIntervalVolume.h"

#include "Common/Error.h"
#include "Output/ProcessBalance.h"
#include "Static/EmptyOutputDiagnosis.h"
#include "Static/ExtractionInput.h"
#include "TimeVarying/CoarseSeries.h"
#include "TimeVarying/SeriesEstimate.h"
#include "TimeVarying/TimeVaryingRun.h"

#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkTimeVaryingIntervalVolume);

namespace
{
constexpr int NumberOfPorts = 3;
// Number of slabs below which LimitTimeSteps() shortens the range instead of increasing the stride.
constexpr int MinimumNumberOfSlabs = 4;
}

vtkTimeVaryingIntervalVolume::vtkTimeVaryingIntervalVolume()
{
  this->SetNumberOfOutputPorts(NumberOfPorts);
  interlume::TimeVaryingReport().CopyTo(this->Report);
}

vtkTimeVaryingIntervalVolume::~vtkTimeVaryingIntervalVolume() = default;

void vtkTimeVaryingIntervalVolume::SetGenerateBoundary(int kind, bool on)
{
  if (kind < 0 || kind >= NUMBER_OF_BOUNDARY_KINDS)
  {
    vtkErrorMacro("Boundary kind " << kind << " is not in the range 0 to "
                                   << NUMBER_OF_BOUNDARY_KINDS - 1 << ".");
    return;
  }
  if (this->GenerateBoundary[kind] != on)
  {
    this->GenerateBoundary[kind] = on;
    this->Modified();
  }
}

bool vtkTimeVaryingIntervalVolume::GetGenerateBoundary(int kind) const
{
  return kind >= 0 && kind < NUMBER_OF_BOUNDARY_KINDS && this->GenerateBoundary[kind];
}

void vtkTimeVaryingIntervalVolume::SetGenerateBoundaries(bool on)
{
  for (int kind = 0; kind < NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    this->SetGenerateBoundary(kind, on);
  }
}

int vtkTimeVaryingIntervalVolume::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformationDoubleVectorKey* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  this->TimeSteps.clear();
  if (input->Has(key))
  {
    this->TimeSteps.assign(input->Get(key), input->Get(key) + input->Length(key));
  }
  // The input changed between time steps, or an execution was interrupted: restart. Restart only
  // once, since some readers are modified at every step.
  if (this->Run && !this->IsRestarted)
  {
    this->Run.reset();
    this->IsRestarted = true;
  }
  // The outputs combine all time steps, so they have no times themselves.
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    outputs->GetInformationObject(port)->Remove(key);
    outputs->GetInformationObject(port)->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  }
  return 1;
}

interlume::Error vtkTimeVaryingIntervalVolume::CheckTimes(const std::vector<int>& steps) const
{
  const std::vector<double> times = this->GetTimes(steps);
  std::ostringstream message;
  if (times.size() < 2)
  {
    message << "At least two time steps are needed; the input has " << this->TimeSteps.size()
            << ", of which " << times.size() << " are in the range " << this->TimeStepRange[0]
            << " to " << this->TimeStepRange[1] << ".";
    return message.str();
  }
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const int step = steps[i];
    if (!std::isfinite(times[i]))
    {
      message << "Time step " << step << " has the time " << times[i] << ", which is not finite.";
      return message.str();
    }
    if (i > 0 && times[i] < times[i - 1])
    {
      message << "Time step " << step << " (time " << times[i] << ") is before time step "
              << steps[i - 1] << " (time " << times[i - 1] << ").";
      return message.str();
    }
  }
  return {};
}

interlume::Error vtkTimeVaryingIntervalVolume::CheckDirection() const
{
  const double* d = this->ProjectionDirection;
  const bool isFinite = std::all_of(d, d + 4, [](double value) { return std::isfinite(value); });
  if (isFinite && std::any_of(d, d + 4, [](double value) { return value != 0.0; }))
  {
    return {};
  }
  std::ostringstream message;
  message << "The direction of projection (" << d[0] << ", " << d[1] << ", " << d[2] << ", " << d[3]
          << ") is " << (isFinite ? "zero." : "not finite.");
  return message.str();
}

interlume::Error vtkTimeVaryingIntervalVolume::CheckCriteriaSettings() const
{
  for (const std::string& name : this->GetCriteriaArrayNames())
  {
    if (name.empty() || name == "Time" || name == "DeltaT")
    {
      return "The array \"" + name +
        "\" of a criterion has no name, or the name of an array that this filter creates (Time or "
        "DeltaT). Rename it.";
    }
  }
  return {};
}

std::vector<int> vtkTimeVaryingIntervalVolume::GetSelectedSteps(int stride) const
{
  const int number = static_cast<int>(this->TimeSteps.size());
  const int last = std::min(this->TimeStepRange[1], number - 1);
  std::vector<int> steps;
  for (int step = std::max(this->TimeStepRange[0], 0); step <= last;)
  {
    steps.push_back(step);
    step += step == last ? 1 : std::min(stride, last - step);
  }
  return steps;
}

std::vector<double> vtkTimeVaryingIntervalVolume::GetTimes(const std::vector<int>& steps) const
{
  std::vector<double> times;
  for (const int step : steps)
  {
    times.push_back(this->TimeSteps[static_cast<std::size_t>(step)]);
  }
  return times;
}

int vtkTimeVaryingIntervalVolume::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  const std::vector<int> steps = this->GetSelectedSteps(this->TimeStepStride);
  if (!this->Run && this->BeginPreview(steps, input))
  {
    // Without a time, the input does not execute again.
    input->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  }
  else if (this->Run || !steps.empty())
  {
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(),
      this->Run ? this->Run->GetNextTime() : this->TimeSteps[steps.front()]);
  }
  return 1;
}

bool vtkTimeVaryingIntervalVolume::BeginPreview(
  const std::vector<int>& steps, vtkInformation* input)
{
  if (this->GetPreviewCellLimit() == 0 || steps.size() < 2)
  {
    this->Coarse.reset();
    return false;
  }
  if (!this->Coarse)
  {
    this->Coarse = std::make_unique<interlume::CoarseSeries>();
  }
  interlume::CoarseSeries::Key key;
  key.Steps = steps;
  key.Limit = this->GetPreviewCellLimit();
  if (auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetInputExecutive(0, 0)))
  {
    key.InputTime = pipeline->GetPipelineMTime();
  }
  key.Piece = { { input->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()),
    input->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()),
    input->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) } };
  return this->Coarse->Begin(key);
}

bool vtkTimeVaryingIntervalVolume::Begin(bool copiesSteps)
{
  const std::vector<int> steps = this->GetSelectedSteps(
    this->TimeStepStride * (this->Coarse ? this->Coarse->GetTimeStride() : 1));
  for (const interlume::Error& error : { this->CheckTimes(steps), this->CheckDirection(),
         interlume::ExtractionInput::CheckIntervals(this->GetIntervals()),
         this->CheckCriteriaSettings() })
  {
    if (error)
    {
      vtkErrorMacro(<< error);
      return false;
    }
  }
  interlume::TimeVaryingOptions options(*this, this->GetOutputPointsPrecision(), copiesSteps);
  for (int i = 0; i < this->GetNumberOfCriteria(); ++i)
  {
    const Criterion& criterion = this->GetCriteria()[i];
    options.Criteria.push_back(
      { criterion.ArrayName, criterion.Lower, criterion.Upper, this->DescribeCriterion(i) });
  }
  options.Operation = this->GetCriteriaOperation();
  this->Run = std::make_unique<interlume::TimeVaryingRun>(this, this->GetIntervals(), options,
    steps, this->GetTimes(steps), this->Coarse ? 0 : this->GetSizeWarningLimit(),
    [this](vtkDataSet* input) { return this->CheckCriteria(input); });
  return true;
}

std::unique_ptr<interlume::SeriesEstimate> vtkTimeVaryingIntervalVolume::EstimateSeries(
  const std::function<std::vector<int>(int lastStep)>& chooseDistances)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  this->UpdateInformation();
  const std::vector<int> steps = this->GetSelectedSteps(1);
  if (this->CheckTimes(steps) || this->CheckDirection() || this->CheckCriteriaSettings() ||
    interlume::ExtractionInput::CheckIntervals(this->GetIntervals()))
  {
    return nullptr;
  }
  const vtkTimeVaryingSettings& settings = *this;
  auto estimate = std::make_unique<interlume::SeriesEstimate>(
    this, this->GetIntervals(), settings, this->GetTimes(steps));
  int port = 0;
  vtkAlgorithm* source = this->GetInputAlgorithm(0, 0, port);
  const auto read = [this, source, port, first = steps.front()](int step)
  {
    source->GetOutputInformation(port)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(),
      this->TimeSteps[static_cast<std::size_t>(first + step)]);
    source->Update(port);
    return source->GetOutputDataObject(port);
  };
  return estimate->Read(chooseDistances(estimate->GetLastStep()), read) ? std::move(estimate)
                                                                        : nullptr;
}

vtkIdType vtkTimeVaryingIntervalVolume::EstimateNumberOfTetrahedra()
{
  const auto estimate = this->EstimateSeries(
    [this](int last) { return std::vector<int>{ std::min(this->TimeStepStride, last) }; });
  return estimate ? static_cast<vtkIdType>(estimate->GetSize(this->TimeStepStride)) : 0;
}

vtkIdType vtkTimeVaryingIntervalVolume::LimitTimeSteps()
{
  int longest = 1;
  const auto estimate = this->EstimateSeries(
    [&longest](int last)
    {
      longest = std::max(1, last / MinimumNumberOfSlabs);
      std::vector<int> distances;
      for (int distance = 1; distance < longest; distance *= 2)
      {
        distances.push_back(distance);
      }
      distances.push_back(longest);
      return distances;
    });
  if (!estimate)
  {
    return 0;
  }
  const double limit = this->GetSizeWarningLimit() > 0
    ? static_cast<double>(this->GetSizeWarningLimit())
    : std::numeric_limits<double>::infinity();
  int stride = 1;
  while (stride < longest && estimate->GetSize(stride) > limit)
  {
    ++stride;
  }
  double size = estimate->GetSize(stride);
  if (size > limit)
  {
    int last = stride;
    size = estimate->GetSlabSize(stride, 0);
    for (double next = 0.0; last < estimate->GetLastStep(); last += stride, size = next)
    {
      next = size + estimate->GetSlabSize(stride, last);
      if (next > limit)
      {
        break;
      }
    }
    if (last < estimate->GetLastStep())
    {
      this->SetTimeStepRange(this->TimeStepRange[0], std::max(this->TimeStepRange[0], 0) + last);
    }
  }
  this->SetTimeStepStride(stride);
  return static_cast<vtkIdType>(size);
}

int vtkTimeVaryingIntervalVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::TimeVaryingReport report;
  this->ProcessStep(request, inputs, outputs, report);
  // All processes reach this point, however many steps each one processes.
  const bool isEnd = !request->Has(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  if (isEnd && this->GetReportBalance())
  {
    interlume::ProcessBalance::Gather(this, report);
  }
  report.CopyTo(this->Report);
  return 1;
}

void vtkTimeVaryingIntervalVolume::ProcessStep(vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs,
  interlume::TimeVaryingReport& report)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* filled[NumberOfPorts];
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    filled[port] = vtkDataObject::GetData(outputs, port);
  }
  this->IsFilled = false;
  if (!this->Run && this->GetNumberOfIntervals() == 0)
  {
    this->WarnOfEmptyOutput(
      interlume::EmptyOutputDiagnosis().Explain(this, "no interval is set.", ""));
    return;
  }
  if (!this->Run && this->Coarse)
  {
    this->Coarse->ChooseStrides(input);
  }
  if (!this->Run && !this->Begin(false))
  {
    return;
  }
  interlume::TimeVaryingRun::Results result;
  const interlume::Error error = this->Coarse ? this->Coarse->AddStep(input, *this->Run, result)
                                              : this->Run->AddStep(input, result);
  if (result == interlume::TimeVaryingRun::OVERWRITTEN)
  {
    // The values of the previous step are lost: request its time again.
    this->Begin(true);
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return;
  }
  if (result == interlume::TimeVaryingRun::DONE && !this->Run->IsFinished() &&
    !this->GetAbortExecute())
  {
    report = this->Run->GetReport();
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return;
  }
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  const std::unique_ptr<interlume::TimeVaryingRun> run = std::move(this->Run);
  this->IsRestarted = false;
  if (error)
  {
    vtkErrorMacro(<< error);
  }
  else if (result == interlume::TimeVaryingRun::DONE && run->IsFinished())
  {
    for (vtkDataObject* output : filled)
    {
      interlume::TimeVaryingRun::CopyStructure(input, output);
    }
    this->IsFilled = run->FillOutputs(filled[0], filled[1], filled[2]);
    if (!this->IsFilled)
    {
      std::for_each(
        filled, filled + NumberOfPorts, [](vtkDataObject* output) { output->Initialize(); });
    }
  }
  this->SetProgressShiftScale(0.0, 1.0);
  report = run->GetReport();
  report.Passes = report.Slabs;
  for (const std::string& warning : this->Coarse ? std::vector<std::string>() : run->GetWarnings())
  {
    vtkWarningMacro(<< warning);
  }
  if (result == interlume::TimeVaryingRun::DONE)
  {
    this->WarnOfEmptyOutput(this->ExplainEmpty(*run));
  }
}

std::string vtkTimeVaryingIntervalVolume::ExplainEmpty(interlume::TimeVaryingRun& run)
{
  const interlume::TimeVaryingReport& report = run.GetReport();
  if (report.Slabs == 0)
  {
    // Another warning reports slabs of zero duration.
    return std::string();
  }
  const auto& kinds = this->GenerateBoundary;
  const bool hasBoundary = std::find(kinds.begin(), kinds.end(), true) != kinds.end();
  const bool isSelected = this->GenerateTetrahedra || this->GenerateSimplices || hasBoundary;
  const std::string why = run.GetEmptyOutputDiagnosis().Explain(this,
    isSelected
      ? ""
      : "no output is selected. Turn on GenerateTetrahedra, GenerateSimplices or a boundary.",
    this->DescribeIntervals() + " at any time");
  if (why.empty() && this->GenerateTetrahedra && report.Simplices > 0 &&
    report.FlatSimplices == report.Simplices)
  {
    return "all " + std::to_string(report.Simplices) +
      " 4-simplices have zero extent along ProjectionDirection.";
  }
  return why;
}

void vtkTimeVaryingIntervalVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStepRange: " << this->TimeStepRange[0] << " to " << this->TimeStepRange[1]
     << "\n";
  os << indent << "TimeStepStride: " << this->TimeStepStride << "\n";
  os << indent << "ProjectionDirection: " << this->ProjectionDirection[0] << " "
     << this->ProjectionDirection[1] << " " << this->ProjectionDirection[2] << " "
     << this->ProjectionDirection[3] << "\n";
  os << indent << "GenerateTetrahedra: " << this->GenerateTetrahedra << "\n";
  os << indent << "GenerateSimplices: " << this->GenerateSimplices << "\n";
  os << indent << "GenerateBoundary:";
  for (const bool on : this->GenerateBoundary)
  {
    os << " " << on;
  }
  os << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
