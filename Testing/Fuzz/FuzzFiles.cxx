// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzFiles.h"

#include "FuzzRun.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTimeSlabWriter.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace fuzz
{

namespace
{

namespace files = std::filesystem;

/// A temporary directory of this process, removed when the process exits.
class Folder
{
public:
  static const files::path& Get()
  {
    static const Folder folder;
    return folder.Path;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

private:
  Folder()
    : Path(files::temp_directory_path() / ("interlume-fuzz-" + std::to_string(getpid())))
  {
    files::create_directories(this->Path);
  }
  ~Folder()
  {
    std::error_code ignored;
    files::remove_all(this->Path, ignored);
  }

  const files::path Path;
};

std::string Read(const files::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

void Write(const files::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Aborts the filter as soon as its progress exceeds one half.
void AbortHalfway(vtkObject* caller, unsigned long, void*, void*)
{
  auto* filter = vtkAlgorithm::SafeDownCast(caller);
  if (filter->GetProgress() > 0.5)
  {
    filter->SetAbortExecute(1);
  }
}

vtkSmartPointer<vtkImplicitFlowField> MakeFlow(bool hasFile)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::ABC);
  source->SetDimensions(6, 6, 6);
  source->Update();
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputData(source->GetOutput());
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  filter->SetMaximumError(1e-2);
  filter->DomainFacesOn();
  if (hasFile)
  {
    filter->SetCheckpointFileName((Folder::Get() / "flow.vtt").string().c_str());
  }
  return filter;
}

std::string MakeCheckpoint()
{
  const auto filter = MakeFlow(true);
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(AbortHalfway);
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  return Read(Folder::Get() / "flow.vtt");
}

std::string TryCheckpoint(const std::string& bytes)
{
  static const std::string expected = []()
  {
    const auto filter = MakeFlow(false);
    filter->Update();
    return BytesOf(filter);
  }();
  Write(Folder::Get() / "flow.vtt", bytes);
  const Messages messages;
  const auto filter = MakeFlow(true);
  filter->Update();
  if (BytesOf(filter) != expected)
  {
    return "the output differs from a run without a checkpoint";
  }
  return filter->GetReport()->GetNumber("ResumedStreamlines") == 0 && messages.GetText().empty()
    ? "the checkpoint was rejected without a message"
    : "";
}

std::string WriteSlabs()
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToVortex();
  source->SetDimensions(6, 6, 6);
  source->SetTimeRange(0.5, 1.5);
  source->SetNumberOfTimeSteps(3);
  vtkNew<vtkTimeSlabWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetInterval(0, 0.5, 0.8);
  writer->SetFileName((Folder::Get() / "vortex.vtm").string().c_str());
  return writer->Write() ? "" : "the writer failed to write the slabs";
}

files::path GetSlab()
{
  return Folder::Get() / "vortex" / "vortex_0.vtu";
}

std::string MakeSlab()
{
  return WriteSlabs().empty() ? Read(GetSlab()) : std::string();
}

std::string TrySlab(const std::string& bytes)
{
  static const std::string expected = MakeSlab();
  Write(GetSlab(), bytes);
  const Messages messages;
  const std::string error = WriteSlabs();
  if (!error.empty())
  {
    return error;
  }
  if (Read(GetSlab()) != expected)
  {
    return "the slab differs from a run without the file";
  }
  return bytes != expected && messages.GetText().empty() ? "the slab was replaced without a message"
                                                         : "";
}

}

const std::vector<FileKind>& GetFileKinds()
{
  static const std::vector<FileKind> kinds = { { "checkpoint", MakeCheckpoint, TryCheckpoint },
    { "slab", MakeSlab, TrySlab } };
  return kinds;
}

}
