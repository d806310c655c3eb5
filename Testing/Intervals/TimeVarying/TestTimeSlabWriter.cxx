// SPDX-License-Identifier: BSD-3-Clause
// Interval volumes of many time steps that are written slab by slab. Together they equal the
// extraction of all steps, with the memory use of one slab. The writer may be stopped, killed and
// resumed, and never writes an index of an incomplete set.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkTimeSlabWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLMultiBlockDataReader.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
namespace files = std::filesystem;

constexpr int NumberOfSteps = 6;

void Set(vtkTimeVaryingIntervalVolume* filter, int points, int steps, double shift = 0.0)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToVortex();
  source->SetDimensions(points, points, points);
  source->SetTimeRange(0.5 + shift, 1.5 + shift);
  source->SetNumberOfTimeSteps(steps);
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetInterval(0, 0.5, 0.8);
  filter->SetInterval(1, 0.9, 2.0);
}

void SetAll(vtkTimeVaryingIntervalVolume* filter, double shift = 0.0)
{
  Set(filter, 18, NumberOfSteps, shift);
  filter->GenerateSimplicesOn();
  filter->SetGenerateBoundaries(true);
}

/// Appends the cells of a grid as text: point coordinates and cell values.
void AddCells(vtkUnstructuredGrid* grid, std::vector<std::string>& cells)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    std::string bytes;
    const auto add = [&bytes](vtkDataSetAttributes* data, vtkIdType id)
    {
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* array = data->GetArray(i);
        bytes += array->GetName();
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          const double value = array->GetComponent(id, c);
          bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
        }
      }
    };
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      bytes.append(
        reinterpret_cast<const char*>(grid->GetPoint(ids->GetId(i))), 3 * sizeof(double));
      add(grid->GetPointData(), ids->GetId(i));
    }
    add(grid->GetCellData(), cell);
    cells.push_back(bytes);
  }
}

std::vector<std::string> ReadCells(const std::string& index, unsigned int slabs, Check& check)
{
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(index.c_str());
  reader->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  check.Equal(blocks->GetNumberOfBlocks(), slabs, "slabs in " + index);
  std::vector<std::string> cells;
  for (unsigned int slab = 0; slab < blocks->GetNumberOfBlocks(); ++slab)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(slab));
    check.That(grid && grid->GetNumberOfCells() > 0, "a slab with cells");
    AddCells(grid, cells);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// Together, the slabs equal the output of a single extraction of all steps.
void TestUnion(const files::path& folder, Check& check)
{
  check.SetContext("all slabs");
  vtkNew<vtkTimeSlabWriter> writer;
  SetAll(writer);
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  check.That(writer->Write(), "written");
  check.Equal(writer->GetNumberOfWrittenSlabs(), NumberOfSteps - 1, "slabs");
  int range[2];
  writer->GetTimeStepRange(range);
  check.That(range[0] == 0 && range[1] == VTK_INT_MAX, "the range of time steps is unchanged");
  vtkNew<vtkTimeVaryingIntervalVolume> all;
  SetAll(all);
  all->Update();
  const std::string names[] = { "vortex.vtm", "vortex_boundaries.vtm", "vortex_simplices.vtm" };
  for (int port = 0; port < 3; ++port)
  {
    std::vector<std::string> cells;
    AddCells(vtkUnstructuredGrid::SafeDownCast(all->GetOutputDataObject(port)), cells);
    std::sort(cells.begin(), cells.end());
    check.That(cells.size() > 1000, "cells");
    check.That(ReadCells((folder / names[port]).string(), NumberOfSteps - 1, check) == cells,
      "the cells equal the extraction of all steps in " + names[port]);
  }
}

