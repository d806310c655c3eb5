// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitFlowField.h"

#include "Checkpoint/FlowCheckpoint.h"
#include "Checkpoint/FlowFingerprint.h"
#include "Common/AbortCheck.h"
#include "Common/ArrayCheck.h"
#include "Common/CellArrayConversion.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Common/ReportValue.h"
#include "Fields/FieldInput.h"
#include "Fields/FieldVectors.h"
#include "Numerics/SpeedScale.h"
#include "Samples/CellRefinement.h"
#include "Samples/ImplicitFlowRun.h"
#include "Samples/OutputPiece.h"
#include "Samples/DistributedSamples.h"
#include "Samples/SampleGrid.h"
#include "Streams/FlowReport.h"
#include "Streams/DistributedField.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationSurface.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>

vtkStandardNewMacro(vtkImplicitFlowField);

namespace
{
bool IsEmpty(const double bounds[6])
{
  return !(bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5]);
}

/// Returns true if streamlines of this direction end at a critical point of this type.
bool IsEnd(int type, bool isBackward)
{
  return isBackward
    ? type == vtkFlowCriticalPoints::SOURCE || type == vtkFlowCriticalPoints::SPIRAL_SOURCE
    : type == vtkFlowCriticalPoints::SINK || type == vtkFlowCriticalPoints::SPIRAL_SINK;
}

/// Reason why a field is not distributed. Points at the boundary of a piece would lack cells.
constexpr const char* CellArrayReason = "a cell array is averaged at the points";

using StatusCounts = std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES>;

void Publish(
  const interlume::FlowReport& report, const StatusCounts& initial, vtkInterlumeReport* values)
{
  report.CopyTo(values);
  interlume::ReportValue::Add(values, { { "InitialStatuses", initial } });
}

/// Returns what to do if few samples reached a surface, or an empty string.
std::string GetAdvice(const StatusCounts& counts)
{
  constexpr double few = 0.1;
  const vtkIdType inside =
    std::accumulate(counts.begin(), counts.end(), vtkIdType(0)) - counts[vtkFlowStatus::OUTSIDE];
  const vtkIdType reached = counts[vtkFlowStatus::REACHED_SURFACE];
  const vtkIdType left = counts[vtkFlowStatus::LEFT_DOMAIN];
  if (static_cast<double>(reached) >= few * static_cast<double>(inside))
  {
    return {};
  }
  return left > inside - reached - left
    ? " Most streamlines leave the field elsewhere: turn on Domain Faces, or move the surface."
    : " Most streamlines end inside the field, as in a field of gradients: turn on Domain Faces, "
      "place a surface, such as a sphere, around the region where they end, or smooth the data "
      "from which the vectors were computed.";
}

/// Returns true for image data, and rectilinear or structured grids.
bool IsStructured(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
    vtkStructuredGrid::SafeDownCast(data);
}
}

vtkImplicitFlowField::vtkImplicitFlowField()
{
  Publish(interlume::FlowReport(), {}, this->Report);
  this->Controller = vtkMultiProcessController::GetGlobalController();
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
}

vtkImplicitFlowField::~vtkImplicitFlowField() = default;

void vtkImplicitFlowField::AddTerminationSurface(vtkTerminationSurface* surface)
{
  if (surface)
  {
    this->Surfaces.emplace_back(surface);
    this->Modified();
  }
}

void vtkImplicitFlowField::RemoveTerminationSurface(vtkTerminationSurface* surface)
{
  const auto found = std::find(this->Surfaces.begin(), this->Surfaces.end(), surface);
  if (found != this->Surfaces.end())
  {
    this->Surfaces.erase(found);
    this->Modified();
  }
}

void vtkImplicitFlowField::RemoveAllTerminationSurfaces()
{
  if (!this->Surfaces.empty())
  {
    this->Surfaces.clear();
    this->Modified();
  }
}

vtkTerminationSurface* vtkImplicitFlowField::GetTerminationSurface(int i) const
{
  return i >= 0 && i < this->GetNumberOfTerminationSurfaces()
    ? this->Surfaces[static_cast<std::size_t>(i)].Get()
    : nullptr;
}

vtkTerminationSurface* vtkImplicitFlowField::GetUsedSurface(int i) const
{
  return i >= 0 && i < this->GetNumberOfUsedSurfaces()
    ? this->UsedSurfaces[static_cast<std::size_t>(i)].first.GetPointer()
    : nullptr;
}

int vtkImplicitFlowField::GetUsedSurfaceId(int i) const
{
  return i >= 0 && i < this->GetNumberOfUsedSurfaces()
    ? this->UsedSurfaces[static_cast<std::size_t>(i)].second
    : -1;
}

