// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowSharing.h"

#include "Benchmarks/Flow/FlowFields.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace flow
{
namespace
{
const char* const Shared = "shared";
constexpr double Half = 0.8;

/// The case with samples on an image, which have the place of seeds.
Case OnImage(const Case& what, vtkImageData* samples)
{
  Case own = what;
  own.Seeds = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(samples->GetPoint(i));
  }
  own.Seeds->SetPoints(points);
  return own;
}

BenchWork MakeWork(vtkImplicitFlowField* filter)
{
  return [filter]()
  {
    filter->Modified();
    filter->Update();
    return vtkSmartPointer<vtkObjectBase>(filter);
  };
}

/// The share of the answers that are the same within an error per unit of time.
double GetShareWithin(const Answer& one, const Answer& other, double error, double speed)
{
  vtkIdType within = 0;
  for (std::size_t i = 0; i < one.Ends.size(); ++i)
  {
    const End& a = one.Ends[i];
    const End& b = other.Ends[i];
    const double distance = a.HasAnswer && b.HasAnswer
      ? std::hypot(a.Place[0] - b.Place[0], a.Place[1] - b.Place[1], a.Place[2] - b.Place[2])
      : 0.0;
    const double most = error * a.Time + 1e-12;
    within +=
      a.HasAnswer == b.HasAnswer && distance <= most && speed * std::abs(a.Time - b.Time) <= most
      ? 1
      : 0;
  }
  return static_cast<double>(within) / static_cast<double>(one.Ends.size());
}

void AddRow(const Case& what, vtkImageData* samples, double tolerance, const BenchOptions& options,
  BenchRows& rows)
{
  const auto all = NewAdvection(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
  const auto some = NewAdvection(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
  for (vtkImplicitFlowField* filter : { all.GetPointer(), some.GetPointer() })
  {
    filter->SetSampleData(samples);
  }
  some->ShareStreamlinesOn();
  const std::vector<double> seconds = MeasureAlternately(
    { WithThreads(1, MakeWork(some)), WithThreads(1, MakeWork(all)) }, options.GetRepeats());
  const vtkFlowReport& report = some->GetReport();
  const double speed = report.MaximumSpeed;
  BenchRow row = rows.Make(what.Name, Shared);
  row.Parameter = tolerance;
  row.Seconds = seconds[0];
  row.Peer = "all streamlines";
  row.PeerSeconds = seconds[1];
  row.Counts["samples"] = report.Samples;
  row.Counts["shared"] = report.SharedSamples;
  row.Counts["steps"] = report.Steps;
  row.Counts["peer_steps"] = all->GetReport().Steps;
  row.Counts["largest_checked_error"] = report.LargestSharedError;
  row.Counts["within"] = GetShareWithin(
    ReadAdvection(what, all), ReadAdvection(what, some), 10.0 * some->GetMaximumError(), speed);
  rows.Add(row);
}
}

void AddSharingRows(const BenchOptions& options, BenchRows& rows)
{
  const int side = options.Pick(47, 25, 13);
  vtkNew<vtkImageData> samples;
  samples->SetDimensions(side, side, side);
  samples->SetOrigin(-Half, -Half, -Half);
  const double spacing = 2.0 * Half / (side - 1);
  samples->SetSpacing(spacing, spacing, spacing);
  for (const FieldCase& field : MakeFieldCases(options))
  {
    if (!field.IsStiff && field.What.Name != "uniform")
    {
      const Case what = OnImage(field.What, samples);
      for (const double tolerance :
        options.Pick<std::vector<double>>({ 1e-2, 1e-3, 1e-4, 1e-6 }, { 1e-3, 1e-6 }, { 1e-3 }))
      {
        AddRow(what, samples, tolerance, options, rows);
      }
    }
  }
}

std::vector<BenchClaim> CheckSharingClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast(
    "shared streamlines: 99.9 % of the answers within 10 times the tolerance", 0.999, rows,
    [](const BenchRow& row) -> std::optional<double>
    {
      return row.Method == Shared ? std::optional<double>(row.Counts["within"].get<double>())
                                  : std::nullopt;
    }) };
}
}