std::string Read(const files::path& name)
{
  std::ifstream file(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

std::map<std::string, std::string> ReadFiles(const files::path& folder)
{
  std::map<std::string, std::string> content;
  for (const auto& entry : files::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      content[entry.path().string()] = Read(entry.path());
    }
  }
  return content;
}

/// Writes all slabs again and checks how many are not reused. Returns the warnings.
std::string WriteAgain(const files::path& folder, int written, Check& check, double shift = 0.0)
{
  vtkNew<vtkTimeSlabWriter> writer;
  SetAll(writer, shift);
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  check.That(writer->Write(), "written");
  check.Equal(writer->GetNumberOfWrittenSlabs(), written, "slabs written");
  check.Equal(writer->GetNumberOfResumedSlabs(), NumberOfSteps - 1 - written, "slabs reused");
  return observer->GetWarningMessage();
}

void TestResume(const files::path& folder, Check& check)
{
  check.SetContext("written again");
  const auto all = ReadFiles(folder);
  check.That(WriteAgain(folder, 0, check).empty(), "no warnings");
  check.That(ReadFiles(folder) == all, "the files are unchanged");

  check.SetContext("a slab is missing");
  files::remove(folder / "vortex.vtm");
  files::remove(folder / "vortex" / "vortex_simplices_2.vtu");
  std::ofstream(folder / "vortex" / "vortex_2.vtu.part") << "incomplete file of a killed process";
  check.That(WriteAgain(folder, 1, check).empty(), "no warnings");
  check.That(ReadFiles(folder) == all, "the files are unchanged");

  check.SetContext("a slab is truncated");
  const files::path slab = folder / "vortex" / "vortex_1.vtu";
  files::resize_file(slab, files::file_size(slab) / 2);
  std::string warning = WriteAgain(folder, 1, check);
  check.That(warning.find("replaced: 1.") != std::string::npos &&
      warning.find("vortex_1.vtu (it is damaged") != std::string::npos,
    "the file in " + warning);
  check.That(ReadFiles(folder) == all, "the files are unchanged");

  check.SetContext("other times");
  warning = WriteAgain(folder, NumberOfSteps - 1, check, 0.01);
  check.That(warning.find("it differs in times") != std::string::npos, "times in " + warning);
  check.That(ReadFiles(folder) != all, "other files");
  WriteAgain(folder, NumberOfSteps - 1, check);
  check.That(ReadFiles(folder) == all, "the original files again");

  check.SetContext("other data");
  vtkNew<vtkTimeSlabWriter> writer;
  SetAll(writer);
  vtkAnalyticFieldSource::SafeDownCast(writer->GetInputAlgorithm())
    ->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.001);
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  writer->Write();
  check.Equal(writer->GetNumberOfResumedSlabs(), 0, "slabs of other data that are reused");
  warning = observer->GetWarningMessage();
  check.That(
    warning.find("it differs in data at time 0.5") != std::string::npos, "data in " + warning);
  WriteAgain(folder, NumberOfSteps - 1, check);

  check.SetContext("a criterion");
  vtkNew<vtkTimeSlabWriter> restricted;
  SetAll(restricted);
  restricted->GetInputAlgorithm()->Update();
  const std::string name =
    vtkDataSet::SafeDownCast(restricted->GetInputAlgorithm()->GetOutputDataObject(0))
      ->GetPointData()
      ->GetArrayName(0);
  restricted->AddCriterion(name.c_str(), -1e9, 1e9);
  restricted->SetFileName((folder / "vortex.vtm").string().c_str());
  vtkNew<vtkTest::ErrorObserver> changes;
  restricted->AddObserver(vtkCommand::WarningEvent, changes);
  restricted->Write();
  check.Equal(
    restricted->GetNumberOfResumedSlabs(), 0, "slabs without the criterion that are reused");
  warning = changes->GetWarningMessage();
  check.That(warning.find("criterion 0") != std::string::npos, "the criterion in " + warning);
  restricted->Write();
  check.Equal(
    restricted->GetNumberOfResumedSlabs(), NumberOfSteps - 1, "slabs with the same criterion");
  WriteAgain(folder, NumberOfSteps - 1, check);
}

/// Counts progress events. Halfway, kills the process or aborts the execution.
struct End
{
  int Events = 0;
  bool IsKill = false;

