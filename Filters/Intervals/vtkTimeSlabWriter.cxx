// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeSlabWriter.h"

#include "Common/CellArrayConversion.h"
#include "Common/DataDigest.h"
#include "Common/Error.h"
#include "Common/Fingerprint.h"
#include "Common/AtomicFiles.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <system_error>

vtkStandardNewMacro(vtkTimeSlabWriter);

namespace
{
using namespace interlume;

/// Returns a digest of all data of a time step that the extraction uses. \a scalars is the array to
/// process, and \a criteria are the names of the arrays of criteria.
std::string GetDigest(vtkDataSet* step, vtkAbstractArray* scalars, int association,
  const std::vector<std::string>& criteria)
{
  DataDigest digest;
  digest.AddGrid(step);
  vtkPointData* points = step->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    digest.Add(std::string(array && array->GetName() ? array->GetName() : ""));
    digest.Add(array);
  }
  digest.Add(points->GetScalars());
  digest.Add(points->GetGlobalIds());
  if (association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    digest.Add(vtkDataArray::SafeDownCast(scalars));
  }
  for (const std::string& name : criteria)
  {
    const CellArrayConversion::Selection found = CellArrayConversion::FindByName(step, name);
    if (found.Association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
    {
      digest.Add(vtkDataArray::SafeDownCast(found.Array));
    }
  }
  return digest.Take();
}

std::string WriteOut(const double* numbers, int number)
{
  std::ostringstream text = Fingerprint::MakeExactStream();
  for (int i = 0; i < number; ++i)
  {
    text << (i > 0 ? " " : "") << numbers[i];
  }
  return text.str();
}

/// Sets the slab number, because the extraction of a single slab always sets it to 0.
void SetSlabNumber(vtkUnstructuredGrid* grid, std::size_t slab)
{
  if (auto* numbers = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("TimeSlab")))
  {
    numbers->Fill(static_cast<double>(slab));
  }
}
}

vtkTimeSlabWriter::vtkTimeSlabWriter()
{
  // Only one slab is in memory.
  this->SetSizeWarningLimit(0);
}

vtkTimeSlabWriter::~vtkTimeSlabWriter() = default;

void vtkTimeSlabWriter::SetFileName(const char* name)
{
  const std::string newName = name ? name : "";
  if (newName != this->FileName)
  {
    this->FileName = newName;
    this->Modified();
  }
}

const char* vtkTimeSlabWriter::GetFileName() const
{
  return this->FileName.empty() ? nullptr : this->FileName.c_str();
}

int vtkTimeSlabWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  if (vtkDataSet* step = vtkDataSet::GetData(info))
  {
    this->AddDigest(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()), step);
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}

void vtkTimeSlabWriter::AddDigest(double time, vtkDataSet* step)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkAbstractArray* scalars = CellArrayConversion::FindRequested(this, step, association);
  this->StepDigests[time] = GetDigest(step, scalars, association, this->GetCriteriaArrayNames());
}

std::vector<vtkTimeSlabWriter::Port> vtkTimeSlabWriter::GetPorts(const std::vector<bool>& kinds)
{
  const std::string stem = AtomicFiles::GetPath(this->FileName).stem().u8string();
  std::vector<Port> ports;
  if (this->GetGenerateTetrahedra())
  {
    ports.push_back({ 0, stem });
  }
  if (std::find(kinds.begin(), kinds.end(), true) != kinds.end())
  {
    ports.push_back({ 1, stem + "_boundaries" });
  }
  if (this->GetGenerateSimplices())
  {
    ports.push_back({ 2, stem + "_simplices" });
  }
  return ports;
}

std::string vtkTimeSlabWriter::GetSlabName(const Port& port, std::size_t slab, bool isInIndex) const
{
  const std::filesystem::path index = AtomicFiles::GetPath(this->FileName);
  const std::string name = port.Stem + "_" + std::to_string(slab) + ".vtu";
  const std::filesystem::path inIndex = index.stem() / AtomicFiles::GetPath(name);
  return isInIndex ? inIndex.generic_u8string() : (index.parent_path() / inIndex).u8string();
}

bool vtkTimeSlabWriter::Write()
{
  this->WrittenSlabs = 0;
  this->ResumedSlabs = 0;
  if (this->FileName.empty())
  {
    vtkErrorMacro("FileName is not set. Set the name of the index file, such as \"vortex.vtm\".");
    return false;
  }
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("No input is connected. Call SetInputConnection.");
    return false;
  }
  this->UpdateInformation();
  const std::vector<int> steps = this->GetSelectedSteps(this->GetTimeStepStride());
  if (const Error error = this->CheckTimes(steps))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  // Writing a slab changes these settings; they are restored below.
  int range[2];
  this->GetTimeStepRange(range);
  const bool warnOnEmptyOutput = this->GetWarnOnEmptyOutput();
  const vtkIdType previewCellLimit = this->GetPreviewCellLimit();
  std::vector<bool> kinds;
  for (int kind = 0; kind < NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    kinds.push_back(this->GetGenerateBoundary(kind));
  }
  this->SetWarnOnEmptyOutput(false);
  this->SetPreviewCellLimit(0);
  const Error error = this->WriteSlabs(steps, kinds);
  this->SetWarnOnEmptyOutput(warnOnEmptyOutput);
  this->SetPreviewCellLimit(previewCellLimit);
  this->SetTimeStepRange(range);
  for (int kind = 0; kind < NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    this->SetGenerateBoundary(kind, kinds[static_cast<std::size_t>(kind)]);
  }
  this->StepDigests.clear();
  if (error)
  {
    vtkErrorMacro(<< error);
  }
  return !error && !this->GetAbortExecute();
}