void vtkImplicitFlowField::SetSampleDimensions(int x, int y, int z)
{
  constexpr int maximum = 100000;
  const int dimensions[3] = { std::clamp(x, 1, maximum), std::clamp(y, 1, maximum),
    std::clamp(z, 1, maximum) };
  if (!std::equal(dimensions, dimensions + 3, this->SampleDimensions))
  {
    std::copy_n(dimensions, 3, this->SampleDimensions);
    this->Modified();
  }
}

void vtkImplicitFlowField::SetSampleData(vtkDataSet* data)
{
  this->SetInputDataInternal(1, data);
}

void vtkImplicitFlowField::AddMeanArray(const char* name)
{
  if (name && *name &&
    std::find(this->MeanArrays.begin(), this->MeanArrays.end(), name) == this->MeanArrays.end())
  {
    this->MeanArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkImplicitFlowField::RemoveAllMeanArrays()
{
  if (!this->MeanArrays.empty())
  {
    this->MeanArrays.clear();
    this->Modified();
  }
}

const char* vtkImplicitFlowField::GetMeanArrayName(int i) const
{
  return i >= 0 && i < this->GetNumberOfMeanArrays()
    ? this->MeanArrays[static_cast<std::size_t>(i)].c_str()
    : nullptr;
}

vtkCxxSetSmartPointerMacro(vtkImplicitFlowField, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkImplicitFlowField::GetController() const
{
  return this->Controller;
}

void vtkImplicitFlowField::SetCheckpointFileName(const char* name)
{
  const std::string newName = name ? name : "";
  if (newName != this->CheckpointFileName)
  {
    this->CheckpointFileName = newName;
    this->Modified();
  }
}

const char* vtkImplicitFlowField::GetCheckpointFileName() const
{
  return this->CheckpointFileName.empty() ? nullptr : this->CheckpointFileName.c_str();
}

const char* vtkImplicitFlowField::GetSummary()
{
  StatusCounts counts;
  for (std::size_t status = 0; status < counts.size(); ++status)
  {
    counts[status] = this->Report->GetCount("InitialStatuses", static_cast<int>(status));
  }
  const vtkIdType all = std::accumulate(counts.begin(), counts.end(), vtkIdType(0));
  std::ostringstream text;
  if (all > 0)
  {
    text.precision(3);
    const auto percent = [all](vtkIdType number) { return 100.0 * number / all; };
    const vtkIdType reached = counts[vtkFlowStatus::REACHED_SURFACE];
    const vtkIdType left = counts[vtkFlowStatus::LEFT_DOMAIN];
    const vtkIdType stagnated = counts[vtkFlowStatus::STAGNATED];
    const vtkIdType outside = counts[vtkFlowStatus::OUTSIDE];
    text << "Of " << all << " samples, " << percent(reached) << " % reached a surface, "
         << percent(left) << " % left the field, " << percent(stagnated) << " % stagnated, "
         << percent(all - reached - left - stagnated - outside) << " % ended otherwise";
    text << (outside > 0 ? ", and " : ".");
    if (outside > 0)
    {
      text << percent(outside) << " % are outside the field.";
    }
    text << GetAdvice(counts);
  }
  this->Summary = text.str();
  return this->Summary.c_str();
}

vtkMTimeType vtkImplicitFlowField::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& surface : this->Surfaces)
  {
    time = std::max(time, surface->GetMTime());
  }
  return time;
}

int vtkImplicitFlowField::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkImplicitFlowField::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  vtkSmartPointer<vtkDataSet> samples = this->MakeSamples(inputs);
  if (this->IsOutputUnstructured())
  {
    samples = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  if (!output || output->GetDataObjectType() != samples->GetDataObjectType())
  {
    info->Set(vtkDataObject::DATA_OBJECT(), samples);
  }
  return 1;
}

vtkSmartPointer<vtkDataSet> vtkImplicitFlowField::MakeSamples(vtkInformationVector** inputs) const
{
  vtkDataObject* samples =
    vtkDataObject::GetData(inputs[this->SampleMode == SAMPLES_OF_INPUT ? 1 : 0], 0);
  if (this->SampleMode == SAMPLES_OF_IMAGE || !samples)
  {
    return vtkSmartPointer<vtkImageData>::New();
  }
  if (interlume::FieldInput::IsComposite(samples))
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  return vtk::TakeSmartPointer(vtkDataSet::SafeDownCast(samples->NewInstance()));
}

int vtkImplicitFlowField::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  if (this->IsOutputUnstructured())
  {
    // The output is unstructured. Extents from earlier requests must not be passed to the inputs.
    info->Remove(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    info->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
    info->Remove(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT());
    info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    return this->Superclass::RequestInformation(request, inputs, outputs);
  }
  if (this->SampleMode == SAMPLES_OF_IMAGE)
  {
    const int extent[6] = { 0, this->SampleDimensions[0] - 1, 0, this->SampleDimensions[1] - 1, 0,
      this->SampleDimensions[2] - 1 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }
  const int port = this->SampleMode == SAMPLES_OF_INPUT ? 1 : 0;
  if (inputs[port]->GetNumberOfInformationObjects() > 0)
  {
    vtkInformation* samples = inputs[port]->GetInformationObject(0);
    info->CopyEntry(samples, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    if (this->SampleMode == SAMPLES_AUTOMATIC &&
      samples->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    {
      int extent[6];
      interlume::SampleGrid::GetExtent(
        samples->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), extent);
      info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    }
    if (port == 0 && samples->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    {
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    }
  }
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

int vtkImplicitFlowField::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* field = inputs[0]->GetInformationObject(0);
  interlume::Error error;
  const bool isDistributed =
    this->IsDistributed(inputs, outputs, error) && !this->IsPartitionErrorKnown();
  // Request the whole extent. The pipeline splits it by piece number and number of pieces.
  if (field->Has(Pipeline::WHOLE_EXTENT()))
  {
    field->Set(Pipeline::UPDATE_EXTENT(), field->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  // If the output needs ghost levels, so does the field: samples outside the partition get their
  // point arrays from field points there.
  const int levels =
    outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  field->Set(
    Pipeline::UPDATE_PIECE_NUMBER(), isDistributed ? this->Controller->GetLocalProcessId() : 0);
  field->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(),
    isDistributed ? this->Controller->GetNumberOfProcesses() : 1);
  const bool needsLayer = isDistributed && IsStructured(field->Get(vtkDataObject::DATA_OBJECT()));
  field->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), needsLayer ? std::max(1, levels) : 0);
  if (inputs[1]->GetNumberOfInformationObjects() == 0)
  {
    return 1;
  }
  vtkInformation* samples = inputs[1]->GetInformationObject(0);
  if (this->SampleMode == SAMPLES_OF_INPUT)
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    for (vtkInformationIntegerKey* key : { Pipeline::UPDATE_PIECE_NUMBER(),
           Pipeline::UPDATE_NUMBER_OF_PIECES(), Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS() })
    {
      samples->CopyEntry(output, key);
    }
  }
  else if (samples->Has(Pipeline::WHOLE_EXTENT()))
  {
    // The pipeline has copied the update extent of the output, which may exceed the whole extent of
    // the samples.
    samples->Set(Pipeline::UPDATE_EXTENT(), samples->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

bool vtkImplicitFlowField::IsDistributed(
  vtkInformationVector** inputs, vtkInformationVector* outputs, interlume::Error& error)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!this->Controller || this->Controller->GetNumberOfProcesses() < 2)
  {
    return false;
  }
  vtkInformation* output = outputs->GetInformationObject(0);
  vtkInformation* field = inputs[0]->GetInformationObject(0);
  vtkDataObject* data = field->Get(vtkDataObject::DATA_OBJECT());
  const auto isPlacedByVectors = [](const auto& surface) { return surface->IsPlacedByVectors(); };
  if (!interlume::RankExchange::IsPossible(this->Controller))
  {
    error = "VTK has no DIY module for these processes";
  }
  else if (output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) !=
      this->Controller->GetNumberOfProcesses() ||
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) != this->Controller->GetLocalProcessId())
  {
    error = "the requested pieces do not match the processes";
  }
  else if (IsStructured(data) &&
    !(field->Has(Pipeline::WHOLE_EXTENT()) &&
      interlume::FieldPartition::HasCells(field->Get(Pipeline::WHOLE_EXTENT()))))
  {
    error = "its extent is not three-dimensional";
  }
  else if (this->CriticalPointSpheres || this->InterpolateStreamlines)
  {
    error =
      this->CriticalPointSpheres ? "CriticalPointSpheres is on" : "InterpolateStreamlines is on";
  }
  else if (interlume::CellArrayConversion::GetAssociation(this->GetInputArrayInformation(0)) ==
    vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    error = CellArrayReason;
  }
  else if (std::any_of(this->Surfaces.begin(), this->Surfaces.end(), isPlacedByVectors))
  {
    error = "a termination surface is placed by the vectors";
  }
  return !error;
}

struct vtkImplicitFlowField::Execution
{
  Execution(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs,
    const vtkFlowSettings& settings, const interlume::CellArrayConversion& conversion)
    : Request(request)
    , Inputs(inputs)
    , Outputs(outputs)
    , Output(vtkDataSet::GetData(outputs))
    , Conversion(conversion)
    , Input(vtkDataObject::GetData(inputs[0], 0))
    , Options(settings)
  {
  }

  vtkInformation* Request;
  vtkInformationVector** Inputs;
  vtkInformationVector* Outputs;
  vtkDataSet* Output;
  interlume::CellArrayConversion Conversion;
  interlume::FieldInput Input;
  interlume::AdvectionOptions Options;

  interlume::Error Error;
  /// Reason why every process holds the whole field.
  interlume::Error PartitionError;
  /// Null unless the field is distributed.
  std::unique_ptr<interlume::DistributedField> Ranks;
  /// The whole field, possibly without arrays, and the data that this process holds.
  vtkSmartPointer<vtkDataSet> Field;
  vtkSmartPointer<vtkDataSet> Data;
  vtkDataArray* Vectors = nullptr;
  vtkSmartPointer<vtkDataSet> Samples;
  std::unique_ptr<interlume::FlowCheckpoint> Checkpoint;
  interlume::FlowReport Report;
  StatusCounts InitialStatuses{};

  vtkInformation* GetOutputInformation() const { return this->Outputs->GetInformationObject(0); }
  /// Returns the error of the first process with an error.
  interlume::Error Combine(const interlume::Error& error) const
  {
    return this->Ranks ? this->Ranks->GetExchange().FindFirst(error) : error;
  }
  /// Returns true if the partitions show that the field cannot be distributed.
  bool NeedsWholeField() const { return this->Ranks && this->Ranks->GetPartitionError(); }
  vtkIdType GetNumberOfPoints() const
  {
    return this->Ranks ? this->Ranks->GetNumberOfPoints() : this->Field->GetNumberOfPoints();
  }
};

int vtkImplicitFlowField::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  Execution execution(request, inputs, outputs, *this, { this, 3, this->MeanArrays });
  execution.Report.Executions = this->Executions;
  Publish(execution.Report, execution.InitialStatuses, this->Report);
  this->UsedSurfaces.clear();
  // Image data would otherwise retain their active scalars between executions.
  execution.Output->Initialize();
  Outcome outcome = Outcome::COMPLETE;
  for (const auto step : { &vtkImplicitFlowField::CheckInput, &vtkImplicitFlowField::FindField,
         &vtkImplicitFlowField::PrepareSamples, &vtkImplicitFlowField::FollowSamples })
  {
    outcome = outcome == Outcome::COMPLETE ? (this->*step)(execution) : outcome;
  }
  return this->Finish(execution, outcome);
}