  static void Count(vtkObject* caller, unsigned long, void* client, void*)
  {
    auto* end = static_cast<End*>(client);
    constexpr int half = 60;
    if (++end->Events == half && end->IsKill)
    {
      std::raise(SIGKILL);
    }
    if (end->Events == half)
    {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }
};

bool WriteUntil(const files::path& folder, bool isKill)
{
  vtkNew<vtkTimeSlabWriter> writer;
  SetAll(writer);
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  End end;
  end.IsKill = isKill;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(End::Count);
  command->SetClientData(&end);
  writer->AddObserver(vtkCommand::ProgressEvent, command);
  return writer->Write();
}

/// After an interrupted execution there is no index file, and the next execution reuses the slabs
/// that were written.
void TestStop(const files::path& folder, bool isKill, Check& check)
{
  check.SetContext(isKill ? "killed" : "aborted");
  std::map<std::string, std::string> all = ReadFiles(folder);
  files::remove_all(folder / "vortex");
  if (isKill)
  {
    std::error_code error;
    const files::path program = files::read_symlink("/proc/self/exe", error);
    if (error)
    {
      return;
    }
    const std::string command =
      "\"" + program.string() + "\" TestTimeSlabWriter --until-killed \"" + folder.string() + "\"";
    check.That(std::system(command.c_str()) != 0, "the process was killed");
  }
  else
  {
    check.That(!WriteUntil(folder, false), "writing is not complete");
  }
  check.That(
    !files::exists(folder / "vortex.vtm"), "there is no index, not even the previous index");
  int slabs = 0;
  while (files::exists(folder / "vortex" / ("vortex_simplices_" + std::to_string(slabs) + ".vtu")))
  {
    ++slabs;
  }
  check.That(slabs > 0 && slabs < NumberOfSteps - 1, "some slabs exist");
  WriteAgain(folder, NumberOfSteps - 1 - slabs, check);
  check.That(ReadFiles(folder) == all, "the files equal an uninterrupted run");
}

/// Returns the peak memory of the process in bytes. Returns 0 if it is not available, or if
/// AddressSanitizer retains freed memory.
double GetPeakMemory()
{
#ifdef __SANITIZE_ADDRESS__
  return 0.0;
#else
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind("VmHWM:", 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(6));
    }
  }
  return 0.0;
#endif
}

void TestMemory(const files::path& folder, Check& check)
{
  check.SetContext("memory");
  constexpr int points = 40;
  double peak[3];
  for (const int steps : { 5, 21 })
  {
    vtkNew<vtkTimeSlabWriter> writer;
    Set(writer, points, steps);
    writer->SetFileName((folder / "many.vtm").string().c_str());
    check.That(writer->Write(), "written");
    peak[steps == 5 ? 0 : 1] = GetPeakMemory();
    files::remove_all(folder / "many");
  }
  vtkNew<vtkTimeVaryingIntervalVolume> all;
  Set(all, points, 21);
  all->Update();
  peak[2] = GetPeakMemory();
  std::cout << "peak memory in MB: 4 slabs " << 1e-6 * peak[0] << ", 20 slabs " << 1e-6 * peak[1]
            << ", all 20 in one pass " << 1e-6 * peak[2] << std::endl;
  check.That(peak[1] - peak[0] < 0.1 * (peak[2] - peak[0]) || peak[2] == 0.0,
    "five times as many slabs do not increase the memory");
}

void TestErrors(const files::path& folder, Check& check)
{
  check.SetContext("errors");
  const auto write = [](vtkTimeSlabWriter* writer)
  {
    vtkNew<vtkTest::ErrorObserver> observer;
    writer->AddObserver(vtkCommand::ErrorEvent, observer);
    return writer->Write() ? std::string() : observer->GetErrorMessage();
  };
  vtkNew<vtkTimeSlabWriter> writer;
  check.That(writer->GetFileName() == nullptr, "no file name by default");
  check.That(write(writer).find("FileName is not set") != std::string::npos, "no name");
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  check.That(write(writer).find("No input") != std::string::npos, "no input");
  Set(writer, 8, 1);
  check.That(write(writer).find("At least two time steps") != std::string::npos, "one step");
  std::ofstream(folder / "file") << "no folder";
  Set(writer, 8, 3);
  writer->SetFileName((folder / "file" / "vortex.vtm").string().c_str());
  check.That(write(writer).find("could not be written") != std::string::npos, "no folder");
}

}

int TestTimeSlabWriter(int argc, char* argv[])
{
  if (argc > 2 && std::strcmp(argv[1], "--until-killed") == 0)
  {
    WriteUntil(argv[2], true);
    return EXIT_FAILURE;
  }
  Check check;
  const files::path folder =
    files::temp_directory_path() / ("TestTimeSlabWriter" + std::to_string(std::random_device()()));
  files::create_directories(folder / "memory");
  TestMemory(folder / "memory", check);
  files::remove_all(folder / "memory");
  TestUnion(folder, check);
  TestResume(folder, check);
  TestStop(folder, false, check);
  TestStop(folder, true, check);
  TestErrors(folder, check);
  files::remove_all(folder);
  return check.Result();
}
