// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchSuite.h"

#include "Benchmarks/Suites/ChildProcess.h"

#include <algorithm>
#include <stdexcept>

namespace
{
/// Calls \a function on all parts that define it, and returns the concatenated results.
template <typename Item, typename Function>
std::vector<Item> Collect(
  const BenchSuite& suite, Function BenchPart::*function, const std::vector<BenchRow>& rows)
{
  std::vector<Item> all;
  for (const BenchPart& part : suite.Parts)
  {
    if (part.*function)
    {
      const std::vector<Item> some = (part.*function)(rows);
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  return all;
}
}

void BenchSuite::Run(const BenchOptions& options, BenchRows& rows) const
{
  for (const BenchPart& part : this->Parts)
  {
    if (part.AddRows)
    {
      part.AddRows(options, rows);
    }
  }
}

std::vector<BenchPlot> BenchSuite::MakePlots(const std::vector<BenchRow>& rows) const
{
  return Collect<BenchPlot>(*this, &BenchPart::MakePlots, rows);
}

std::vector<BenchClaim> BenchSuite::CheckClaims(const std::vector<BenchRow>& rows) const
{
  return Collect<BenchClaim>(*this, &BenchPart::CheckClaims, rows);
}

nlohmann::ordered_json BenchSuite::RunTask(
  const std::string& task, const BenchOptions& options) const
{
  const std::size_t space = std::min(task.find(' '), task.size());
  for (const BenchPart& part : this->Parts)
  {
    const auto found = part.Tasks.find(task.substr(0, space));
    if (found != part.Tasks.end())
    {
      return found->second(task.substr(std::min(space + 1, task.size())), options);
    }
  }
  throw std::runtime_error("The suite " + this->Name + " has no task " + task);
}

nlohmann::ordered_json RunChild(
  const std::string& suite, const std::string& task, const BenchOptions& options)
{
  return RunProgram(options.Program, suite + " --task " + QuoteForShell(task), options);
}
