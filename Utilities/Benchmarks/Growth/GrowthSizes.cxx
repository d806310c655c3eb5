// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/Growth.h"
#include "Benchmarks/Measures/ResidentMemory.h"
#include "Benchmarks/Suites/BenchParts.h"

#include <stdexcept>

namespace growth
{
const char* const SizeMethod = "growth";

BenchRow MakeSizeRow(const BenchRows& rows, const Quantity& quantity,
  const nlohmann::ordered_json& found, const BenchOptions& options)
{
  BenchRow row = rows.Make(quantity.Name, SizeMethod, found.at("n"));
  row.Seconds = { found.at("seconds").get<double>(), options.GetRepeats() };
  for (const char* name : { "n", "input_kib", "kib", "processor_seconds" })
  {
    if (found.contains(name))
    {
      row.Counts[name] = found[name];
    }
  }
  return row;
}

namespace
{
const char* const Task = "size";

void AddRows(const BenchOptions& options, BenchRows& rows)
{
  for (const Quantity& quantity : MakeQuantities(options))
  {
    for (const int size : quantity.Sizes)
    {
      const std::string task = Task + (" " + std::to_string(size) + " " + quantity.Name);
      rows.Add(MakeSizeRow(rows, quantity, RunChild("growth", task, options), options));
    }
    AddExponentRows(quantity, rows);
  }
}

/// Measures costs at one size in this process, which was started for this purpose. Memory is
/// measured in the second execution, after the first has loaded code and tables.
nlohmann::ordered_json Measure(const Quantity& quantity, int size, const BenchOptions& options)
{
  const Job job = quantity.Make(size, options);
  job.Work();
  ResetPeakMemory();
  const std::optional<long> before = ResidentKib();
  const vtkSmartPointer<vtkObjectBase> result = job.Work();
  const std::optional<long> peak = PeakResidentKib();
  const BenchSeconds seconds = MeasureAlternately({ job.Work }, options.GetRepeats()).front();
  nlohmann::ordered_json found = { { "n", job.GetN() }, { "input_kib", job.InputKib },
    { "seconds", seconds.Value }, { "processor_seconds", seconds.Processor } };
  if (before && peak)
  {
    found["kib"] = *peak - *before;
  }
  return found;
}

/// Measures costs at one size. \a argument is `<size> <name of the quantity>`.
nlohmann::ordered_json MeasureSize(const std::string& argument, const BenchOptions& options)
{
  const std::size_t space = argument.find(' ');
  for (const Quantity& quantity : MakeQuantities(options))
  {
    if (space != std::string::npos && argument.substr(space + 1) == quantity.Name)
    {
      return Measure(quantity, std::stoi(argument), options);
    }
  }
  throw std::runtime_error("The suite growth has no quantity for the task: " + argument);
}
}

BenchPart MakePart()
{
  return { AddRows, nullptr, CheckExponents, { { Task, MeasureSize } } };
}
}
