// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowCheckpointCost.h"

#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkImplicitFlowField.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataObject.h"
#include "vtkNew.h"

#include <filesystem>
#include <string>

namespace flow
{
namespace
{
/// A folder that is gone with this.
class ScratchFolder
{
public:
  ScratchFolder()
    : Path(std::filesystem::temp_directory_path() / "interlume-bench-checkpoints")
  {
    std::filesystem::create_directories(this->Path);
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path Path;
};
}

void AddCheckpointRows(const BenchOptions& options, BenchRows& rows)
{
  const int samples = options.Pick(128, 48, 8);
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::HURRICANE);
  source->SetDimensions(samples / 2, samples / 2, samples / 2);
  source->Update();
  const ScratchFolder folder;
  vtkNew<vtkImplicitFlowField> filters[3];
  std::vector<BenchWork> works;
  for (int i = 0; i < 3; ++i)
  {
    vtkImplicitFlowField* filter = filters[i];
    filter->SetInputConnection(source->GetOutputPort());
    filter->DomainFacesOn();
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    filter->SetSampleDimensions(samples, samples, samples);
    filter->SetMaximumTime(10.0);
    if (i > 0)
    {
      filter->SetCheckpointFileName((folder.Path / (std::to_string(i) + ".vtt")).string().c_str());
    }
    works.push_back(WithThreads(options.Threads,
      [filter]()
      {
        filter->Modified();
        filter->Update();
        return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
      }));
  }
  filters[2]->SetCheckpointInterval(0.0);
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  const char* const methods[] = { "", "checkpoints", "checkpoints-often" };
  for (int i = 1; i < 3; ++i)
  {
    BenchRow row = rows.Make("hurricane-" + std::to_string(samples), methods[i]);
    row.Parameter = ThreadsParameter(options.Threads);
    row.Seconds = seconds[i];
    row.Peer = "without";
    row.PeerSeconds = seconds[0];
    row.Counts["samples"] = filters[i]->GetReport().Samples;
    row.Counts["written"] = filters[i]->GetReport().Checkpoints;
    rows.Add(row);
  }
}

std::vector<BenchClaim> CheckCheckpointClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost("checkpoints: at most 1.1 times the time without", 1.1, rows,
    [](const BenchRow& row) -> std::optional<double>
    {
      return row.Method.rfind("checkpoints", 0) == 0
        ? std::optional<double>(*row.Seconds / *row.PeerSeconds)
        : std::nullopt;
    }) };
}
}
