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
/// Written instead of an infinite error, which JSON cannot represent.
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

/// Returns the case with the points of an image as seeds.
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

/// Errors of samples in units of the tolerance.
struct Errors
{
  /// Errors of the interpolated samples, in ascending order.
  std::vector<double> Shared;
  vtkIdType Within = 0;

  double GetQuantile(double fraction) const
  {
    const std::size_t last = this->Shared.size();
    const auto at = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(last)));
    return last == 0 ? 0.0 : std::min(Infinite, this->Shared[std::max<std::size_t>(at, 1) - 1]);
  }
};

Errors FindErrors(const Case& what, vtkImplicitFlowField* all, vtkImplicitFlowField* some)
{
  const MethodResult exact = GetFlowFieldResult(what, all);
  const MethodResult found = GetFlowFieldResult(what, some);
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
      const double distance = a.HasResult
        ? std::hypot(a.Position[0] - b.Position[0], a.Position[1] - b.Position[1],
            a.Position[2] - b.Position[2])
        : 0.0;
      constexpr double rounding = 1e-13;
      error = std::max(distance, speed * std::abs(a.Time - b.Time)) /
        (some->GetMaximumError() * a.Time + rounding);
    }
    errors.Within += error <= Within ? 1 : 0;
    // Interpolated results took no advection steps.
    if (b.HasResult && GetValue(some, "AdvectionSteps", sample) == 0.0 &&
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
  const auto all = NewFlowField(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
  const auto some = NewFlowField(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
  for (vtkImplicitFlowField* filter : { all.GetPointer(), some.GetPointer() })
  {
    filter->SetSampleData(samples);
    filter->StoreStepCountsOn();
  }
  some->InterpolateStreamlinesOn();
  const std::vector<BenchSeconds> seconds = MeasureAlternately(
    { WithThreads(1, MakeRerunWork(some)), WithThreads(1, MakeRerunWork(all)) }, 3);
  vtkInterlumeReport* report = some->GetReport();
  const Errors errors = FindErrors(what, all, some);
  const double number = report->GetNumber("Samples");
  BenchRow row = rows.Make(what.Name, Shared, tolerance);
  row.SetTimes(seconds[0].GetProcessorTime(), "all streamlines", seconds[1].GetProcessorTime());
  row.Set({ { "samples", report->GetCount("Samples") },
    { "share", report->GetNumber("InterpolatedSamples") / number },
    { "median", errors.GetQuantile(0.5) }, { "q99", errors.GetQuantile(0.99) },
    { "q999", errors.GetQuantile(0.999) }, { "largest", errors.GetQuantile(1.0) },
    { "within", static_cast<double>(errors.Within) / number },
    { "checks", report->GetCount("InterpolationChecks") },
    { "largest_checked_error", report->GetNumber("LargestInterpolationError") },
    { "steps", report->GetCount("Steps") },
    { "peer_steps", all->GetReport()->GetCount("Steps") } });
  rows.Add(row);
}

/**
 * Measures the fields of MakeSharingCases with about 100,000 samples on an image. In cases with
 * `dense` in the name, the image is a quarter as wide. The method `shared` is vtkImplicitFlowField
 * with InterpolateStreamlines on; in the baseline, it is off. Times are CPU times. The parameter is
 * MaximumError divided by the maximum speed.
 *
 * The error of a sample is the larger of two lengths: the distance between the endpoints, and the
 * difference of times multiplied by the maximum speed. It is divided by MaximumError times the
 * advection time. It is infinite (written as 1e30) if the status or the id differs. `median`,
 * `q99`, `q999` and `largest` are quantiles of the errors of interpolated samples. `within` is the
 * fraction of all samples with an error of at most 10.
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
