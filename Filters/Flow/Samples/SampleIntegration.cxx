// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SampleIntegration.h"

#include "Common/Vectors.h"
#include "Fields/FlowField.h"
#include "Samples/SampleOrder.h"
#include "Samples/StreamlineInterpolation.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSignedCharArray.h"
#include "vtkTerminationSurface.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
TerminationSides MakeSides(const AdvectionOptions& options, vtkDataSet* samples)
{
  double bounds[6];
  samples->GetBounds(bounds);
  return TerminationSides(options, bounds);
}
}

SampleIntegration::SampleIntegration(StageContext& context, vtkDataSet* samples)
  : Context(context)
  , ProgressStart(context.Progress)
  , Sides(MakeSides(context.Options, samples))
{
}

bool SampleIntegration::Run(vtkDataSet* samples, vtkIdType first, int level)
{
  this->Samples = samples;
  this->Arrays = SampleArrays::Find(this->Context.Options, samples->GetPointData());
  this->Level = level;
  this->Done = 0;
  const vtkIdType all = samples->GetNumberOfPoints();
  this->Number = all - first;
  vtkSMPThreadLocal<FlowReport> reports;
  this->Reports = &reports;
  if (all > 0)
  {
    // The first call builds caches in the dataset. Make it before threads start.
    double x[3];
    samples->GetPoint(0, x);
  }
  this->Sides.SetNumberOfSamples(all);
  int dimensions[3];
  const bool isDone = this->CanInterpolate(dimensions) ? this->AdvectAndInterpolate(dimensions)
                                                       : this->Follow(SampleOrder(samples, first));
  for (const FlowReport& report : reports)
  {
    this->Context.Report.Add(report);
  }
  if (isDone)
  {
    this->FindSides();
  }
  return isDone;
}

bool SampleIntegration::CanInterpolate(int dimensions[3]) const
{
  const AdvectionOptions& options = this->Context.Options;
  const bool hasQuantities = options.ComputeMaximumSpeed || options.ComputeArcLength ||
    options.ComputeMeanVorticity || !options.MeanNumbers.empty();
  return options.InterpolateStreamlines && this->Level == 0 && !hasQuantities &&
    StreamlineInterpolation::GetDimensions(this->Samples, dimensions);
}

double SampleIntegration::GetProgress() const
{
  const double part =
    (ProgressEnd - this->ProgressStart) / (this->Context.Options.RefinementLevels + 1.0);
  const double fraction = static_cast<double>(this->Done) / std::max<vtkIdType>(1, this->Number);
  return this->ProgressStart + (this->Level + fraction) * part;
}

bool SampleIntegration::Follow(const SampleOrder& order)
{
  const double before = this->GetProgress();
  this->Done += order.GetNumber();
  this->Context.Progress = this->GetProgress();
  return this->Context.Field.Follow(
    this->Context.Options, order.GetNumber(),
    [&](vtkIdType i, double x[3]) { this->Samples->GetPoint(order[i], x); },
    [&](vtkIdType i, const AdvectionResult& result) { this->Store(order[i], result); }, before,
    this->Context.Progress);
}

void SampleIntegration::Store(vtkIdType id, const AdvectionResult& result)
{
  double x[3];
  this->Samples->GetPoint(id, x);
  this->Arrays.Set(id, result);
  this->Sides.Add(id, x, result);
  this->Reports->Local().Add(result);
}

const vtkTerminationSurface* SampleIntegration::FindSurface(int id, int& part) const
{
  for (const AdvectionOptions::Surface& surface : this->Context.Options.Surfaces)
  {
    part = id - surface.Id;
    if (part >= 0 && part < surface.Shape->GetNumberOfParts())
    {
      return surface.Shape;
    }
  }
  return nullptr;
}

double SampleIntegration::GetDistance(int id, const double first[2], const double other[2]) const
{
  int part = 0;
  if (const vtkTerminationSurface* surface = this->FindSurface(id, part))
  {
    double x[3];
    double y[3];
    return surface->EvaluatePoint(part, first, x) && surface->EvaluatePoint(part, other, y)
      ? Vectors::SafeLength(Vectors::Difference(x, y))
      : std::numeric_limits<double>::infinity();
  }
  // An upper bound, since no domain face is wider than the field.
  return this->Context.FieldLength *
    std::max(std::abs(first[0] - other[0]), std::abs(first[1] - other[1]));
}

bool SampleIntegration::AdvectAndInterpolate(const int dimensions[3])
{
  const double speed = this->Context.Field.GetField().GetSpeedScale();
  StreamlineInterpolation sharing(
    dimensions,
    { this->Arrays.Status->GetPointer(0), this->Arrays.Id->GetPointer(0),
      this->Arrays.Parameters->GetPointer(0), this->Arrays.Time->GetPointer(0) },
    [&](const StreamlineInterpolation::SampleResult& guess, const double* uv, double time)
    {
      const double error = std::max(
        this->GetDistance(guess.Id, guess.Parameters, uv), speed * std::abs(guess.Time - time));
      // Rounding error of positions is not an interpolation error.
      constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
      return error /
        (this->Context.Options.MaximumError * time + rounding * this->Context.FieldLength);
    },
    [this](int id) -> std::array<bool, 2>
    {
      int part = 0;
      const vtkTerminationSurface* surface = this->FindSurface(id, part);
      return { { surface && surface->IsPeriodic(0, part),
        surface && surface->IsPeriodic(1, part) } };
    });
  bool isActive = this->Follow(SampleOrder(this->Samples, sharing.GetFirst()));
  while (isActive && sharing.Next())
  {
    isActive = this->Follow(SampleOrder(this->Samples, sharing.GetSamplesToAdvect())) &&
      this->Follow(SampleOrder(this->Samples, sharing.CheckCenters()));
    if (isActive)
    {
      sharing.VisitInterpolated(
        [&](vtkIdType id, const StreamlineInterpolation::SampleResult& interpolated)
        {
          AdvectionResult result;
          result.Status = vtkFlowStatus::REACHED_SURFACE;
          result.Id = interpolated.Id;
          std::copy_n(interpolated.Parameters, 2, result.Parameters);
          result.Time = interpolated.Time;
          this->Store(id, result);
          ++this->Context.Report.InterpolatedSamples;
        });
    }
  }
  this->Context.Report.InterpolationChecks = sharing.GetNumberOfChecks();
  this->Context.Report.LargestInterpolationError = sharing.GetLargestError();
  this->Context.Report.MeanInterpolationError = sharing.GetMeanError();
  return isActive;
}

void SampleIntegration::FindSides()
{
  this->Arrays.Side->Fill(0);
  const std::vector<vtkIdType> corners =
    this->Sides.FindCutCellCorners(this->Samples, this->Arrays.Id->GetPointer(0));
  const std::vector<Streamlines::Velocity> velocities = this->Context.Field.GetVelocities(
    static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType i, double x[3])
    { this->Samples->GetPoint(corners[static_cast<std::size_t>(i)], x); },
    false);
  vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        if (velocities[i].IsInField)
        {
          const vtkIdType id = corners[i];
          double x[3];
          this->Samples->GetPoint(id, x);
          this->Arrays.Side->SetValue(
            id, this->Sides.GetSide(id, this->Arrays.Id->GetValue(id), x, velocities[i].V));
        }
      }
    });
}

}