Error vtkTimeSlabWriter::WriteSlabs(const std::vector<int>& steps, const std::vector<bool>& kinds)
{
  const std::vector<double> times = this->GetTimes(steps);
  const std::vector<Port> ports = this->GetPorts(kinds);
  std::error_code failure;
  std::filesystem::create_directories(
    AtomicFiles::GetPath(this->GetSlabName({ 0, "" }, 0, false)).parent_path(), failure);
  for (const Port& port : ports)
  {
    AtomicFiles::Remove(this->GetIndexName(port));
  }
  int replaced = 0;
  std::string firstDifference;
  for (std::size_t slab = 0; slab + 1 < times.size() && !this->GetAbortExecute(); ++slab)
  {
    const double* slabTimes = &times[slab];
    this->SetSlab(slab, steps, kinds);
    std::string difference;
    if (this->IsWritten(ports, slab, slabTimes, difference))
    {
      ++this->ResumedSlabs;
      continue;
    }
    replaced += difference.empty() ? 0 : 1;
    firstDifference = firstDifference.empty() ? difference : firstDifference;
    if (Error error = this->WriteSlab(ports, slab, slabTimes))
    {
      return error;
    }
  }
  if (replaced > 0)
  {
    vtkWarningMacro("Damaged or outdated slabs replaced: " << replaced << ". First affected file: "
                                                           << firstDifference);
  }
  for (const Port& port : ports)
  {
    if (!this->GetAbortExecute() && !this->WriteIndex(port, times))
    {
      return Error(
        "The file " + this->GetIndexName(port) + " could not be written.", ErrorCode::File);
    }
  }
  return {};
}

void vtkTimeSlabWriter::SetSlab(
  std::size_t slab, const std::vector<int>& steps, const std::vector<bool>& kinds)
{
  const std::size_t last = steps.size() - 2;
  this->SetTimeStepRange(steps[slab], steps[slab + 1]);
  for (int kind = 0; kind < NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    const bool isAtStart =
      kind == LOWER_SURFACE_AT_START || kind == UPPER_SURFACE_AT_START || kind == VOLUME_AT_START;
    const bool isAtEnd =
      kind == LOWER_SURFACE_AT_END || kind == UPPER_SURFACE_AT_END || kind == VOLUME_AT_END;
    const bool isHere = (!isAtStart || slab == 0) && (!isAtEnd || slab == last);
    this->SetGenerateBoundary(kind, kinds[static_cast<std::size_t>(kind)] && isHere);
  }
}

Fingerprint vtkTimeSlabWriter::MakeFingerprint(std::size_t slab, const double* times)
{
  Fingerprint fingerprint(INTERLUME_VERSION);
  fingerprint.Add("slab", std::to_string(slab));
  fingerprint.Add("times", WriteOut(times, 2));
  for (int i = 0; i < this->GetNumberOfIntervals(); ++i)
  {
    double bounds[2];
    this->GetInterval(i, bounds[0], bounds[1]);
    fingerprint.Add("interval " + std::to_string(i), WriteOut(bounds, 2));
  }
  fingerprint.Add("number of intervals", std::to_string(this->GetNumberOfIntervals()));
  for (int i = 0; i < this->GetNumberOfCriteria(); ++i)
  {
    double bounds[2];
    this->GetCriterionRange(i, bounds[0], bounds[1]);
    fingerprint.Add("criterion " + std::to_string(i),
      this->GetCriterionArrayName(i) + (" " + WriteOut(bounds, 2)));
  }
  fingerprint.Add("criteria",
    std::to_string(this->GetNumberOfCriteria()) + " of operation " +
      std::to_string(this->GetCriteriaOperation()));
  double direction[4];
  this->GetProjectionDirection(direction);
  fingerprint.Add("ProjectionDirection", WriteOut(direction, 4));
  std::string kinds;
  for (int kind = 0; kind < NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    kinds += this->GetGenerateBoundary(kind) ? "1" : "0";
  }
  fingerprint.Add("GenerateBoundary", kinds);
  fingerprint.Add("OutputPointsPrecision", std::to_string(this->GetOutputPointsPrecision()));
  vtkInformation* array = this->GetInputArrayInformation(0);
  const int association = CellArrayConversion::GetAssociation(array);
  fingerprint.Add("array",
    (array->Has(vtkDataObject::FIELD_NAME()) ? std::string(array->Get(vtkDataObject::FIELD_NAME()))
                                             : std::string()) +
      (association == vtkDataObject::FIELD_ASSOCIATION_POINTS
          ? ""
          : " of association " + std::to_string(association)));
  return fingerprint;
}

