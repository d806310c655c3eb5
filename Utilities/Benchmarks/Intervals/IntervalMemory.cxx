// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/ResidentMemory.h"

#include "vtkIntervalVolume.h"

#include "vtkCellType.h"

#include <optional>

namespace interval
{
namespace
{
const char* const MemoryTask = "memory";
const char* const HexahedraTask = "memory-hexahedra";

/// Loads the code and fills the case tables for hexahedra in image data and in unstructured grids.
void UseOnce()
{
  const BenchData wavelet = MakeWavelet(9);
  methods::IntervalVolume(wavelet.Data, wavelet.Lower, wavelet.Upper);
  const BenchData cells = MakeRandomCells(VTK_HEXAHEDRON, 1000, 1);
  methods::IntervalVolume(cells.Data, cells.Lower, cells.Upper);
}

/**
 * Measures the memory of one extraction from the data of \a theCase, in KiB:
 * - `input_kib` and `output_kib`: sizes of the input and output;
 * - `working_kib`: as reported by the filter;
 * - `peak_kib`: the input plus the largest growth of the resident memory of this process;
 * - `first_use_kib`: the memory of tables and code, which are loaded before the extraction.
 *
 * `peak_kib` and `first_use_kib` are absent if the system does not report resident memory.
 */
nlohmann::ordered_json MeasureMemory(
  const std::string& theCase, bool asHexahedra, const BenchOptions& options)
{
  BenchData data = MakeSpeedCase(theCase, options);
  if (asHexahedra)
  {
    data.Data = ToHexahedra(data.Data);
  }
  ResetPeakMemory();
  const std::optional<long> fresh = ResidentKib();
  UseOnce();
  ResetPeakMemory();
  const std::optional<long> before = ResidentKib();
  auto filter = methods::NewIntervalVolume(data.Data, data.Lower, data.Upper);
  filter->Update();
  const std::optional<long> peak = PeakResidentKib();

  nlohmann::ordered_json json;
  const auto inputKib = data.Data->GetActualMemorySize();
  json["input_kib"] = inputKib;
  json["output_kib"] = filter->GetOutput()->GetActualMemorySize();
  json["working_kib"] = filter->GetReport()->GetCount("WorkingBytes") / 1024;
  if (fresh && before && peak)
  {
    json["peak_kib"] = static_cast<long>(inputKib) + *peak - *before;
    json["first_use_kib"] = *before - *fresh;
  }
  return json;
}

/// Adds rows for all cases. Structured data are measured as they are and as unstructured hexahedra.
void AddMemoryRows(const BenchOptions& options, BenchRows& rows)
{
  for (const BenchData& data : MakeSpeedCases(options))
  {
    const bool isGrid = data.Data->IsA("vtkUnstructuredGrid");
    for (const char* task : { MemoryTask, HexahedraTask })
    {
      if (isGrid && task == HexahedraTask)
      {
        continue;
      }
      BenchRow row = rows.Make(
        data.Case, "memory", isGrid || task == HexahedraTask ? "unstructured" : "structured");
      row.Counts = RunChild("interval", std::string(task) + " " + data.Case, options);
      if (row.Counts.contains("peak_kib"))
      {
        const double growth =
          row.Counts["peak_kib"].get<double>() - row.Counts["input_kib"].get<double>();
        row.Counts["peak_share"] = growth / row.Counts["output_kib"].get<double>();
      }
      rows.Add(row);
    }
  }
}

std::vector<BenchClaim> CheckMemoryClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost("peak memory at most the input and 1.5 times the output", 1.5, rows,
    CountOf("memory", "peak_share")) };
}
}

BenchPart MakeMemoryPart()
{
  return { AddMemoryRows, nullptr, CheckMemoryClaims,
    { { MemoryTask,
        [](const std::string& name, const BenchOptions& options)
        { return MeasureMemory(name, false, options); } },
      { HexahedraTask, [](const std::string& name, const BenchOptions& options) {
         return MeasureMemory(name, true, options);
       } } } };
}
}
