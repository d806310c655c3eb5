// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthFit.h"
#include "Benchmarks/Growth/GrowthMeasure.h"
#include "Benchmarks/Growth/GrowthQuantity.h"
#include "Benchmarks/Suites/BenchSuites.h"

namespace growth
{
std::vector<Quantity> MakeQuantities(const BenchOptions& options)
{
  std::vector<Quantity> made = { MakeCells(options), MakeContour(options), MakeSimplices(options),
    MakeCellsInTime(options), MakeSteps(options), MakeWrittenSteps(options) };
  for (const tetrahedra::RenderPath& path : tetrahedra::AllRenderPaths())
  {
    made.push_back(MakeTetrahedra(options, path));
  }
  made.push_back(MakeSlices(options));
  made.push_back(MakeLights(options));
  made.push_back(MakeSamples(options));
  made.push_back(MakeThreads(options));
  return made;
}
}

namespace
{
class SuiteGrowth : public BenchSuite
{
public:
  std::string GetName() const override { return "growth"; }
  std::string GetTitle() const override
  {
    return "Run time and memory against N: fitted exponents beside theory's";
  }
  std::vector<std::string> GetDescription() const override;
  void Run(const BenchOptions& options, BenchRows& rows) const override;
  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override;
  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override;
  nlohmann::ordered_json RunTask(
    const std::string& task, const BenchOptions& options) const override;
};

std::vector<std::string> SuiteGrowth::GetDescription() const
{
  std::vector<std::string> text = {
    "growth: each size in a process of its own. The parameter is N; seconds are of executions by "
    "filters made anew, or of frames after a small turn, medians; kib is how much the resident "
    "memory grew at most in an execution or first frame by what was made anew, over the input and "
    "what was there before. It has what software OpenGL keeps, not what a graphics card does. Peer "
    "without: what is taken off both.",
    "time exponent, memory exponent: the exponent of N, the slope of a line through the logarithms "
    "by least squares, for the processor time of all threads, which excludes other programs, and "
    "the memory; least and most are theory's, the parameter states the reason. Memory below 64 KiB "
    "counts as 64 KiB."
  };
  for (const growth::Quantity& quantity : growth::MakeQuantities(BenchOptions()))
  {
    text.push_back(quantity.Name + ": " + quantity.Work + ".");
  }
  return text;
}

void SuiteGrowth::Run(const BenchOptions& options, BenchRows& rows) const
{
  for (const growth::Quantity& quantity : growth::MakeQuantities(options))
  {
    for (const int size : quantity.Sizes)
    {
      const auto found = this->RunChild(std::to_string(size) + " " + quantity.Name, options);
      rows.Add(growth::MakeSizeRow(rows, quantity, found, options));
    }
    growth::AddExponentRows(quantity, rows);
  }
}

nlohmann::ordered_json SuiteGrowth::RunTask(
  const std::string& task, const BenchOptions& options) const
{
  const std::size_t space = task.find(' ');
  for (const growth::Quantity& quantity : growth::MakeQuantities(options))
  {
    if (space != std::string::npos && task.substr(space + 1) == quantity.Name)
    {
      return growth::MeasureSize(quantity, std::stoi(task.substr(0, space)), options);
    }
  }
  return this->BenchSuite::RunTask(task, options);
}

std::vector<BenchPlot> SuiteGrowth::MakePlots(const std::vector<BenchRow>& rows) const
{
  return growth::MakeGrowthPlots(growth::MakeQuantities(BenchOptions()), rows);
}

std::vector<BenchClaim> SuiteGrowth::CheckClaims(const std::vector<BenchRow>& rows) const
{
  return growth::CheckExponents(rows);
}
}

std::unique_ptr<BenchSuite> MakeGrowthSuite()
{
  return std::make_unique<SuiteGrowth>();
}
