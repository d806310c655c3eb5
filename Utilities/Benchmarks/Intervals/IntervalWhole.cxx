// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Intervals/IntervalParts.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/ResidentMemory.h"

#include "vtkIntervalVolume.h"

#include <array>
#include <optional>
#include <vector>

namespace interval
{
namespace
{
const char* const MemoryTask = "memory-whole";
const std::array<std::string, 3> Methods = { "whole-cells", "tetrahedra", "clip2" };

vtkSmartPointer<vtkUnstructuredGrid> Extract(const std::string& method, const BenchData& data)
{
  if (method == "clip2")
  {
    return methods::ClipTwice(data.Data, data.Lower, data.Upper, vtkAlgorithm::DEFAULT_PRECISION);
  }
  auto filter = methods::NewIntervalVolume(data.Data, data.Lower, data.Upper);
  filter->SetKeepWholeCells(method == "whole-cells");
  filter->Update();
  return filter->GetOutput();
}

/// A case of the suite as it is, or as unstructured hexahedra.
struct WholeCase
{
  std::string Name;
  BenchData Data;
};

std::vector<WholeCase> MakeCases(const BenchOptions& options)
{
  std::vector<WholeCase> cases;
  for (const BenchData& data : MakeSpeedCases(options))
  {
    cases.push_back({ data.Case, data });
    if (!data.Data->IsA("vtkUnstructuredGrid"))
    {
      cases.push_back({ data.Case + "-unstructured", data });
      cases.back().Data.Data = ToHexahedra(data.Data);
    }
  }
  return cases;
}

void AddWholeRow(const WholeCase& one, const BenchOptions& options, BenchRows& rows)
{
  std::vector<BenchWork> works;
  std::array<vtkIdType, 3> cells{};
  std::array<unsigned long, 3> kib{};
  std::array<nlohmann::ordered_json, 3> memory;
  for (std::size_t m = 0; m < Methods.size(); ++m)
  {
    works.push_back(WithThreads(1,
      [&, m]()
      {
        auto grid = Extract(Methods[m], one.Data);
        cells[m] = grid->GetNumberOfCells();
        kib[m] = grid->GetActualMemorySize();
        return grid;
      }));
    memory[m] = RunChild("interval", MemoryTask + (" " + Methods[m] + " " + one.Name), options);
  }
  const auto seconds = MeasureAlternately(works, options.GetRepeats());
  for (std::size_t peer = 1; peer < Methods.size(); ++peer)
  {
    BenchRow row = rows.Make(one.Name, Methods[0], ThreadsParameter(1));
    row.SetTimes(seconds[0], Methods[peer], seconds[peer]);
    row.Set({ { "threads", 1 }, { "cells", one.Data.Data->GetNumberOfCells() },
      { "output_cells", cells[0] }, { "peer_output_cells", cells[peer] }, { "output_kib", kib[0] },
      { "peer_output_kib", kib[peer] } });
    if (memory[0].contains("growth_kib") && memory[peer].contains("growth_kib"))
    {
      row.Set({ { "growth_kib", memory[0]["growth_kib"] },
        { "peer_growth_kib", memory[peer]["growth_kib"] } });
    }
    rows.Add(row);
  }
}

/**
 * Method `whole-cells`: vtkIntervalVolume with KeepWholeCells by one thread against the peers
 * `tetrahedra`, the same without, and `clip2`, which keeps whole cells too. Counts: cells and
 * KiB of each output, and the largest growth of resident memory.
 */
void AddWholeRows(const BenchOptions& options, BenchRows& rows)
{
  for (const WholeCase& one : MakeCases(options))
  {
    AddWholeRow(one, options, rows);
  }
}

/// By how much the resident memory of this process grows at most in one execution of \a task, a
/// method and a case with a space between; absent if the system cannot tell.
nlohmann::ordered_json MeasureWholeMemory(const std::string& task, const BenchOptions& options)
{
  const std::size_t space = task.find(' ');
  const std::string method = task.substr(0, space);
  nlohmann::ordered_json json;
  for (const WholeCase& one : MakeCases(options))
  {
    if (one.Name != task.substr(space + 1))
    {
      continue;
    }
    // Tables and code are not what is asked for.
    BenchData small = MakeWavelet(9);
    Extract(method, small);
    small.Data = ToHexahedra(small.Data);
    Extract(method, small);
    ForgetPeakMemory();
    const std::optional<long> before = ResidentKib();
    const auto output = Extract(method, one.Data);
    const std::optional<long> peak = PeakResidentKib();
    if (before && peak)
    {
      json["growth_kib"] = *peak - *before;
    }
  }
  return json;
}
}

BenchPart MakeWholePart()
{
  return { AddWholeRows, nullptr, nullptr, { { MemoryTask, MeasureWholeMemory } } };
}
}
