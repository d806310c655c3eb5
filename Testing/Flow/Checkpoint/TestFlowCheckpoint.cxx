// SPDX-License-Identifier: BSD-3-Clause
// Implicit flow fields whose execution is aborted or killed, and resumed from the checkpoint:
// results are bit-identical to an uninterrupted run. Also tests which files are rejected and when
// checkpoints are written.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Checks/ReferenceThreads.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLTableReader.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace
{

using namespace reference;
namespace files = std::filesystem;

struct Case
{
  std::string Name;
  std::function<void(vtkImplicitFlowField*)> Set;
};

void SetFlow(vtkImplicitFlowField* filter, int field, int points, bool isUnstructured = false)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(field);
  source->SetDimensions(points, points, points);
  source->SetBounds(-1.0, 1.0, -0.9, 1.0, -0.8, 0.7);
  source->Update();
  filter->SetInputData(source->GetOutput());
  if (isUnstructured)
  {
    vtkNew<vtkDataSetTriangleFilter> cells;
    cells->SetInputData(source->GetOutput());
    cells->Update();
    filter->SetInputData(cells->GetOutput());
  }
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(0.4, -3.0, -3.0);
  plane->SetPoint1(0.4, 3.0, -3.0);
  plane->SetPoint2(0.4, -3.0, 3.0);
  filter->AddTerminationSurface(plane);
}

std::vector<Case> MakeCases()
{
  using Flow = vtkAnalyticFlowSource;
  return {
    { "an image, with optional results and far sides",
      [](vtkImplicitFlowField* filter)
      {
        SetFlow(filter, Flow::ABC, 12);
        filter->SetMaximumError(1e-4);
        filter->DomainFacesOn();
        filter->ComputeArcLengthOn();
        filter->ComputeMaximumSpeedOn();
        filter->ComputeMeanVorticityOn();
        filter->AddMeanArray("Pressure");
        filter->StoreStepCountsOn();
        auto* data = vtkDataSet::SafeDownCast(filter->GetInputDataObject(0, 0));
        vtkNew<vtkDoubleArray> pressure;
        pressure->SetName("Pressure");
        for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
        {
          pressure->InsertNextValue(data->GetPoint(i)[0]);
        }
        data->GetPointData()->AddArray(pressure);
      } },
    { "an unstructured grid, with refinement and a mesh",
      [](vtkImplicitFlowField* filter)
      {
        SetFlow(filter, Flow::ROTATION, 11, true);
        filter->SetRefinementLevels(1);
        filter->DomainFacesOn();
        vtkNew<vtkPlaneSource> square;
        square->SetOrigin(-0.9, -0.5, -0.5);
        square->SetPoint1(-0.1, -0.5, -0.5);
        square->SetPoint2(-0.9, -0.5, 0.5);
        square->Update();
        vtkNew<vtkTerminationMesh> mesh;
        mesh->SetMesh(square->GetOutput());
        filter->AddTerminationSurface(mesh);
      } },
    { "shared streamlines",
      [](vtkImplicitFlowField* filter)
      {
        SetFlow(filter, Flow::SADDLE, 9);
        filter->DomainFacesOn();
        filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
        filter->SetSampleDimensions(17, 17, 17);
        filter->SetMaximumError(1e-3);
        filter->InterpolateStreamlinesOn();
      } },
    { "Rosenbrock's method, forward, with checks of the sampling",
      [](vtkImplicitFlowField* filter)
      {
        SetFlow(filter, Flow::NODE, 12);
        filter->DomainFacesOn();
        filter->SetDirectionToForward();
        filter->SetIntegrator(vtkImplicitFlowField::ROSENBROCK);
        filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
        filter->SetSampleDimensions(12, 12, 12);
      } },
    { "Runge and Kutta's method",
      [](vtkImplicitFlowField* filter)
      {
        SetFlow(filter, Flow::HURRICANE, 12);
        filter->SetMaximumError(1e-3);
        filter->DomainFacesOn();
        filter->SetIntegrator(vtkImplicitFlowField::RUNGE_KUTTA_4);
      } },
  };
}

vtkDataSet* GetOutput(vtkImplicitFlowField* filter)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

void AddBytes(std::string& bytes, vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      bytes += array->GetName() ? array->GetName() : "";
      bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
    }
  }
}

/// Returns the class name, points and arrays of the output as bytes.
std::string GetBytes(vtkImplicitFlowField* filter)
{
  vtkDataSet* output = GetOutput(filter);
  std::string bytes = output->GetClassName();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    bytes.append(reinterpret_cast<const char*>(output->GetPoint(i)), 3 * sizeof(double));
  }
  AddBytes(bytes, output->GetPointData());
  AddBytes(bytes, output->GetCellData());
  AddBytes(bytes, output->GetFieldData());
  return bytes;
}

