// SPDX-License-Identifier: BSD-3-Clause
// An implicit flow field that is stopped, by an abort and by a kill, and resumed from its
// checkpoint: the bytes of a run that was never stopped; files that are refused, and what is
// written when.
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
    { "an image, with extras and what is beyond the surface",
      [](vtkImplicitFlowField* filter)
      {
        SetFlow(filter, Flow::ABC, 12);
        filter->SetMaximumError(1e-4);
        filter->DomainFacesOn();
        filter->ComputeArcLengthOn();
        filter->ComputeMaximumSpeedOn();
        filter->ComputeMeanVorticityOn();
        filter->AddMeanArray("Pressure");
        filter->KeepStepsOn();
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
        filter->ShareStreamlinesOn();
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

/// Returns all numbers of the output.
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

/// Returns a copy of the report without the values about checkpoints, and SIMD steps, which depend
/// on who was followed beside whom.
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

/// Runs until \a progress and aborts there.
void Abort(const Case& test, const std::string& name, double progress, Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  ProgressWatch watch;
  watch.AbortAt = progress;
  Observe(filter, watch);
  filter->Update();
  check.Equal(GetOutput(filter)->GetNumberOfPoints(), 0, "samples after an abort");
  check.Equal(GetOutput(filter)->GetPointData()->GetNumberOfArrays(), 0, "arrays after an abort");
}

/// The file is a table that says what it is.
void CheckFile(const std::string& name, Check& check)
{
  vtkNew<vtkXMLTableReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  vtkTable* table = reader->GetOutput();
  check.That(table->GetFieldData()->GetArray("PartialImplicitFlow") != nullptr, "the mark");
  check.That(table->GetNumberOfRows() > 0, "finished streamlines");
  check.That(table->GetColumnByName("Position") != nullptr, "where they ended");
  check.That(!files::exists(name + ".part"), "nothing is left beside it");
}

/// Resumes by a filter of its own. Returns how many streamlines were in the file.
vtkIdType Resume(const Case& test, const std::string& name, const std::string& whole,
  vtkInterlumeReport* numbers, Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  filter->Update();
  check.That(GetBytes(filter) == whole, "the bytes of a run without a stop");
  check.That(GetNumbers(filter)->IsEqual(numbers), "and its report");
  check.That(!files::exists(name), "the file is removed when all is there");
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
      check.That(resumed > before, "more is there, the later it was stopped");
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

/// Without a name nothing is there; with one the result is the same.
void TestPay(const std::string& name, Check& check)
{
  check.SetContext("what is paid for");
  const Case test = MakeCases()[0];
  vtkNew<vtkImplicitFlowField> filter;
  check.That(filter->GetCheckpointFileName() == nullptr, "no file by default");
  check.Near(filter->GetCheckpointInterval(), 60.0, 0.0, "the interval by default");
  filter->SetCheckpointInterval(-1.0);
  check.Near(filter->GetCheckpointInterval(), 0.0, 0.0, "clamped");
  test.Set(filter);
  filter->Update();
  check.Near(filter->GetReport()->GetNumber("Checkpoints"), 0, 0.0, "files without a name");
  const std::string whole = GetBytes(filter);
  filter->SetCheckpointFileName(name.c_str());
  check.That(filter->GetCheckpointFileName() == name, "its name");
  filter->Update();
  check.That(GetBytes(filter) == whole, "the same with files");
  check.That(filter->GetReport()->GetNumber("Checkpoints") > 1, "after every part");
  check.Near(filter->GetReport()->GetNumber("ResumedStreamlines"), 0, 0.0, "nothing was there");
  filter->SetCheckpointInterval(3600.0);
  filter->Update();
  check.Near(filter->GetReport()->GetNumber("Checkpoints"), 0, 0.0, "not within the hour");
  filter->SetCheckpointFileName("");
  check.That(filter->GetCheckpointFileName() == nullptr, "none again");
  check.That(!files::exists(name), "nothing is left");
}

/// Gives the samples a part at a time, each with a file of its own.
void TestPieces(const std::string& name, Check& check)
{
  check.SetContext("pieces");
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  ProgressWatch watch;
  watch.AbortAt = 0.6;
  Observe(filter, watch);
  filter->UpdateInformation();
  filter->UpdatePiece(1, 2, 0);
  const std::string own = name.substr(0, name.size() - 4) + "_1.vtt";
  check.That(files::exists(own) && !files::exists(name), "the file of the piece");
  files::remove(own);
}

using Change = std::function<void(vtkImplicitFlowField*)>;

/// A file that is not of this execution, or not whole, is refused with \a words.
void TestRefusal(const std::string& name, const std::string& what, const std::string& words,
  const Change& change, Check& check)
{
  check.SetContext("refused: " + what);
  const Case test = MakeCases()[0];
  vtkNew<vtkImplicitFlowField> expected;
  test.Set(expected);
  change(expected);
  expected->Update();
  vtkNew<vtkImplicitFlowField> filter;
  test.Set(filter);
  change(filter);
  filter->SetCheckpointFileName(name.c_str());
  // None is due, however slow this is.
  filter->SetCheckpointInterval(3600.0);
  const std::string warning = WarningsOf(filter);
  check.That(warning.find(name) != std::string::npos, "the file's name in: " + warning);
  check.That(warning.find(words) != std::string::npos, "\"" + words + "\" in: " + warning);
  check.That(warning.find("followed anew") != std::string::npos, "what is done, in: " + warning);
  check.Near(filter->GetReport()->GetNumber("ResumedStreamlines"), 0, 0.0, "nothing of the file");
  check.That(GetBytes(filter) == GetBytes(expected), "the result without the file");
}

/// A checkpoint of other settings gives way to that of an execution that is stopped.
void TestReplaced(const std::string& name, Check& check)
{
  check.SetContext("replaced");
  const Case other{ "other settings",
    [](vtkImplicitFlowField* filter)
    {
      MakeCases()[0].Set(filter);
      filter->SetMaximumError(1e-3);
      ExpectWarnings(filter);
    } };
  vtkNew<vtkImplicitFlowField> filter;
  other.Set(filter);
  filter->Update();
  Abort(other, name, 0.5, check);
  check.That(
    Resume(other, name, GetBytes(filter), GetNumbers(filter), check) > 0, "the new one is used");
}

void TestRefusals(const std::string& name, Check& check)
{
  const auto nothing = [](vtkImplicitFlowField*) {};
  const auto getData = [](vtkImplicitFlowField* filter)
  { return vtkDataSet::SafeDownCast(filter->GetInputDataObject(0, 0)); };
  const std::vector<std::tuple<std::string, std::string, Change>> changes{
    { "another error", "MaximumError (0.0001",
      [](vtkImplicitFlowField* filter) { filter->SetMaximumError(1e-3); } },
    { "another direction", "Direction (0 there, 1 here)",
      [](vtkImplicitFlowField* filter) { filter->SetDirectionToForward(); } },
    { "other vectors", "these differ: vectors.",
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
    { "another place", "field's points",
      [&](vtkImplicitFlowField* filter)
      { vtkImageData::SafeDownCast(getData(filter))->SetOrigin(-1.0, -0.9, -0.81); } },
    { "a surface elsewhere", "these differ: surface 0.",
      [](vtkImplicitFlowField* filter)
      {
        vtkTerminationPlane::SafeDownCast(filter->GetTerminationSurface(0))
          ->SetOrigin(0.4, -3.0 - 1e-12, -3.0);
      } },
    { "a further surface", "number of surfaces (1 there, 2 here)",
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
  const std::string kept = Read(name);
  for (const auto& [what, words, change] : changes)
  {
    TestRefusal(name, what, words, change, check);
    check.That(Read(name) == kept, "the file is as it was, since none was due");
  }
  for (const double share : { 0.2, 0.6, 0.999 })
  {
    Write(name, kept.substr(0, static_cast<std::size_t>(share * static_cast<double>(kept.size()))));
    TestRefusal(name, "truncated", "damaged or not whole", nothing, check);
  }
  for (const double share : { 0.5, 0.8, 0.95 })
  {
    std::string damaged = kept;
    damaged[static_cast<std::size_t>(share * static_cast<double>(kept.size()))] ^= 1;
    Write(name, damaged);
    TestRefusal(name, "a bit is turned over", "damaged", nothing, check);
  }
  Write(name, kept);
  TestReplaced(name, check);
  Write(name, "My thesis.\n");
  TestRefusal(name, "no checkpoint", "is no checkpoint", nothing, check);
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName(name.c_str());
  filter->SetCheckpointInterval(0.0);
  check.That(!WarningsOf(filter).empty(), "a warning");
  check.Near(filter->GetReport()->GetNumber("Checkpoints"), 0, 0.0, "nothing is written");
  check.That(Read(name) == "My thesis.\n", "a file of the user's is left as it is");
  files::remove(name);
}

void TestNoFolder(Check& check)
{
  check.SetContext("no such folder");
  vtkNew<vtkImplicitFlowField> filter;
  MakeCases()[0].Set(filter);
  filter->SetCheckpointFileName("no/such/folder/flow.vtt");
  const std::string warning = WarningsOf(filter);
  check.That(warning.find("No checkpoint is written: the file no/such/folder/flow.vtt.part") !=
      std::string::npos,
    "a warning, not " + warning);
  check.That(GetOutput(filter)->GetNumberOfPoints() > 0, "the result is there");
}

constexpr double KilledAt = 0.7;

/// Ends the process in the middle of the execution, as nothing else can be done after it.
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
  std::error_code wrong;
  const files::path program = files::read_symlink("/proc/self/exe", wrong);
  if (wrong)
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
  check.That(files::exists(name), "it has left a file");
  // What one that is killed in writing leaves beside it.
  Write(name + ".part", Read(name).substr(0, 3000));
  check.That(
    Resume(test, name, GetBytes(filter), GetNumbers(filter), check) > 1000, "most is there");
  check.That(!files::exists(name + ".part"), "nothing is left beside it");
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
  TestPay(name, check);
  TestAborts(name, check);
  TestPieces(name, check);
  TestRefusals(name, check);
  TestNoFolder(check);
  TestKill(name, check);
  return check.Result();
}