vtkImplicitFlowField::Outcome vtkImplicitFlowField::CheckInput(Execution& execution)
{
  const bool isDistributed =
    this->IsDistributed(execution.Inputs, execution.Outputs, execution.PartitionError);
  execution.Input.SelectVectors(execution.Conversion);
  if (isDistributed)
  {
    execution.PartitionError =
      execution.Conversion.GetNames().empty() ? interlume::Error() : CellArrayReason;
    if (this->MustRequestWholeField(execution.Request, execution.PartitionError))
    {
      return Outcome::EMPTY;
    }
  }
  execution.Error = this->CheckBlocks(execution.Input);
  if (isDistributed && !execution.PartitionError)
  {
    vtkInformation* info = execution.Inputs[0]->GetInformationObject(0);
    execution.Ranks = std::make_unique<interlume::DistributedField>(this->Controller,
      IsStructured(info->Get(vtkDataObject::DATA_OBJECT()))
        ? info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())
        : nullptr);
    execution.Error =
      execution.Combine(execution.Input.HasOnlyFlatBlocks() ? interlume::Error() : execution.Error);
  }
  return execution.Error ? Outcome::FAILED : Outcome::COMPLETE;
}

vtkImplicitFlowField::Outcome vtkImplicitFlowField::FindField(Execution& execution)
{
  interlume::DistributedField* ranks = execution.Ranks.get();
  execution.Field = ranks ? execution.Input.MakePart() : execution.Input.MakeField();
  execution.Data = execution.Field;
  if (ranks)
  {
    execution.Error = ranks->SetData(execution.Field, interlume::SampleGrid::MaximumPoints,
      interlume::FieldInput::IsComposite(vtkDataObject::GetData(execution.Inputs[0], 0)));
    if (execution.Error || execution.NeedsWholeField())
    {
      return execution.Error ? Outcome::FAILED : Outcome::NEEDS_WHOLE_FIELD;
    }
    execution.Field = ranks->GetFullGrid();
    execution.Data = ranks->GetData();
  }
  if (execution.Field && execution.Field->GetNumberOfPoints() > 0)
  {
    return Outcome::COMPLETE;
  }
  // If there are several pieces, an empty one needs no warning.
  if (interlume::OutputPiece::IsEntireOutput(execution.GetOutputInformation()))
  {
    vtkWarningMacro(
      "The output is empty: the input has no points. Pass a vtkDataSet with vectors.");
  }
  return Outcome::EMPTY;
}

