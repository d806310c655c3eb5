// SPDX-License-Identifier: BSD-3-Clause
// Interval volumes of many time steps that are written slab by slab: together the extraction of all
// steps, in the memory of one slab; stopped, killed and resumed, never with an index of a part.
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

/// Appends the cells of a grid, each as the numbers of its corners and its own.
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

/// All slabs are what the extraction of all steps is.
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
  check.That(range[0] == 0 && range[1] == VTK_INT_MAX, "the steps are those set");
  vtkNew<vtkTimeVaryingIntervalVolume> whole;
  SetAll(whole);
  whole->Update();
  const std::string names[] = { "vortex.vtm", "vortex_boundaries.vtm", "vortex_simplices.vtm" };
  for (int port = 0; port < 3; ++port)
  {
    std::vector<std::string> cells;
    AddCells(vtkUnstructuredGrid::SafeDownCast(whole->GetOutputDataObject(port)), cells);
    std::sort(cells.begin(), cells.end());
    check.That(cells.size() > 1000, "cells");
    check.That(ReadCells((folder / names[port]).string(), NumberOfSteps - 1, check) == cells,
      "the cells of the extraction of all steps in " + names[port]);
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

/// Writes again; \a change is made before. Returns the warnings.
std::string WriteAgain(const files::path& folder, int written, Check& check, double shift = 0.0)
{
  vtkNew<vtkTimeSlabWriter> writer;
  SetAll(writer, shift);
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  check.That(writer->Write(), "written");
  check.Equal(writer->GetNumberOfWrittenSlabs(), written, "slabs that are made");
  check.Equal(
    writer->GetNumberOfResumedSlabs(), NumberOfSteps - 1 - written, "slabs that were there");
  return observer->GetWarningMessage();
}

void TestResume(const files::path& folder, Check& check)
{
  check.SetContext("written again");
  const auto all = ReadFiles(folder);
  check.That(WriteAgain(folder, 0, check).empty(), "nothing to warn of");
  check.That(ReadFiles(folder) == all, "the same files");

  check.SetContext("a slab is missing");
  files::remove(folder / "vortex.vtm");
  files::remove(folder / "vortex" / "vortex_simplices_2.vtu");
  std::ofstream(folder / "vortex" / "vortex_2.vtu.part") << "what a killed one leaves";
  check.That(WriteAgain(folder, 1, check).empty(), "nothing to warn of");
  check.That(ReadFiles(folder) == all, "the same files");

  check.SetContext("a slab is truncated");
  const files::path slab = folder / "vortex" / "vortex_1.vtu";
  files::resize_file(slab, files::file_size(slab) / 2);
  std::string warning = WriteAgain(folder, 1, check);
  check.That(warning.find("written anew: 1.") != std::string::npos &&
      warning.find("vortex_1.vtu: it is damaged") != std::string::npos,
    "the file in " + warning);
  check.That(ReadFiles(folder) == all, "the same files");

  check.SetContext("other times");
  warning = WriteAgain(folder, NumberOfSteps - 1, check, 0.01);
  check.That(warning.find("these differ: times") != std::string::npos, "times in " + warning);
  check.That(ReadFiles(folder) != all, "other files");
  WriteAgain(folder, NumberOfSteps - 1, check);
  check.That(ReadFiles(folder) == all, "and back again");

  check.SetContext("other data");
  vtkNew<vtkTimeSlabWriter> writer;
  SetAll(writer);
  vtkAnalyticFieldSource::SafeDownCast(writer->GetInputAlgorithm())
    ->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.001);
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  writer->Write();
  check.Equal(writer->GetNumberOfResumedSlabs(), 0, "slabs of other data that are taken");
  warning = observer->GetWarningMessage();
  check.That(
    warning.find("these differ: data at time 0.5") != std::string::npos, "data in " + warning);
  WriteAgain(folder, NumberOfSteps - 1, check);
}

/// Ends at an event in the middle: the process, or the execution.
struct End
{
  int Events = 0;
  bool IsKill = false;

  static void Count(vtkObject* caller, unsigned long, void* client, void*)
  {
    auto* end = static_cast<End*>(client);
    constexpr int middle = 60;
    if (++end->Events == middle && end->IsKill)
    {
      std::raise(SIGKILL);
    }
    if (end->Events == middle)
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

/// What is left after a stop has no index, and is taken over.
void TestStop(const files::path& folder, bool isKill, Check& check)
{
  check.SetContext(isKill ? "killed" : "aborted");
  std::map<std::string, std::string> all = ReadFiles(folder);
  files::remove_all(folder / "vortex");
  if (isKill)
  {
    std::error_code wrong;
    const files::path program = files::read_symlink("/proc/self/exe", wrong);
    if (wrong)
    {
      return;
    }
    const std::string command =
      "\"" + program.string() + "\" TestTimeSlabWriter --until-killed \"" + folder.string() + "\"";
    check.That(std::system(command.c_str()) != 0, "the process was killed");
  }
  else
  {
    check.That(!WriteUntil(folder, false), "not all is written");
  }
  check.That(!files::exists(folder / "vortex.vtm"), "there is no index, not even that of before");
  int slabs = 0;
  while (files::exists(folder / "vortex" / ("vortex_simplices_" + std::to_string(slabs) + ".vtu")))
  {
    ++slabs;
  }
  check.That(slabs > 0 && slabs < NumberOfSteps - 1, "some slabs are there");
  WriteAgain(folder, NumberOfSteps - 1 - slabs, check);
  check.That(ReadFiles(folder) == all, "the files of a run without a stop");
}

/// The most memory that the process has had, in bytes; 0 where that is not told, or where
/// AddressSanitizer keeps what is freed.
double GetMostMemory()
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
  double most[3];
  for (const int steps : { 5, 21 })
  {
    vtkNew<vtkTimeSlabWriter> writer;
    Set(writer, points, steps);
    writer->SetFileName((folder / "many.vtm").string().c_str());
    check.That(writer->Write(), "written");
    most[steps == 5 ? 0 : 1] = GetMostMemory();
    files::remove_all(folder / "many");
  }
  vtkNew<vtkTimeVaryingIntervalVolume> whole;
  Set(whole, points, 21);
  whole->Update();
  most[2] = GetMostMemory();
  std::cout << "most memory in MB: 4 slabs " << 1e-6 * most[0] << ", 20 slabs " << 1e-6 * most[1]
            << ", all 20 at once " << 1e-6 * most[2] << std::endl;
  check.That(most[1] - most[0] < 0.1 * (most[2] - most[0]) || most[2] == 0.0,
    "five times as many slabs take no more memory");
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
  check.That(writer->GetFileName() == nullptr, "no name by default");
  check.That(write(writer).find("no FileName") != std::string::npos, "no name");
  writer->SetFileName((folder / "vortex.vtm").string().c_str());
  check.That(write(writer).find("no input") != std::string::npos, "no input");
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
