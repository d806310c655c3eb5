// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkFlowStatus.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <string>
#include <utility>

namespace flow
{
namespace
{
const char* const NewMapping = "new-mapping";

/// An implicit flow field, an inflow mapping, and two stream volumes.
class Volumes
{
public:
  explicit Volumes(int samples)
  {
    const int points = samples / 2;
    this->Source->SetField(vtkAnalyticFlowSource::HURRICANE);
    this->Source->SetDimensions(points, points, points);
    this->Source->Update();
    this->Field->SetInputConnection(this->Source->GetOutputPort());
    this->Field->DomainFacesOn();
    this->Field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    this->Field->SetSampleDimensions(samples, samples, samples);
    this->Field->SetMaximumTime(10.0);
    this->Mapping->SetInputConnection(this->Field->GetOutputPort());
    for (vtkFlowVolume* volume : { this->Full.Get(), this->Clipped.Get() })
    {
      volume->SetInputConnection(this->Mapping->GetOutputPort());
    }
    this->ChangeMapping();
    this->ChangeInterval(this->Full);
    this->ChangeInterval(this->Clipped);
    this->ChangeTimes();
  }

  /// Changes the frequency of the waves in the inflow mapping.
  void ChangeMapping()
  {
    this->IsWide = !this->IsWide;
    this->Mapping->SetFormula(vtkInflowMapping::ALL,
      this->IsWide ? "cos(12.566*u)*cos(12.566*v)" : "cos(12.6*u)*cos(12.6*v)");
  }

  void ChangeInterval(vtkFlowVolume* volume)
  {
    this->IsThick = !this->IsThick;
    volume->SetInterval(0, this->IsThick ? 0.73 : 0.731, 2.0);
  }

  void ChangeTimes()
  {
    this->IsLate = !this->IsLate;
    this->Clipped->SetTimeRange(0.0, this->IsLate ? 5.0 : 4.9);
  }

  const vtkNew<vtkImplicitFlowField> Field;
  const vtkNew<vtkFlowVolume> Full;
  const vtkNew<vtkFlowVolume> Clipped;

private:
  vtkNew<vtkAnalyticFlowSource> Source;
  vtkNew<vtkInflowMapping> Mapping;
  bool IsWide = false;
  bool IsThick = false;
  bool IsLate = false;
};

BenchSeconds AddSamples(
  const std::string& name, Volumes& volumes, const BenchOptions& options, BenchRows& rows)
{
  const BenchSeconds seconds = TimeOnce(WithThreads(options.Threads,
    [&]()
    {
      volumes.Field->Update();
      return vtkSmartPointer<vtkObjectBase>(volumes.Field->GetOutputDataObject(0));
    }));
  vtkInterlumeReport* report = volumes.Field->GetReport();
  BenchRow row = rows.Make(name, "samples", ThreadsParameter(options.Threads));
  row.Seconds = seconds;
  const vtkIdType samples = report->GetCount("Samples");
  const vtkIdType steps = report->GetCount("Steps") + report->GetCount("StiffSteps");
  row.Set(
    { { "samples", samples }, { "steps", steps }, { "lane_steps", report->GetCount("SimdSteps") },
      { "steps_per_second", static_cast<double>(steps) / seconds },
      { "microseconds_per_sample", 1e6 * seconds / static_cast<double>(samples) },
      { "reached",
        report->GetNumber("Statuses", vtkFlowStatus::REACHED_SURFACE) /
          static_cast<double>(samples) } });
  rows.Add(row);
  return seconds;
}

/// A function that changes a setting, and the stream volume to update afterward.
struct Change
{
  std::string Method;
  vtkFlowVolume* Volume;
  std::function<void()> Apply;
};

void AddChanges(const std::string& name, Volumes& volumes, const BenchSeconds& advection,
  int threads, const BenchOptions& options, BenchRows& rows)
{
  const Change changes[] = {
    { NewMapping, volumes.Full, [&]() { volumes.ChangeMapping(); } },
    { "new-interval", volumes.Full, [&]() { volumes.ChangeInterval(volumes.Full); } },
    { "new-times", volumes.Clipped, [&]() { volumes.ChangeTimes(); } },
  };
  for (const Change& change : changes)
  {
    const vtkIdType before = volumes.Field->GetReport()->GetCount("Executions");
    const auto work = WithThreads(threads,
      [&change]()
      {
        change.Apply();
        change.Volume->Update();
        return vtkSmartPointer<vtkObjectBase>(change.Volume->GetOutput());
      });
    BenchRow row = rows.Make(name, change.Method, ThreadsParameter(threads));
    row.SetTimes(
      MeasureAlternately({ work }, options.GetRepeats()).front(), "advection", advection);
    vtkInterlumeReport* report = change.Volume->GetReport();
    row.Set({ { "tetrahedra", change.Volume->GetOutput()->GetNumberOfCells() },
      { "advections", volumes.Field->GetReport()->GetCount("Executions") - before },
      { "inflow_passes", report->GetCount("InflowPasses") },
      { "time_passes", report->GetCount("TimePasses") } });
    rows.Add(row);
  }
}

/**
 * Measures stream volumes of the field HURRICANE, advected backward to the faces of the domain for
 * at most 10 units of time. The samples have twice the resolution of the field. Methods:
 * - `samples`: the advection of the samples with all threads, run once;
 * - `new-mapping`, `new-interval`, `new-times`: the update of a stream volume after changing only
 *   the inflow mapping, the interval, or the time range. The baseline `advection` is the time of
 *   `samples`. The count `advections` is the number of advections that the changes caused.
 */
void AddVolumeRows(const BenchOptions& options, BenchRows& rows)
{
  const int samples = options.Pick(128, 32, 8);
  const std::string name = "hurricane-" + std::to_string(samples);
  Volumes volumes(samples);
  const BenchSeconds advection = AddSamples(name, volumes, options, rows);
  for (const int threads : options.GetThreadCounts())
  {
    AddChanges(name, volumes, advection, threads, options, rows);
  }
}

std::vector<BenchClaim> CheckVolumeClaims(const std::vector<BenchRow>& rows)
{
  return {
    BenchClaim::AtMost("a new inflow mapping: a new volume in at most 0.5 s", 0.5, rows,
      [](const BenchRow& row) { return row.Method == NewMapping ? row.Seconds : std::nullopt; }),
    BenchClaim::AtMost("a new mapping, interval or range of times: 0 advections", 0.0, rows,
      [](const BenchRow& row) -> std::optional<double>
      {
        return row.Counts.contains("advections")
          ? std::optional<double>(row.Counts["advections"].get<double>())
          : std::nullopt;
      }),
  };
}
}

BenchPart MakeVolumePart()
{
  return { AddVolumeRows, nullptr, CheckVolumeClaims };
}
}
