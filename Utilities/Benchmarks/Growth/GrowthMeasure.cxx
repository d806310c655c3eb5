// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthMeasure.h"

#include "Benchmarks/Measures/ResidentMemory.h"

namespace growth
{
namespace
{
std::optional<long> MeasurePeak(const Execution& execution)
{
  const auto forget = [&]()
  {
    if (execution.Forget)
    {
      execution.Forget();
    }
  };
  execution.Fresh();
  forget();
  ForgetPeakMemory();
  const std::optional<long> before = ResidentKib();
  vtkSmartPointer<vtkObjectBase> result = execution.Fresh();
  const std::optional<long> peak = PeakResidentKib();
  return before && peak ? std::optional<long>(*peak - *before) : std::nullopt;
}

const BenchWork& GetTimed(const Execution& execution)
{
  return execution.Timed ? execution.Timed : execution.Fresh;
}
}

const char* const SizeMethod = "growth";

nlohmann::ordered_json MeasureSize(const Quantity& quantity, int size, const BenchOptions& options)
{
  const Job job = quantity.Make(size, options);
  nlohmann::ordered_json found;
  // First what is part of both, so that it is there when the whole is measured.
  if (job.Without)
  {
    if (const auto kib = MeasurePeak(*job.Without))
    {
      found["without_kib"] = *kib;
    }
    job.Without->Forget();
  }
  if (const auto kib = MeasurePeak(job.Measured))
  {
    found["kib"] = *kib;
  }
  std::vector<BenchWork> works = { GetTimed(job.Measured) };
  if (job.Without)
  {
    job.Without->Fresh();
    works.push_back(GetTimed(*job.Without));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  found["n"] = job.GetN();
  found["input_kib"] = job.InputKib;
  found["seconds"] = seconds.front().Value;
  found["processor_seconds"] = seconds.front().Processor;
  if (job.Without)
  {
    found["without_seconds"] = seconds.back().Value;
    found["without_processor_seconds"] = seconds.back().Processor;
  }
  return found;
}

BenchRow MakeSizeRow(const BenchRows& rows, const Quantity& quantity,
  const nlohmann::ordered_json& found, const BenchOptions& options)
{
  BenchRow row = rows.Make(quantity.Name, SizeMethod, found.at("n"));
  row.Seconds = { found.at("seconds").get<double>(), options.GetRepeats() };
  if (found.contains("without_seconds"))
  {
    row.Peer = "without";
    row.PeerSeconds = { found["without_seconds"].get<double>(), options.GetRepeats() };
  }
  row.Set({ { "n", found["n"] }, { "input_kib", found["input_kib"] } });
  if (found.contains("kib"))
  {
    row.Counts["kib"] = found["kib"].get<long>() - found.value("without_kib", 0L);
  }
  row.Counts["processor_seconds"] = found["processor_seconds"];
  if (found.contains("without_processor_seconds"))
  {
    row.Counts["without_processor_seconds"] = found["without_processor_seconds"];
  }
  return row;
}
}
