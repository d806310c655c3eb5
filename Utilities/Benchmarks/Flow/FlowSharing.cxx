// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Flow/FlowFields.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace flow
{
namespace
{
const char* const Shared = "shared";
constexpr double Within = 10.0;
/// What JSON has for an infinite error.
constexpr double Infinite = 1e30;

vtkSmartPointer<vtkImageData> MakeSamples(int side, double half)
{
  auto samples = vtkSmartPointer<vtkImageData>::New();
  samples->SetDimensions(side, side, side);
  samples->SetOrigin(-half, -half, -half);
  const double spacing = 2.0 * half / (side - 1);
  samples->SetSpacing(spacing, spacing, spacing);
  return samples;
}

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

double GetValue(vtkImplicitFlowField* filter, const char* name, vtkIdType sample)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))
    ->GetPointData()
    ->GetArray(name)
    ->GetComponent(sample, 0);
}

/// The errors of samples in tolerances.
struct Errors
{
  /// Those of the samples that were interpolated, in ascending order.
  std::vector<double> Shared;
  vtkIdType Within = 0;

  double GetQuantile(double part) const
  {
    const std::size_t last = this->Shared.size();
    const auto at = static_cast<std::size_t>(std::ceil(part * static_cast<double>(last)));
    return last == 0 ? 0.0 : std::min(Infinite, this->Shared[std::max<std::size_t>(at, 1) - 1]);
  }
};

Errors FindErrors(const Case& what, vtkImplicitFlowField* all, vtkImplicitFlowField* some)
{
  const Answer exact = ReadAdvection(what, all);
  const Answer found = ReadAdvection(what, some);
  const double speed = some->GetReport()->GetNumber("MaximumSpeed");
  Errors errors;
  for (std::size_t i = 0; i < exact.Ends.size(); ++i)
  {
    const End& a = exact.Ends[i];
    const End& b = found.Ends[i];
    const auto sample = static_cast<vtkIdType>(i);
    const auto isSame = [&](const char* name)
    { return GetValue(all, name, sample) == GetValue(some, name, sample); };
    double error = std::numeric_limits<double>::infinity();
    if (isSame(vtkFlowStatus::StatusArray()) && isSame(vtkFlowStatus::IdArray()))
    {
      const double distance = a.HasAnswer
        ? std::hypot(a.Place[0] - b.Place[0], a.Place[1] - b.Place[1], a.Place[2] - b.Place[2])
        : 0.0;
      constexpr double rounding = 1e-13;
      error = std::max(distance, speed * std::abs(a.Time - b.Time)) /
        (some->GetMaximumError() * a.Time + rounding);
    }
    errors.Within += error <= Within ? 1 : 0;
    // No step was taken for an answer that was interpolated.
    if (b.HasAnswer && GetValue(some, "AdvectionSteps", sample) == 0.0 &&
      GetValue(all, "AdvectionSteps", sample) > 0.0)
    {
      errors.Shared.push_back(error);
    }
  }
  std::sort(errors.Shared.begin(), errors.Shared.end());
  return errors;
}

void AddRow(const Case& what, vtkImageData* samples, double tolerance, BenchRows& rows)
{
  const auto all = NewAdvection(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
  const auto some = NewAdvection(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
  for (vtkImplicitFlowField* filter : { all.GetPointer(), some.GetPointer() })
  {
    filter->SetSampleData(samples);
    filter->KeepStepsOn();
  }
  some->ShareStreamlinesOn();
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(1, Again(some)), WithThreads(1, Again(all)) }, 3);
  vtkInterlumeReport* report = some->GetReport();
  const Errors errors = FindErrors(what, all, some);
  const double number = report->GetNumber("Samples");
  BenchRow row = rows.Make(what.Name, Shared, tolerance);
  row.SetTimes(seconds[0].OfProcessor(), "all streamlines", seconds[1].OfProcessor());
  row.Set({ { "samples", GetCount(report, "Samples") },
    { "share", report->GetNumber("InterpolatedSamples") / number },
    { "median", errors.GetQuantile(0.5) }, { "q99", errors.GetQuantile(0.99) },
    { "q999", errors.GetQuantile(0.999) }, { "largest", errors.GetQuantile(1.0) },
    { "within", static_cast<double>(errors.Within) / number },
    { "checks", GetCount(report, "InterpolationChecks") },
    { "largest_checked_error", report->GetNumber("LargestInterpolationError") },
    { "steps", GetCount(report, "Steps") },
    { "peer_steps", GetCount(all->GetReport(), "Steps") } });
  rows.Add(row);
}

/**
 * The fields of MakeSharingCases, about 100,000 samples on an image each, a quarter as wide for
 * `dense`. Method `shared`, the parameter being MaximumError over the largest speed: processor time
 * of vtkImplicitFlowField with ShareStreamlines against that without. The error of a sample is the
 * distance of the ends, or the difference of times at the largest speed, whichever is more, over
 * MaximumError times the time of the streamline; infinite where status or id differ, written as
 * 1e30. `median`, `q99`, `q999` and `largest` are of the samples that were interpolated, `within`
 * is the share of all samples whose error is at most 10.
 */
void AddSharingRows(const BenchOptions& options, BenchRows& rows)
{
  constexpr double half = 0.8;
  const int side = options.Pick(47, 25, 13);
  const auto wide = MakeSamples(side, half);
  const auto dense = MakeSamples(side, 0.25 * half);
  for (const Case& field : MakeSharingCases(options))
  {
    const Case what = OnImage(field, wide);
    Case near = OnImage(field, dense);
    near.Name += ", dense";
    for (const double tolerance :
      options.Pick<std::vector<double>>({ 1e-3, 1e-4, 1e-6 }, { 1e-3, 1e-6 }, { 1e-3 }))
    {
      AddRow(what, wide, tolerance, rows);
    }
    AddRow(near, dense, 1e-6, rows);
  }
}

std::vector<BenchClaim> CheckSharingClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast(
    "shared streamlines: 99.9 % of the answers within 10 times the tolerance", 0.999, rows,
    CountOf(Shared, "within")) };
}
}

BenchPart MakeSharingPart()
{
  return { AddSharingRows, nullptr, CheckSharingClaims };
}
}
