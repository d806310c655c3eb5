// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Ranks/RankMeasures.h"

#include "Benchmarks/Measures/ResidentMemory.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace ranks
{
namespace
{
/// Gathers one number from each process in process 0.
std::vector<double> Gather(vtkMultiProcessController* controller, double own)
{
  std::vector<double> all(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->Gather(&own, all.data(), 1, 0);
  return controller->GetLocalProcessId() == 0 ? all : std::vector<double>();
}

void UpdatePiece(vtkMultiProcessController* controller, vtkAlgorithm* filter)
{
  filter->UpdatePiece(controller->GetLocalProcessId(), controller->GetNumberOfProcesses(), 0);
}

double GetMedian(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}
}

Times MeasureTimes(vtkMultiProcessController* controller, vtkAlgorithm* filter, int repeats,
  const std::function<double()>& getWork)
{
  UpdatePiece(controller, filter);
  std::vector<double> walls;
  std::vector<double> processors;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    filter->Modified();
    controller->Barrier();
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t ticks = std::clock();
    UpdatePiece(controller, filter);
    processors.push_back(static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC);
    const double own =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    double slowest = own;
    controller->AllReduce(&own, &slowest, 1, vtkCommunicator::MAX_OP);
    walls.push_back(slowest);
  }
  return { GetMedian(walls), repeats, Gather(controller, GetMedian(processors)),
    Gather(controller, getWork()) };
}

std::vector<double> MeasureMemory(vtkMultiProcessController* controller, vtkAlgorithm* filter)
{
  ResetPeakMemory();
  const auto before = ResidentKib();
  filter->UpdateInformation();
  UpdatePiece(controller, filter);
  const auto peak = PeakResidentKib();
  const std::vector<double> all =
    Gather(controller, before && peak ? static_cast<double>(*peak - *before) : -1.0);
  const bool isKnown = std::all_of(all.begin(), all.end(), [](double kib) { return kib >= 0.0; });
  return isKnown ? all : std::vector<double>();
}
}