vtkImplicitFlowField::Outcome vtkImplicitFlowField::PrepareSamples(Execution& execution)
{
  interlume::DistributedField* ranks = execution.Ranks.get();
  const bool isSampled = this->SampleMode == SAMPLES_OF_IMAGE ||
    (this->SampleMode == SAMPLES_AUTOMATIC &&
      execution.GetNumberOfPoints() > interlume::SampleGrid::MaximumPoints);
  execution.Options.SamplingChecks = isSampled ? this->SamplingChecks : 0;
  execution.Samples = execution.Output;
  if (this->IsOutputUnstructured())
  {
    execution.Samples = this->MakeSamples(execution.Inputs);
  }
  vtkInformation* request = this->GetInputArrayInformation(0);
  const bool isInput = !ranks && execution.Input.GetDataSet().Data;
  const interlume::CellArrayConversion::Selection vectors = isInput
    ? execution.Input.GetDataSet()
    : interlume::CellArrayConversion::Selection{ execution.Data,
        interlume::CellArrayConversion::Find(request, execution.Data->GetPointData()) };
  execution.Vectors = vtkDataArray::SafeDownCast(vectors.Array);
  if (!ranks || !ranks->IsEmpty())
  {
    execution.Error = interlume::FieldVectors::CheckVectors(vectors, request);
  }
  execution.Error = execution.Combine(execution.Error);
  if (execution.Error)
  {
    return Outcome::FAILED;
  }
  execution.Error =
    this->SetSamples(execution).Then([&] { return this->PlaceSurfaces(execution); });
  // Every process reports only its own error, but all processes fail if any has one.
  const bool hasError(execution.Error);
  return (ranks ? ranks->GetExchange().IsAnywhere(hasError) : hasError) ? Outcome::FAILED
                                                                        : Outcome::COMPLETE;
}

