// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

double GetSteadySeconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

BenchSeconds TimeOnce(const BenchWork& work)
{
  const std::clock_t ticks = std::clock();
  const double begin = GetSteadySeconds();
  const vtkSmartPointer<vtkObjectBase> result = work();
  const double end = GetSteadySeconds();
  const double processor = static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
  return { end - begin, 1, { { { begin, end } } }, processor };
}

std::vector<BenchSeconds> MeasureAlternately(const std::vector<BenchWork>& works, int repeats)
{
  for (const BenchWork& work : works)
  {
    work();
  }
  std::vector<std::vector<BenchSeconds>> times(works.size());
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    for (std::size_t i = 0; i < works.size(); ++i)
    {
      times[i].push_back(TimeOnce(works[i]));
    }
  }
  std::vector<BenchSeconds> medians;
  for (const std::vector<BenchSeconds>& ofOne : times)
  {
    medians.push_back(MedianOf(ofOne));
  }
  return medians;
}

BenchWork WithThreads(int threads, const BenchWork& work)
{
  return [threads, work]()
  {
    // With TBB, VTK 9.6 can raise the number of threads only after Initialize() is called without
    // an argument. VTK up to 9.5 ignores a call with the same number as in the previous call, so
    // the number of processors is set in between.
    vtkSMPTools::Initialize();
    vtkSMPTools::Initialize(static_cast<int>(std::thread::hardware_concurrency()));
    vtkSMPTools::Initialize(threads);
    return work();
  };
}

BenchWork MakeRerunWork(const vtkSmartPointer<vtkAlgorithm>& filter)
{
  return [filter]()
  {
    filter->Modified();
    filter->Update();
    return filter;
  };
}

std::string ThreadsParameter(int threads)
{
  return std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

double Median(std::vector<double> numbers)
{
  if (numbers.empty())
  {
    return 0.0;
  }
  std::sort(numbers.begin(), numbers.end());
  const std::size_t midpoint = numbers.size() / 2;
  return numbers.size() % 2 == 1 ? numbers[midpoint]
                                 : 0.5 * (numbers[midpoint - 1] + numbers[midpoint]);
}

BenchSeconds MedianOf(const std::vector<double>& runs)
{
  return { Median(runs), static_cast<int>(runs.size()) };
}

BenchSeconds MedianOf(const std::vector<BenchSeconds>& runs)
{
  BenchSeconds median = MedianOf(std::vector<double>(runs.begin(), runs.end()));
  std::vector<double> processor;
  for (const BenchSeconds& run : runs)
  {
    processor.push_back(run.Processor);
    median.Spans.insert(median.Spans.end(), run.Spans.begin(), run.Spans.end());
  }
  median.Processor = Median(processor);
  return median;
}