/// Returns a copy of the report without values that may differ between runs: checkpoint statistics,
/// SIMD steps (which depend on how streamlines are grouped), and cached faces.
ReportCopy GetNumbers(vtkImplicitFlowField* filter)
{
  const auto report = CopyReport(filter->GetReport());
  for (const char* name : { "ResumedStreamlines", "Checkpoints", "SimdSteps", "ReusedFaceMatches" })
  {
    report->RemoveArray(name);
  }
  return report;
}

std::string Read(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

void Write(const std::string& name, const std::string& content)
{
  std::ofstream(name, std::ios::binary) << content;
}

/// Runs a filter with checkpoints and aborts it at \a progress.
void Abort(const Case& test, const std::string& name, double progress, Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  ProgressWatch watch;
  watch.AbortAt = progress;
  ObserveProgress(filter, watch);
  filter->Update();
  check.Equal(GetOutput(filter)->GetNumberOfPoints(), 0, "samples after an abort");
  check.Equal(GetOutput(filter)->GetPointData()->GetNumberOfArrays(), 0, "arrays after an abort");
}

/// Checks that the file is a table of streamlines, with the array that identifies checkpoints.
void CheckFile(const std::string& name, Check& check)
{
  vtkNew<vtkXMLTableReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  vtkTable* table = reader->GetOutput();
  check.That(
    table->GetFieldData()->GetArray("PartialImplicitFlow") != nullptr, "the identifying array");
  check.That(table->GetNumberOfRows() > 0, "finished streamlines");
  check.That(table->GetColumnByName("Position") != nullptr, "end positions");
  check.That(!files::exists(name + ".part"), "no temporary file remains");
}

/// Resumes from the file with a new filter. Returns the number of streamlines read from the file.
vtkIdType Resume(const Case& test, const std::string& name, const std::string& whole,
  vtkInterlumeReport* numbers, Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  filter->Update();
  check.That(GetBytes(filter) == whole, "the result is bit-identical to an uninterrupted run");
  check.That(
    GetNumbers(filter)->IsEqual(numbers), "the report equals the report of an uninterrupted run");
  check.That(!files::exists(name), "the file is removed on completion");
  return filter->GetReport()->GetNumber("ResumedStreamlines");
}

void TestAborts(const std::string& name, Check& check)
{
  for (const Case& test : MakeCases())
  {
    check.SetContext(test.Name);
    vtkNew<vtkImplicitFlowField> filter;
    test.Set(filter);
    filter->Update();
    const std::string whole = GetBytes(filter);
    const ReportCopy numbers = GetNumbers(filter);
    check.That(filter->GetReport()->GetNumber("Samples") > 1000, "samples");
    vtkIdType before = 0;
    for (const double progress : { 0.3, 0.6, 0.97 })
    {
      check.SetContext(test.Name + ", stopped at " + std::to_string(progress));
      Abort(test, name, progress, check);
      CheckFile(name, check);
      const vtkIdType resumed = Resume(test, name, whole, numbers, check);
      check.That(resumed > before, "a later stop resumes more streamlines");
      before = resumed;
    }
    check.SetContext(test.Name + ", stopped twice");
    Abort(test, name, 0.3, check);
    Abort(test, name, 0.6, check);
    check.That(Resume(test, name, whole, numbers, check) > 0, "resumed");
    check.SetContext(test.Name + ", other threads");
    vtkSMPTools::SetBackend("STDThread");
    SetThreads(1);
    Abort(test, name, 0.5, check);
    SetThreads(8);
    check.That(Resume(test, name, whole, numbers, check) > 0, "resumed");
  }
}

/// Checkpoints are written only if a file name is set, and do not change the result.
void TestOnRequest(const std::string& name, Check& check)
{
  check.SetContext("checkpoints on request");
  const Case test = MakeCases()[0];
  vtkNew<vtkImplicitFlowField> filter;
  check.That(filter->GetCheckpointFileName() == nullptr, "no file by default");
  check.Near(filter->GetCheckpointInterval(), 60.0, 0.0, "default interval");
  filter->SetCheckpointInterval(-1.0);
  check.Near(filter->GetCheckpointInterval(), 0.0, 0.0, "clamped");
  test.Set(filter);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Checkpoints"), 0, "files without a name");
  const std::string whole = GetBytes(filter);
  filter->SetCheckpointFileName(name.c_str());
  check.That(filter->GetCheckpointFileName() == name, "the file name");
  filter->Update();
  check.That(GetBytes(filter) == whole, "the result is unchanged");
  check.That(filter->GetReport()->GetNumber("Checkpoints") > 1, "one checkpoint per part");
  check.Equal(filter->GetReport()->GetCount("ResumedStreamlines"), 0, "no file to resume from");
  filter->SetCheckpointInterval(3600.0);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Checkpoints"), 0, "no checkpoint within the interval");
  filter->SetCheckpointFileName("");
  check.That(filter->GetCheckpointFileName() == nullptr, "the file name is cleared");
  check.That(!files::exists(name), "no file remains");
}

/// Each piece of the output has a separate checkpoint file.
void TestPieces(const std::string& name, Check& check)
{
  check.SetContext("pieces");
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  ProgressWatch watch;
  watch.AbortAt = 0.6;
  ObserveProgress(filter, watch);
  filter->UpdateInformation();
  filter->UpdatePiece(1, 2, 0);
  const std::string own = name.substr(0, name.size() - 4) + "_1.vtt";
  check.That(files::exists(own) && !files::exists(name), "the file of the piece");
  files::remove(own);
}

using Change = std::function<void(vtkImplicitFlowField*)>;

/// Checks that an invalid file, or a checkpoint with other settings or inputs, is rejected with a
/// warning that contains \a words.
void TestRejection(const std::string& name, const std::string& what, const std::string& words,
  const Change& change, Check& check)
{
  check.SetContext("rejected: " + what);
  const Case test = MakeCases()[0];
  vtkNew<vtkImplicitFlowField> expected;
  test.Set(expected);
  change(expected);
  expected->Update();
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  change(filter);
  filter->SetCheckpointFileName(name.c_str());
  // The interval is long enough that no checkpoint is written.
  filter->SetCheckpointInterval(3600.0);
  const std::string warning = WarningsOf(filter);
  check.That(warning.find(name) != std::string::npos, "the file's name in: " + warning);
  check.That(warning.find(words) != std::string::npos, "\"" + words + "\" in: " + warning);
  check.That(
    warning.find("computed again") != std::string::npos, "the consequence, in: " + warning);
  check.Equal(filter->GetReport()->GetCount("ResumedStreamlines"), 0, "no streamlines are resumed");
  check.That(GetBytes(filter) == GetBytes(expected), "the result equals the result without a file");
}

/// A checkpoint with other settings is replaced when an execution is aborted.
void TestReplaced(const std::string& name, Check& check)
{
  check.SetContext("replaced");
  const Case other{ "other settings",
    [](vtkImplicitFlowField* filter)
    {
      MakeCases()[0].Set(filter);
      filter->SetMaximumError(1e-3);
      AllowWarnings(filter);
    } };
  vtkNew<vtkImplicitFlowField> filter;
  other.Set(filter);
  filter->Update();
  Abort(other, name, 0.5, check);
  check.That(Resume(other, name, GetBytes(filter), GetNumbers(filter), check) > 0,
    "the new checkpoint is used");
}

void TestRejections(const std::string& name, Check& check)
{
  const auto nothing = [](vtkImplicitFlowField*) {};
  const auto getData = [](vtkImplicitFlowField* filter)
  { return vtkDataSet::SafeDownCast(filter->GetInputDataObject(0, 0)); };
  const std::vector<std::tuple<std::string, std::string, Change>> changes{
    { "another error", "MaximumError (0.0001",
      [](vtkImplicitFlowField* filter) { filter->SetMaximumError(1e-3); } },
    { "another direction", "Direction (0 stored, 1 now)",
      [](vtkImplicitFlowField* filter) { filter->SetDirectionToForward(); } },
    { "other vectors", "it differs in vectors.",
      [&](vtkImplicitFlowField* filter)
      {
        vtkDataArray* vectors = getData(filter)->GetPointData()->GetVectors();
        vectors->SetComponent(100, 1, vectors->GetComponent(100, 1) * (1.0 + 1e-15));
      } },
    { "another array of means", "array Pressure",
      [&](vtkImplicitFlowField* filter)
      { getData(filter)->GetPointData()->GetArray("Pressure")->SetComponent(7, 0, 3.0); } },
    { "a hidden cell", "ghost marks",
      [&](vtkImplicitFlowField* filter) {
        getData(filter)->AllocateCellGhostArray()->SetValue(100, vtkDataSetAttributes::HIDDENCELL);
      } },
    { "another position", "field's points",
      [&](vtkImplicitFlowField* filter)
      { vtkImageData::SafeDownCast(getData(filter))->SetOrigin(-1.0, -0.9, -0.81); } },
    { "a moved surface", "it differs in surface 0.",
      [](vtkImplicitFlowField* filter)
      {
        vtkTerminationPlane::SafeDownCast(filter->GetTerminationSurface(0))
          ->SetOrigin(0.4, -3.0 - 1e-12, -3.0);
      } },
    { "an additional surface", "number of surfaces (1 stored, 2 now)",
      [](vtkImplicitFlowField* filter)
      {
        vtkNew<vtkTerminationCylinder> cylinder;
        filter->AddTerminationSurface(cylinder);
      } },
    { "other samples", "samples",
      [](vtkImplicitFlowField* filter)
      { filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE); } },
  };
  Abort(MakeCases()[0], name, 0.5, check);
  const std::string original = Read(name);
  for (const auto& [what, words, change] : changes)
  {
    TestRejection(name, what, words, change, check);
    check.That(Read(name) == original, "the file is unchanged");
  }
  for (const double fraction : { 0.2, 0.6, 0.999 })
  {
    Write(name,
      original.substr(
        0, static_cast<std::size_t>(fraction * static_cast<double>(original.size()))));
    TestRejection(name, "truncated", "damaged or incomplete", nothing, check);
  }
  for (const double fraction : { 0.5, 0.8, 0.95 })
  {
    std::string damaged = original;
    damaged[static_cast<std::size_t>(fraction * static_cast<double>(original.size()))] ^= 1;
    Write(name, damaged);
    TestRejection(name, "one flipped bit", "damaged", nothing, check);
  }
  Write(name, original);
  TestReplaced(name, check);
  Write(name, "My thesis.\n");
  TestRejection(name, "not a checkpoint", "is not a checkpoint", nothing, check);
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  filter->SetCheckpointInterval(0.0);
  check.That(!WarningsOf(filter).empty(), "a warning");
  check.Equal(filter->GetReport()->GetCount("Checkpoints"), 0, "no checkpoint is written");
  check.That(Read(name) == "My thesis.\n", "a file that is not a checkpoint is not overwritten");
  files::remove(name);
}