vtkImplicitFlowField::Outcome vtkImplicitFlowField::FollowSamples(Execution& execution)
{
  this->SetProgressText("Advecting samples");
  const bool wasAborted = this->GetAbortExecute();
  if (this->CriticalPointSpheres)
  {
    this->AddSpheres(execution.Field, execution.Options);
  }
  interlume::ImplicitFlowRun run(this, execution.Options, execution.Field, execution.Vectors);
  run.SetHasHidden(execution.Input.HasHidden());
  if (this->RefinementLevels == CUT_BOUNDARY)
  {
    run.LocateBoundary();
  }
  if (execution.Ranks)
  {
    run.SetDistributedField(execution.Ranks.get());
  }
  this->OpenCheckpoint(execution);
  run.SetCheckpoint(execution.Checkpoint.get());
  execution.Error = run.Execute(execution.Samples);
  if (execution.NeedsWholeField())
  {
    return Outcome::NEEDS_WHOLE_FIELD;
  }
  execution.Report = run.GetReport();
  execution.InitialStatuses = run.GetInitialStatuses();
  this->Mesh = run.GetMesh();
  if (wasAborted || run.WasAborted() || this->GetAbortExecute())
  {
    return Outcome::ABORTED;
  }
  if (execution.Error)
  {
    return Outcome::FAILED;
  }
  if (run.GetRefinedSamples())
  {
    execution.Output->ShallowCopy(run.GetRefinedSamples());
  }
  else if (this->IsOutputUnstructured())
  {
    execution.Output->ShallowCopy(interlume::CellRefinement::MakeGrid(execution.Samples));
  }
  return Outcome::COMPLETE;
}

int vtkImplicitFlowField::Finish(Execution& execution, Outcome outcome)
{
  if (outcome != Outcome::NEEDS_WHOLE_FIELD && execution.Error)
  {
    vtkErrorMacro(<< execution.Error);
  }
  if (outcome == Outcome::NEEDS_WHOLE_FIELD)
  {
    this->UsedSurfaces.clear();
    this->RequestWholeField(execution.Request, execution.Ranks->GetPartitionError());
  }
  if (outcome != Outcome::COMPLETE)
  {
    execution.Output->Initialize();
    return outcome == Outcome::ABORTED ? interlume::AbortCheck::Leave(execution.Outputs) : 1;
  }
  if (execution.Checkpoint)
  {
    execution.Checkpoint->Remove();
  }
  execution.Report.WholeFieldReason = execution.PartitionError.GetMessage();
  execution.Report.ConvertedCellArrays = execution.Conversion.GetNames();
  execution.Report.Executions = ++this->Executions;
  Publish(execution.Report, execution.InitialStatuses, this->Report);
  execution.Output->GetPointData()->SetActiveScalars(vtkFlowStatus::TimeArray());
  if (execution.Report.Samples > 0 &&
    interlume::OutputPiece::IsEntireOutput(execution.GetOutputInformation()))
  {
    this->WarnOfField(execution.Report, execution.Vectors ? execution.Vectors->GetName() : nullptr);
    this->WarnIfNoneReached(execution.Report);
  }
  return 1;
}

