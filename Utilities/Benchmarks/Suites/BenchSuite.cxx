// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchSuite.h"

#include "Benchmarks/Suites/ChildProcess.h"

#include <stdexcept>

std::vector<BenchPlot> BenchSuite::MakePlots(const std::vector<BenchRow>&) const
{
  return {};
}

std::vector<BenchClaim> BenchSuite::CheckClaims(const std::vector<BenchRow>&) const
{
  return {};
}

nlohmann::ordered_json BenchSuite::RunTask(const std::string& task, const BenchOptions&) const
{
  throw std::runtime_error("the suite " + this->GetName() + " has no task " + task);
}

nlohmann::ordered_json BenchSuite::RunChild(
  const std::string& task, const BenchOptions& options) const
{
  return RunProgram(options.Program, this->GetName() + " --task " + Quoted(task), options);
}
