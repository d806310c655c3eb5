// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeVaryingIntervalVolume.h"

#include "Common/Error.h"
#include "Output/ProcessBalance.h"
#include "Static/EmptyResult.h"
#include "Static/ExtractionInput.h"
#include "TimeVarying/TimeVaryingRun.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkTimeVaryingIntervalVolume);

namespace
{
constexpr int NumberOfPorts = 3;
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
    vtkErrorMacro(
      "Boundary kind " << kind << " is not in 0 to " << NUMBER_OF_BOUNDARY_KINDS - 1 << ".");
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
  // The input has changed while its steps were taken, or an execution broke off in the middle of
  // them: begin anew, but once, since some readers say so at every step.
  if (this->Run && !this->IsRestarted)
  {
    this->Run.reset();
    this->IsRestarted = true;
  }
  // One output stands for all times.
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    outputs->GetInformationObject(port)->Remove(key);
    outputs->GetInformationObject(port)->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  }
  return 1;
}

interlume::Error vtkTimeVaryingIntervalVolume::CheckTimes(const std::vector<double>& times) const
{
  std::ostringstream what;
  if (times.size() < 2)
  {
    what << "At least two time steps are needed; the input has " << this->TimeSteps.size()
         << ", of which " << times.size() << " are in the range " << this->TimeStepRange[0]
         << " to " << this->TimeStepRange[1] << ".";
    return what.str();
  }
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const std::size_t step = this->GetFirstStep() + i;
    if (!std::isfinite(times[i]))
    {
      what << "Time step " << step << " has the time " << times[i] << ".";
      return what.str();
    }
    if (i > 0 && times[i] < times[i - 1])
    {
      what << "Time step " << step << " (time " << times[i] << ") is before time step " << step - 1
           << " (time " << times[i - 1] << ").";
      return what.str();
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
  std::ostringstream what;
  what << "The direction of projection (" << d[0] << ", " << d[1] << ", " << d[2] << ", " << d[3]
       << ") is " << (isFinite ? "zero." : "not finite.");
  return what.str();
}

int vtkTimeVaryingIntervalVolume::GetFirstStep() const
{
  return std::max(this->TimeStepRange[0], 0);
}

std::vector<double> vtkTimeVaryingIntervalVolume::GetTimesTaken() const
{
  const int number = static_cast<int>(this->TimeSteps.size());
  const int first = this->GetFirstStep();
  const int last = std::min(this->TimeStepRange[1], number - 1);
  return first <= last
    ? std::vector<double>(this->TimeSteps.begin() + first, this->TimeSteps.begin() + last + 1)
    : std::vector<double>();
}

int vtkTimeVaryingIntervalVolume::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  const std::vector<double> times = this->GetTimesTaken();
  if (this->Run || !times.empty())
  {
    inputs[0]->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(),
      this->Run ? this->Run->GetNextTime() : times.front());
  }
  return 1;
}

bool vtkTimeVaryingIntervalVolume::Begin(bool copiesSteps)
{
  const std::vector<double> times = this->GetTimesTaken();
  for (const interlume::Error& error : { this->CheckTimes(times), this->CheckDirection(),
         interlume::ExtractionInput::CheckIntervals(this->GetIntervals()) })
  {
    if (error)
    {
      vtkErrorMacro(<< error);
      return false;
    }
  }
  const interlume::TimeVaryingOptions options(*this, this->GetOutputPointsPrecision(), copiesSteps);
  this->Run = std::make_unique<interlume::TimeVaryingRun>(
    this,
    [this](vtkDataSet* input, int& association)
    { return this->GetInputAbstractArrayToProcess(0, input, association); },
    this->GetIntervals(), options, this->GetFirstStep(), times);
  return true;
}

int vtkTimeVaryingIntervalVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::TimeVaryingReport report;
  this->TakeStep(request, inputs, outputs, report);
  // However many steps a process takes, each comes to one end.
  const bool isEnd = !request->Has(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  if (isEnd && this->GetReportBalance())
  {
    interlume::ProcessBalance::Gather(this, report);
  }
  report.CopyTo(this->Report);
  return 1;
}

void vtkTimeVaryingIntervalVolume::TakeStep(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, interlume::TimeVaryingReport& report)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* made[NumberOfPorts];
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    made[port] = vtkDataObject::GetData(outputs, port);
  }
  this->IsFilled = false;
  if (!this->Run && this->GetNumberOfIntervals() == 0)
  {
    this->WarnOfEmptyOutput(interlume::EmptyResult().Explain(this, "no interval is set.", ""));
    return;
  }
  if (!this->Run && !this->Begin(false))
  {
    return;
  }
  interlume::TimeVaryingRun::Results result;
  const interlume::Error error = this->Run->AddStep(input, result);
  if (result == interlume::TimeVaryingRun::OVERWRITTEN)
  {
    // The values of the step before are lost: its time is asked for again.
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
    for (vtkDataObject* output : made)
    {
      interlume::TimeVaryingRun::CopyStructure(input, output);
    }
    this->IsFilled = run->FillOutputs(made[0], made[1], made[2]);
    if (!this->IsFilled)
    {
      std::for_each(
        made, made + NumberOfPorts, [](vtkDataObject* output) { output->Initialize(); });
    }
  }
  this->SetProgressShiftScale(0.0, 1.0);
  report = run->GetReport();
  report.Passes = report.Slabs;
  for (const std::string& warning : run->GetWarnings())
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
    // Another warning says that there is no time between the steps.
    return std::string();
  }
  const auto& kinds = this->GenerateBoundary;
  const bool hasBoundary = std::find(kinds.begin(), kinds.end(), true) != kinds.end();
  const bool isAsked = this->GenerateTetrahedra || this->GenerateSimplices || hasBoundary;
  const std::string why = run.GetEmptyResult().Explain(this,
    isAsked ? "" : "neither tetrahedra, nor boundaries, nor 4-simplices are asked for.",
    interlume::EmptyResult::Describe(this->GetIntervals()) + " at any time");
  if (why.empty() && this->GenerateTetrahedra && report.Simplices > 0 &&
    report.FlatSimplices == report.Simplices)
  {
    return "all " + std::to_string(report.Simplices) +
      " 4-simplices are flat along the direction of projection.";
  }
  return why;
}

void vtkTimeVaryingIntervalVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStepRange: " << this->TimeStepRange[0] << " to " << this->TimeStepRange[1]
     << "\n";
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