void vtkTimeSlabWriter::AddSteps(Fingerprint& fingerprint, const double* times) const
{
  for (int i = 0; i < 2; ++i)
  {
    const auto found = this->StepDigests.find(times[i]);
    fingerprint.Add("data at time " + WriteOut(times + i, 1),
      found == this->StepDigests.end() ? std::string() : found->second);
  }
}

void vtkTimeSlabWriter::FindDigest(double time)
{
  if (this->StepDigests.count(time) > 0)
  {
    return;
  }
  int port = 0;
  vtkAlgorithm* source = this->GetInputAlgorithm(0, 0, port);
  source->UpdateTimeStep(time);
  if (auto* step = vtkDataSet::SafeDownCast(source->GetOutputDataObject(port)))
  {
    this->AddDigest(time, step);
  }
}

bool vtkTimeSlabWriter::IsWritten(
  const std::vector<Port>& ports, std::size_t slab, const double* times, std::string& difference)
{
  Fingerprint fingerprint = this->MakeFingerprint(slab, times);
  bool hasSteps = false;
  for (const Port& port : ports)
  {
    const std::string name = this->GetSlabName(port, slab, false);
    if (!AtomicFiles::Exists(name))
    {
      return false;
    }
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    const bool isIntact = AtomicFiles::Read(reader, name);
    vtkFieldData* data = reader->GetOutput()->GetFieldData();
    difference = isIntact ? fingerprint.Compare(data) : "it is damaged or incomplete";
    if (difference.empty() && !hasSteps)
    {
      this->StepDigests.erase(this->StepDigests.begin(), this->StepDigests.lower_bound(times[0]));
      this->FindDigest(times[0]);
      this->FindDigest(times[1]);
      this->AddSteps(fingerprint, times);
      hasSteps = true;
      difference = fingerprint.Compare(data);
    }
    if (!difference.empty())
    {
      difference = name + (isIntact ? " (it differs in " : " (") + difference + ").";
      return false;
    }
  }
  return !ports.empty();
}

Error vtkTimeSlabWriter::WriteSlab(
  const std::vector<Port>& ports, std::size_t slab, const double* times)
{
  this->StepDigests.clear();
  // The outputs of the previous slab were released, so the filter must execute again.
  this->Modified();
  this->Update();
  if (this->GetAbortExecute())
  {
    return {};
  }
  if (!this->HasFilledOutputs())
  {
    return "Slab " + std::to_string(slab) +
      " and the slabs after it were not extracted. See the errors above.";
  }
  Fingerprint fingerprint = this->MakeFingerprint(slab, times);
  this->AddSteps(fingerprint, times);
  Error error;
  for (const Port& port : ports)
  {
    auto* output = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(port.Number));
    if (!output)
    {
      return "Composite input cannot be written. Extract one block first.";
    }
    SetSlabNumber(output, slab);
    fingerprint.Write(output->GetFieldData());
    const std::string name = this->GetSlabName(port, slab, false);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(output);
    if (!AtomicFiles::Write(writer, name))
    {
      error = Error("The file " + name + " could not be written.", ErrorCode::File);
    }
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->GetOutputDataObject(port)->ReleaseData();
  }
  this->WrittenSlabs += error ? 0 : 1;
  return error;
}

std::string vtkTimeSlabWriter::GetIndexName(const Port& port) const
{
  const std::filesystem::path index = AtomicFiles::GetPath(this->FileName);
  const std::filesystem::path name = AtomicFiles::GetPath(port.Stem + index.extension().u8string());
  return (index.parent_path() / name).u8string();
}

bool vtkTimeSlabWriter::WriteIndex(const Port& port, const std::vector<double>& times) const
{
  vtkNew<vtkXMLDataElement> file;
  file->SetName("VTKFile");
  file->SetAttribute("type", "vtkMultiBlockDataSet");
  file->SetAttribute("version", "1.0");
  vtkNew<vtkXMLDataElement> blocks;
  blocks->SetName("vtkMultiBlockDataSet");
  for (std::size_t slab = 0; slab + 1 < times.size(); ++slab)
  {
    vtkNew<vtkXMLDataElement> block;
    block->SetName("DataSet");
    block->SetIntAttribute("index", static_cast<int>(slab));
    block->SetAttribute("name",
      ("time " + WriteOut(&times[slab], 1) + " to " + WriteOut(&times[slab + 1], 1)).c_str());
    block->SetAttribute("file", this->GetSlabName(port, slab, true).c_str());
    blocks->AddNestedElement(block);
  }
  file->AddNestedElement(blocks);
  const std::string name = this->GetIndexName(port);
  std::ofstream stream(AtomicFiles::GetPath(AtomicFiles::GetTemporaryName(name)));
  file->PrintXML(stream, vtkIndent());
  stream.close();
  return AtomicFiles::Finish(name, static_cast<bool>(stream));
}

void vtkTimeSlabWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "NumberOfWrittenSlabs: " << this->WrittenSlabs << "\n";
  os << indent << "NumberOfResumedSlabs: " << this->ResumedSlabs << "\n";
}
