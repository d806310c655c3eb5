// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthFit.h"
#include "Benchmarks/Growth/GrowthMeasure.h"
#include "Benchmarks/Growth/GrowthQuantity.h"
#include "Benchmarks/Suites/BenchSuites.h"

#include <stdexcept>

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
const char* const Task = "size";

std::vector<std::string> Describe()
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

void AddRows(const BenchOptions& options, BenchRows& rows)
{
  for (const growth::Quantity& quantity : growth::MakeQuantities(options))
  {
    for (const int size : quantity.Sizes)
    {
      const std::string task = Task + (" " + std::to_string(size) + " " + quantity.Name);
      rows.Add(growth::MakeSizeRow(rows, quantity, RunChild("growth", task, options), options));
    }
    growth::AddExponentRows(quantity, rows);
  }
}

/// \a argument is a size and the name of a quantity.
nlohmann::ordered_json MeasureSize(const std::string& argument, const BenchOptions& options)
{
  const std::size_t space = argument.find(' ');
  for (const growth::Quantity& quantity : growth::MakeQuantities(options))
  {
    if (space != std::string::npos && argument.substr(space + 1) == quantity.Name)
    {
      return growth::MeasureSize(quantity, std::stoi(argument), options);
    }
  }
  throw std::runtime_error("there is no quantity " + argument);
}

std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows)
{
  return growth::MakeGrowthPlots(growth::MakeQuantities(BenchOptions()), rows);
}
}

BenchSuite MakeGrowthSuite()
{
  return { "growth", "Run time and memory against N: fitted exponents beside theory's", Describe(),
    { { AddRows, MakePlots, growth::CheckExponents, { { Task, MeasureSize } } } } };
}