bool vtkImplicitFlowField::IsPartitionErrorKnown()
{
  return this->IsRequestingWholeField ||
    (!this->PartitionError.empty() && this->PartitionErrorTime == this->GetInputTime());
}

vtkMTimeType vtkImplicitFlowField::GetInputTime()
{
  auto* executive = vtkDemandDrivenPipeline::SafeDownCast(this->GetInputExecutive(0, 0));
  return executive ? executive->GetPipelineMTime() : 0;
}

bool vtkImplicitFlowField::MustRequestWholeField(vtkInformation* request, interlume::Error& error)
{
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  if (this->IsRequestingWholeField)
  {
    this->IsRequestingWholeField = false;
    error = this->PartitionError;
    return false;
  }
  // If the input of a process was modified, its stored error is no longer valid.
  const bool isKnown = this->IsPartitionErrorKnown();
  interlume::RankExchange exchange(this->Controller);
  error = exchange.FindFirst(isKnown ? interlume::Error(this->PartitionError) : error);
  if (error && !isKnown)
  {
    this->RequestWholeField(request, error);
    return true;
  }
  return false;
}

void vtkImplicitFlowField::RequestWholeField(vtkInformation* request, const interlume::Error& error)
{
  this->PartitionError = error.GetMessage();
  this->PartitionErrorTime = this->GetInputTime();
  this->IsRequestingWholeField = true;
  request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
}

void vtkImplicitFlowField::OpenCheckpoint(Execution& execution)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (this->CheckpointFileName.empty())
  {
    return;
  }
  vtkInformation* info = execution.GetOutputInformation();
  execution.Checkpoint = std::make_unique<interlume::FlowCheckpoint>(
    interlume::FlowCheckpoint::GetPieceName(this->CheckpointFileName,
      info->Get(Pipeline::UPDATE_PIECE_NUMBER()), info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())),
    this->CheckpointInterval,
    interlume::FlowFingerprint(
      execution.Options, execution.Data, execution.Vectors, execution.Samples),
    static_cast<int>(this->MeanArrays.size()),
    [this](const std::string& warning) { vtkWarningMacro(<< warning); });
  execution.Checkpoint->Open(execution.Ranks ? &execution.Ranks->GetExchange() : nullptr);
}

void vtkImplicitFlowField::WarnOfField(const interlume::FlowReport& report, const char* vectors)
{
  if (report.NonconformingFaces > 0)
  {
    vtkWarningMacro("The mesh of the field is nonconforming at "
      << report.NonconformingFaces << " cell faces, the first of them in cell "
      << report.FirstNonconformingCell
      << ": the neighboring cell has no face with the same points. Streamlines end at these faces "
         "as at the boundary of the domain.");
  }
  if (report.FillValues > 0 && !(this->MaximumError > 0.0 && this->MinimumSpeed > 0.0))
  {
    const interlume::FillValues fill{ report.FillValues, report.FillValue, report.MaximumSpeed,
      report.SpeedScale };
    vtkWarningMacro(
      << fill.Describe(vectors,
           "These vectors do not affect the automatic MaximumError and MinimumSpeed, but "
           "streamlines still follow them."));
  }
  if (report.NonFiniteVectors > 0)
  {
    vtkWarningMacro(<< interlume::DescribeNonFinite(report.NonFiniteVectors, vectors,
                      "Streamlines end at cells with such points."));
  }
}

void vtkImplicitFlowField::WarnIfNoneReached(const interlume::FlowReport& report)
{
  if (!report.SamplesBySurface.empty())
  {
    return;
  }
  std::string ends;
  for (int status = 0; status < vtkFlowStatus::NUMBER_OF_VALUES; ++status)
  {
    const vtkIdType number = report.Statuses[static_cast<std::size_t>(status)];
    if (number > 0)
    {
      ends += std::string(ends.empty() ? "" : ", ") + vtkFlowStatus::GetName(status) + ": " +
        std::to_string(number);
    }
  }
  vtkWarningMacro("None of the " << report.Samples << " samples reached a termination surface ("
                                 << ends << "). Put a surface where the flow "
                                 << (this->Direction == BACKWARD ? "comes from" : "goes to")
                                 << ", or follow streamlines in the other direction.");
}

interlume::Error vtkImplicitFlowField::CheckBlocks(const interlume::FieldInput& input)
{
  vtkAbstractArray* first = nullptr;
  for (const interlume::FieldInput::Block& block : input.GetBlocks())
  {
    vtkAbstractArray* vectors = block.Selection.Array;
    first = first ? first : vectors;
    const interlume::Error error =
      interlume::FieldVectors::Check(block.Selection, this->GetInputArrayInformation(0))
        .Then([&] { return interlume::FieldVectors::CompareNames(first, vectors); });
    if (error)
    {
      return error.Within("Block " + std::to_string(block.FlatIndex) + " (flat index): ");
    }
  }
  return {};
}