void TestNoDirectory(Check& check)
{
  check.SetContext("directory does not exist");
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName("no/such/folder/flow.vtt");
  const std::string warning = WarningsOf(filter);
  check.That(warning.find("No checkpoint is written: the file no/such/folder/flow.vtt.part") !=
      std::string::npos,
    "a warning, found: " + warning);
  check.That(GetOutput(filter)->GetNumberOfPoints() > 0, "the result is complete");
}

constexpr double KilledAt = 0.7;

/// Observer that kills the process when the progress reaches KilledAt.
void KillAt(vtkObject*, unsigned long, void*, void* progress)
{
  if (*static_cast<double*>(progress) >= KilledAt)
  {
    std::raise(SIGKILL);
  }
}

void RunUntilKilled(const std::string& name)
{
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  filter->SetCheckpointInterval(0.0);
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(KillAt);
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
}

void TestKill(const std::string& name, Check& check)
{
  check.SetContext("killed");
  std::error_code error;
  const files::path program = files::read_symlink("/proc/self/exe", error);
  if (error)
  {
    return;
  }
  const Case test = MakeCases()[0];
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  filter->Update();
  const std::string command =
    "\"" + program.string() + "\" TestFlowCheckpoint --until-killed \"" + name + "\"";
  check.That(std::system(command.c_str()) != 0, "the process was killed");
  check.That(files::exists(name), "a file remains");
  // Simulates the temporary file of a process that was killed while writing.
  Write(name + ".part", Read(name).substr(0, 3000));
  check.That(Resume(test, name, GetBytes(filter), GetNumbers(filter), check) > 1000,
    "most streamlines are resumed");
  check.That(!files::exists(name + ".part"), "no temporary file remains");
}

}

int TestFlowCheckpoint(int argc, char* argv[])
{
  if (argc > 2 && std::strcmp(argv[1], "--until-killed") == 0)
  {
    RunUntilKilled(argv[2]);
    return EXIT_FAILURE;
  }
  Check check;
  const std::string name = (files::temp_directory_path() /
    ("TestFlowCheckpoint" + std::to_string(std::random_device()()) + ".vtt"))
                             .string();
  TestOnRequest(name, check);
  TestAborts(name, check);
  TestPieces(name, check);
  TestRejections(name, check);
  TestNoDirectory(check);
  TestKill(name, check);
  return check.Result();
}
