// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Intervals/IntervalMemory.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/ResidentMemory.h"

#include "vtkIntervalVolume.h"

#include "vtkCellType.h"

#include <optional>

namespace interval
{
namespace
{
/// Loads the code and fills the tables for hexahedra in image data and in unstructured grids.
void UseOnce()
{
  const BenchData wavelet = MakeWavelet(9);
  methods::IntervalVolume(wavelet.Data, wavelet.Lower, wavelet.Upper);
  const BenchData cells = MakeRandomCells(VTK_HEXAHEDRON, 1000, 1);
  methods::IntervalVolume(cells.Data, cells.Lower, cells.Upper);
}
}

nlohmann::ordered_json MeasureMemory(
  const std::string& theCase, bool asHexahedra, const BenchOptions& options)
{
  BenchData data = MakeSpeedCase(theCase, options);
  if (asHexahedra)
  {
    data.Data = ToHexahedra(data.Data);
  }
  ForgetPeakMemory();
  const std::optional<long> fresh = ResidentKib();
  UseOnce();
  ForgetPeakMemory();
  const std::optional<long> before = ResidentKib();
  auto filter = methods::NewIntervalVolume(data.Data, data.Lower, data.Upper);
  filter->Update();
  const std::optional<long> peak = PeakResidentKib();

  nlohmann::ordered_json json;
  const auto inputKib = data.Data->GetActualMemorySize();
  json["input_kib"] = inputKib;
  json["output_kib"] = filter->GetOutput()->GetActualMemorySize();
  json["working_kib"] = filter->GetReport().WorkingBytes / 1024;
  if (fresh && before && peak)
  {
    json["peak_kib"] = static_cast<long>(inputKib) + *peak - *before;
    json["first_use_kib"] = *before - *fresh;
  }
  return json;
}

nlohmann::ordered_json MeasureFirstUse(int cellType, const BenchOptions& options)
{
  const BenchData data = MakeRandomCells(cellType, options.Pick(2000, 2000, 50), options.Seed);
  const BenchWork work = [&data]()
  { return methods::IntervalVolume(data.Data, data.Lower, data.Upper); };
  nlohmann::ordered_json json;
  json["cold"] = TimeOnce(work).Value;
  json["warm"] = TimeOnce(work).Value;
  return json;
}
}