void vtkImplicitFlowField::SetImageSamples(Execution& execution)
{
  double bounds[6];
  std::copy_n(this->SampleBounds, 6, bounds);
  if (IsEmpty(bounds))
  {
    execution.Field->GetBounds(bounds);
  }
  vtkImageData* image = vtkImageData::SafeDownCast(execution.Samples);
  double spacing[3];
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    const int intervals = this->SampleDimensions[axis] - 1;
    // A single point is at the center of the bounds.
    spacing[axis] = intervals > 0 && length > 0.0 ? length / intervals : 1.0;
    origin[axis] = intervals > 0 ? bounds[2 * axis] : bounds[2 * axis] + 0.5 * length;
  }
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  const int whole[6] = { 0, this->SampleDimensions[0] - 1, 0, this->SampleDimensions[1] - 1, 0,
    this->SampleDimensions[2] - 1 };
  int extent[6];
  this->GetExtent(execution.GetOutputInformation(), whole, extent);
  image->SetExtent(extent);
}

interlume::Error vtkImplicitFlowField::SetSamples(Execution& execution)
{
  if (this->SampleMode == SAMPLES_OF_IMAGE)
  {
    this->SetImageSamples(execution);
    return {};
  }
  vtkSmartPointer<vtkDataSet> samples;
  const int* whole = nullptr;
  bool isPiece = this->SampleMode == SAMPLES_OF_INPUT;
  if (isPiece)
  {
    samples = vtkDataSet::GetData(execution.Inputs[1]);
    if (!samples)
    {
      return "SampleMode is SAMPLES_OF_INPUT, but input port 1 has no connection. Call "
             "SetSampleConnection.";
    }
  }
  else
  {
    interlume::DistributedField* ranks = execution.Ranks.get();
    vtkSmartPointer<vtkDataSet> points = execution.Field;
    if (this->SampleMode == SAMPLES_AUTOMATIC &&
      execution.GetNumberOfPoints() > interlume::SampleGrid::MaximumPoints)
    {
      points = ranks && !vtkImageData::SafeDownCast(points)
        ? interlume::DistributedSamples::Make(*ranks)
        : interlume::SampleGrid::Make(points);
    }
    else if (ranks)
    {
      points = ranks->GetData();
      whole = ranks->GetPart().WholeExtent;
      isPiece = vtkUnstructuredGrid::SafeDownCast(points) != nullptr;
    }
    samples = execution.Input.MakeSamples(points);
  }
  if (interlume::Error error = interlume::ArrayCheck::FindLengthError(samples))
  {
    return interlume::ArrayCheck::MakeSentence(error.Within("the samples cannot be used: "));
  }
  execution.Samples->ShallowCopy(samples);
  if (!isPiece)
  {
    this->CutPiece(execution.GetOutputInformation(), whole, execution.Samples);
  }
  return {};
}

void vtkImplicitFlowField::CutPiece(
  vtkInformation* info, const int* whole, vtkDataSet* output) const
{
  if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(output))
  {
    interlume::OutputPiece::Extract(info, grid);
  }
  else if (output->GetExtentType() == VTK_3D_EXTENT)
  {
    int extent[6];
    this->GetExtent(
      info, whole ? whole : output->GetInformation()->Get(vtkDataObject::DATA_EXTENT()), extent);
    output->Crop(extent);
  }
}

void vtkImplicitFlowField::GetExtent(vtkInformation* info, const int whole[6], int extent[6]) const
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::copy_n(whole, 6, extent);
  if (this->IsOutputUnstructured())
  {
    int all[6];
    std::copy_n(whole, 6, all);
    vtkNew<vtkExtentTranslator> translator;
    translator->PieceToExtentThreadSafe(info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
      info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 0, all, extent,
      vtkExtentTranslator::BLOCK_MODE, 0);
  }
  else if (info->Has(Pipeline::UPDATE_EXTENT()))
  {
    info->Get(Pipeline::UPDATE_EXTENT(), extent);
  }
}

