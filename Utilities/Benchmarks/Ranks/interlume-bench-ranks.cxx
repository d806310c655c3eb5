// SPDX-License-Identifier: BSD-3-Clause
// Measures extraction and implicit flow by several processes, one thread each. To be started by
// mpiexec with 1, 2, 4, ... processes; one line of JSON for each measurement:
//   weak:   every process has as much to do, however many there are. seconds: wall time of the
//           slowest; processor_seconds: of each process; work: what each did (cells with output,
//           steps). The efficiency of weak scaling is the seconds of one process over those of n.
//   strong: the same work for any number. memory_kib: how far each process's resident memory grew.
#include "vtkAnalyticFlowSource.h"
#include "vtkImplicitFlowField.h"
#include "vtkIntervalVolume.h"

#include "vtkCommunicator.h"
#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace
{

constexpr double Period = 6.283185307179586;

/// A wave of so many periods along x, each of so many cells, and one along y and z: the same work
/// in every period.
class WaveSource : public vtkImageAlgorithm
{
public:
  static WaveSource* New();
  vtkTypeMacro(WaveSource, vtkImageAlgorithm);

  int Cells = 96;
  int Periods = 1;

protected:
  WaveSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const int extent[6] = { 0, this->Cells * this->Periods, 0, this->Cells, 0, this->Cells };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkImageData* image = vtkImageData::GetData(info);
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
    image->SetExtent(extent);
    vtkNew<vtkFloatArray> wave;
    wave->SetName("Wave");
    wave->SetNumberOfValues(image->GetNumberOfPoints());
    vtkIdType id = 0;
    const auto at = [this](int i) { return std::sin(Period * i / this->Cells); };
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          wave->SetValue(id++, static_cast<float>(at(i) * at(j) + at(j) * at(k) + at(k) * at(i)));
        }
      }
    }
    image->GetPointData()->SetScalars(wave);
    return 1;
  }
};
vtkStandardNewMacro(WaveSource);

/// What Linux tells of this process, in KiB; 0 elsewhere.
double GetMemory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind(name + ":", 0) == 0)
    {
      return std::stod(line.substr(name.size() + 1));
    }
  }
  return 0.0;
}

/// A number of every process, in the first one.
std::string Gather(vtkMultiProcessController* controller, double own)
{
  std::vector<double> all(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->Gather(&own, all.data(), 1, 0);
  std::string text = "[";
  for (const double number : all)
  {
    text += (text.size() > 1 ? ", " : "") + std::to_string(number);
  }
  return text + "]";
}

void Print(vtkMultiProcessController* controller, const std::string& name,
  const std::vector<std::pair<std::string, std::string>>& values)
{
  if (controller->GetLocalProcessId() == 0)
  {
    std::cout << "{\"case\": \"" << name
              << "\", \"processes\": " << controller->GetNumberOfProcesses()
              << ", \"cores\": " << std::thread::hardware_concurrency();
    for (const auto& value : values)
    {
      std::cout << ", \"" << value.first << "\": " << value.second;
    }
    std::cout << "}" << std::endl;
  }
}

/// Times the executions of a filter whose input is there, and takes the median.
void MeasureTime(vtkMultiProcessController* controller, const std::string& name,
  vtkAlgorithm* filter, int repeats, const std::function<double()>& getWork)
{
  const auto update = [&]()
  {
    filter->Modified();
    filter->UpdatePiece(controller->GetLocalProcessId(), controller->GetNumberOfProcesses(), 0);
  };
  update();
  std::vector<double> walls;
  std::vector<double> processors;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    controller->Barrier();
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t ticks = std::clock();
    update();
    processors.push_back(static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC);
    const double own =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    double slowest = own;
    controller->AllReduce(&own, &slowest, 1, vtkCommunicator::MAX_OP);
    walls.push_back(slowest);
  }
  for (std::vector<double>* times : { &walls, &processors })
  {
    std::sort(times->begin(), times->end());
  }
  const std::size_t middle = walls.size() / 2;
  const std::string processor = Gather(controller, processors[middle]);
  const std::string work = Gather(controller, getWork());
  Print(controller, name,
    { { "seconds", std::to_string(walls[middle]) }, { "processor_seconds", processor },
      { "work", work } });
}

/// Tells how far memory grows while a filter and its input are executed for the first time.
void MeasureMemory(
  vtkMultiProcessController* controller, const std::string& name, vtkAlgorithm* filter)
{
  const double before = GetMemory("VmRSS");
  filter->UpdateInformation();
  filter->UpdatePiece(controller->GetLocalProcessId(), controller->GetNumberOfProcesses(), 0);
  Print(controller, name, { { "memory_kib", Gather(controller, GetMemory("VmHWM") - before) } });
}

vtkSmartPointer<vtkIntervalVolume> MakeVolume(int cells, int periods)
{
  vtkNew<WaveSource> source;
  source->Cells = cells;
  source->Periods = periods;
  auto volume = vtkSmartPointer<vtkIntervalVolume>::New();
  volume->SetInputConnection(source->GetOutputPort());
  volume->SetInterval(0, 0.3, 0.7);
  volume->SetUseValueIndex(false);
  volume->UpdateInformation();
  return volume;
}

/// The ABC flow, which is periodic, for a time in which no streamline goes far: the same work in
/// every period.
vtkSmartPointer<vtkImplicitFlowField> MakeFlow(int points, int periods, int samples)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::ABC);
  source->SetOutputScalarType(VTK_FLOAT);
  source->SetDimensions(points * periods, points, points);
  source->SetBounds(0.0, Period * periods, 0.0, Period, 0.0, Period);
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetDomainFaces(true);
  filter->SetMaximumTime(2.0);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(samples * periods, samples, samples);
  filter->UpdateInformation();
  return filter;
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  vtkSMPTools::Initialize(1);
  const bool isQuick = argc > 1 && std::string(argv[1]) == "--quick";
  const int ranks = controller->GetNumberOfProcesses();
  const int repeats = isQuick ? 3 : 7;
  // Memory first, while none was given back by anything else.
  MeasureMemory(controller, "strong, flow", MakeFlow(isQuick ? 61 : 201, 1, 8));
  MeasureMemory(controller, "strong, extraction", MakeVolume(isQuick ? 64 : 160, 1));
  const auto volume = MakeVolume(isQuick ? 48 : 96, ranks);
  MeasureTime(controller, "weak, extraction", volume, repeats,
    [&volume]() { return static_cast<double>(volume->GetReport().CellsWithOutput); });
  const auto flow = MakeFlow(isQuick ? 24 : 64, ranks, isQuick ? 16 : 32);
  MeasureTime(controller, "weak, flow", flow, repeats,
    [&]()
    {
      const vtkFlowReport& report = flow->GetReport();
      const auto rank = static_cast<std::size_t>(controller->GetLocalProcessId());
      return static_cast<double>(
        rank < report.StepsOfRanks.size() ? report.StepsOfRanks[rank] : report.Steps);
    });
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return EXIT_SUCCESS;
}
