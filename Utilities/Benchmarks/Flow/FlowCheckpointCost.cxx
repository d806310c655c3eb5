// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/TemporaryFolder.h"

#include "vtkImplicitFlowField.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataObject.h"
#include "vtkNew.h"

#include <string>

namespace flow
{
namespace
{
/**
 * Measures the cost of checkpoints while samples are advected backward in the field HURRICANE to
 * the faces of the domain for at most 10 units of time. The baseline is the same filter without a
 * checkpoint file. Methods:
 * - `checkpoints`: the default CheckpointInterval, one minute;
 * - `checkpoints-often`: interval 0, a checkpoint whenever there is something to write and the last
 *   checkpoint took less than a tenth of the time since then.
 */
void AddCheckpointRows(const BenchOptions& options, BenchRows& rows)
{
  const int samples = options.Pick(128, 48, 8);
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::HURRICANE);
  source->SetDimensions(samples / 2, samples / 2, samples / 2);
  source->Update();
  const TemporaryFolder folder("interlume-bench-checkpoints");
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
    BenchRow row = rows.Make(
      "hurricane-" + std::to_string(samples), methods[i], ThreadsParameter(options.Threads));
    row.SetTimes(seconds[i], "without", seconds[0]);
    row.Set({ { "samples", filters[i]->GetReport()->GetCount("Samples") },
      { "written", filters[i]->GetReport()->GetCount("Checkpoints") } });
    rows.Add(row);
  }
}

std::vector<BenchClaim> CheckCheckpointClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost("checkpoints: at most 1.1 times the time without", 1.1, rows,
    [](const BenchRow& row) -> std::optional<double>
    {
      return row.Method.rfind("checkpoints", 0) == 0
        ? std::optional<double>(*row.Seconds / *row.BaselineSeconds)
        : std::nullopt;
    }) };
}
}

BenchPart MakeCheckpointPart()
{
  return { AddCheckpointRows, nullptr, CheckCheckpointClaims };
}
}