interlume::Error vtkImplicitFlowField::PlaceSurfaces(Execution& execution)
{
  if (this->Surfaces.empty() && !this->DomainFaces && !this->CriticalPointSpheres)
  {
    return "Streamlines have no surface to end on. Add a termination surface, or turn on "
           "DomainFaces or CriticalPointSpheres.";
  }
  for (std::size_t i = 0; i < this->Surfaces.size(); ++i)
  {
    vtkTerminationSurface* surface = this->Surfaces[i];
    interlume::Error error =
      surface->InitializeFromField(execution.Field, execution.Vectors, this->Direction == BACKWARD);
    error = error.Then([&] { return surface->Update(); });
    if (error)
    {
      return error.Within(
        "Termination surface " + std::to_string(i) + " (" + surface->GetClassName() + "): ", ".");
    }
  }
  // Automatic ids are unused ids, assigned in the order of the surfaces.
  std::set<int> usedIds;
  const auto isFree = [&usedIds](int first, int parts)
  { return usedIds.lower_bound(first) == usedIds.lower_bound(first + parts); };
  for (const auto& surface : this->Surfaces)
  {
    for (int part = 0; surface->GetId() >= 0 && part < surface->GetNumberOfParts(); ++part)
    {
      usedIds.insert(surface->GetId() + part);
    }
  }
  int next = 0;
  for (vtkTerminationSurface* surface : this->Surfaces)
  {
    int id = surface->GetId();
    if (id < 0)
    {
      const int parts = surface->GetNumberOfParts();
      while (!isFree(next, parts))
      {
        ++next;
      }
      id = next;
      next += parts;
    }
    this->UseSurface(surface, id, execution.Options);
  }
  return {};
}

void vtkImplicitFlowField::UseSurface(
  vtkTerminationSurface* surface, int id, interlume::AdvectionOptions& options)
{
  options.Surfaces.push_back({ surface, id });
  this->UsedSurfaces.emplace_back(surface, id);
}

void vtkImplicitFlowField::AddSpheres(vtkDataSet* field, interlume::AdvectionOptions& options)
{
  vtkNew<vtkFlowCriticalPoints> finder;
  finder->SetInputDataObject(field);
  // The field has the vectors at its points, even if the input has them in its cells.
  vtkNew<vtkInformation> request;
  request->Copy(this->GetInputArrayInformation(0));
  request->Set(vtkDataObject::FIELD_ASSOCIATION(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  finder->SetInputArrayToProcess(0, request);
  // Suppresses the warning about a field without critical points.
  vtkNew<vtkCallbackCommand> silence;
  finder->AddObserver(vtkCommand::WarningEvent, silence);
  finder->Update();
  vtkPolyData* points = finder->GetOutput();
  vtkDataArray* types = points->GetPointData()->GetArray("CriticalPointType");
  vtkDataArray* lengths = points->GetPointData()->GetArray("CellLength");
  int sphereId = this->CriticalPointId;
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    if (IsEnd(static_cast<int>(types->GetComponent(id, 0)), this->Direction == BACKWARD))
    {
      vtkNew<vtkTerminationSphere> sphere;
      sphere->SetCenter(points->GetPoint(id));
      sphere->SetRadius(this->CriticalPointRadius * lengths->GetComponent(id, 0));
      sphere->Update();
      this->UseSurface(sphere, sphereId++, options);
    }
  }
}

void vtkImplicitFlowField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTerminationSurfaces: " << this->Surfaces.size() << "\n";
  for (const auto& surface : this->Surfaces)
  {
    os << indent << surface->GetClassName() << ":\n";
    surface->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Controller: " << this->Controller << "\n";
  interlume::NamedValue::Print(os, indent,
    { { "DomainFaces", this->DomainFaces }, { "DomainFaceId", this->DomainFaceId },
      { "CriticalPointSpheres", this->CriticalPointSpheres },
      { "CriticalPointId", this->CriticalPointId },
      { "CriticalPointRadius", this->CriticalPointRadius }, { "SampleMode", this->SampleMode },
      { "SampleDimensions", this->SampleDimensions }, { "SampleBounds", this->SampleBounds },
      { "SamplingChecks", this->SamplingChecks }, { "Direction", this->Direction },
      { "Integrator", this->Integrator }, { "MaximumError", this->MaximumError },
      { "MaximumTime", this->MaximumTime }, { "MaximumNumberOfSteps", this->MaximumNumberOfSteps },
      { "MinimumSpeed", this->MinimumSpeed }, { "ArrivalTolerance", this->ArrivalTolerance },
      { "ComputeMaximumSpeed", this->ComputeMaximumSpeed },
      { "ComputeArcLength", this->ComputeArcLength },
      { "ComputeMeanVorticity", this->ComputeMeanVorticity },
      { "ComputeLocalAttributes", this->ComputeLocalAttributes },
      { "MeanArrays", this->MeanArrays },
      { "InterpolateStreamlines", this->InterpolateStreamlines },
      { "StoreStepCounts", this->StoreStepCounts }, { "RefinementLevels", this->RefinementLevels },
      { "UnstructuredOutput", this->UnstructuredOutput },
      { "CheckpointFileName", this->CheckpointFileName },
      { "CheckpointInterval", this->CheckpointInterval } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
