// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SamplingCheck.h"

#include "Samples/ImplicitFlowArrays.h"
#include "Streams/StageContext.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

bool SamplingCheck::Run(StageContext& context, vtkDataSet* samples)
{
  ImplicitFlowArrays arrays;
  if (context.Options.SamplingChecks <= 0 || arrays.Find(samples))
  {
    return true;
  }
  SamplingCheck check(samples, arrays, context.Options.SamplingChecks);
  const bool isDone = context.Field.Follow(
    context.Options, static_cast<vtkIdType>(check.Cells.size()),
    [&](vtkIdType i, double x[3]) { check.GetCenter(i, x); },
    [&](vtkIdType i, const AdvectionResult& result) { check.Set(i, result); }, context.Progress,
    1.0);
  if (isDone)
  {
    context.Report.Sampling = check.GetReport();
    AddArrays(context.Report.Sampling, samples->GetFieldData());
  }
  return isDone;
}

SamplingCheck::SamplingCheck(
  vtkDataSet* samples, const ImplicitFlowArrays& arrays, vtkIdType maximum)
  : Samples(samples)
  , Arrays(arrays)
{
  const std::vector<vtkIdType> found = this->FindCells();
  const auto all = static_cast<vtkIdType>(found.size());
  const vtkIdType number = std::min(all, maximum);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < number; ++i)
  {
    random->Next();
    const double position = (static_cast<double>(i) + random->GetValue()) / number;
    const auto chosen =
      std::min(static_cast<vtkIdType>(position * static_cast<double>(all)), all - 1);
    samples->GetCellPoints(found[static_cast<std::size_t>(number < all ? chosen : i)], corners);
    Cell cell;
    cell.NumberOfCorners = static_cast<int>(corners->GetNumberOfIds());
    std::copy_n(corners->GetPointer(0), cell.NumberOfCorners, cell.Corners.begin());
    this->Cells.push_back(cell);
  }
}

std::vector<vtkIdType> SamplingCheck::FindCells() const
{
  std::vector<vtkIdType> found;
  vtkNew<vtkIdList> corners;
  for (vtkIdType id = 0; id < this->Samples->GetNumberOfCells(); ++id)
  {
    this->Samples->GetCellPoints(id, corners);
    const vtkIdType* begin = corners->GetPointer(0);
    const vtkIdType number = corners->GetNumberOfIds();
    // A vertex has no interior.
    if (number > 1 && number <= MaximumCorners &&
      std::any_of(begin, begin + number,
        [this](vtkIdType corner)
        { return this->Arrays.GetStatus(corner) != vtkFlowStatus::OUTSIDE; }))
    {
      found.push_back(id);
    }
  }
  return found;
}

void SamplingCheck::GetCenter(vtkIdType i, double x[3]) const
{
  const Cell& cell = this->Cells[static_cast<std::size_t>(i)];
  std::fill_n(x, 3, 0.0);
  for (int c = 0; c < cell.NumberOfCorners; ++c)
  {
    double corner[3];
    this->Samples->GetPoint(cell.Corners[static_cast<std::size_t>(c)], corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] += corner[axis] / cell.NumberOfCorners;
    }
  }
}

void SamplingCheck::Set(vtkIdType i, const AdvectionResult& result)
{
  Cell& cell = this->Cells[static_cast<std::size_t>(i)];
  cell.IsSplit = this->IsSplit(cell);
  cell.IsDifferent = this->IsDifferent(cell, result);
  cell.IsCompared =
    !cell.IsSplit && !cell.IsDifferent && result.Status == vtkFlowStatus::REACHED_SURFACE;
  if (!cell.IsCompared)
  {
    return;
  }
  double time = 0.0;
  for (int c = 0; c < cell.NumberOfCorners; ++c)
  {
    time += this->Arrays.GetTime(cell.Corners[static_cast<std::size_t>(c)]);
  }
  cell.Errors[U] = this->GetError(cell, result, 0);
  cell.Errors[V] = this->GetError(cell, result, 1);
  cell.Errors[TIME] = std::abs(time / cell.NumberOfCorners - result.Time);
}

bool SamplingCheck::IsSplit(const Cell& cell) const
{
  const auto* first = cell.Corners.begin();
  return std::any_of(first, first + cell.NumberOfCorners,
           [&](vtkIdType corner) { return !this->Arrays.HaveSameEnd(corner, *first); }) ||
    (this->Arrays.IsReached(*first) && this->Arrays.HasSides() &&
      this->Arrays.IsAcrossSurface(first, cell.NumberOfCorners));
}

bool SamplingCheck::IsDifferent(const Cell& cell, const AdvectionResult& result) const
{
  const auto* first = cell.Corners.begin();
  const auto* end = first + cell.NumberOfCorners;
  std::ptrdiff_t largest = 0;
  for (const auto* one = first; one != end; ++one)
  {
    largest = std::max(largest,
      std::count_if(
        first, end, [&](vtkIdType corner) { return this->Arrays.HaveSameEnd(corner, *one); }));
  }
  return std::count_if(first, end,
           [&](vtkIdType corner)
           {
             return this->Arrays.GetStatus(corner) == result.Status &&
               this->Arrays.GetId(corner) == result.Id;
           }) < largest;
}

double SamplingCheck::GetError(const Cell& cell, const AdvectionResult& result, int axis) const
{
  const bool isPeriodic = this->Arrays.GetPeriodicity(result.Id)[static_cast<std::size_t>(axis)];
  const double own = result.Parameters[axis];
  const auto subtract = [isPeriodic](double a, double b)
  { return isPeriodic ? a - b - std::round(a - b) : a - b; };
  // All corners are unwrapped to one side of a seam, as in the output of vtkFlowVolume.
  const double first = this->Arrays.GetParameters(cell.Corners[0])[axis];
  double sum = 0.0;
  for (int c = 0; c < cell.NumberOfCorners; ++c)
  {
    const vtkIdType corner = cell.Corners[static_cast<std::size_t>(c)];
    sum += subtract(this->Arrays.GetParameters(corner)[axis], first);
  }
  return std::abs(subtract(first + sum / cell.NumberOfCorners, own));
}

SamplingReport::Error SamplingCheck::GetError(Quantities quantity) const
{
  std::vector<double> errors;
  double sum = 0.0;
  for (const Cell& cell : this->Cells)
  {
    if (cell.IsCompared)
    {
      errors.push_back(cell.Errors[quantity]);
      sum += errors.back();
    }
  }
  SamplingReport::Error error;
  if (!errors.empty())
  {
    std::sort(errors.begin(), errors.end());
    error.Mean = sum / static_cast<double>(errors.size());
    error.Percentile99 = errors[(99 * errors.size() + 99) / 100 - 1];
    error.Largest = errors.back();
  }
  return error;
}

SamplingReport SamplingCheck::GetReport() const
{
  SamplingReport report;
  report.Checks = static_cast<vtkIdType>(this->Cells.size());
  for (const Cell& cell : this->Cells)
  {
    report.SplitCells += cell.IsSplit ? 1 : 0;
    report.MismatchedCenters += cell.IsDifferent ? 1 : 0;
    report.Compared += cell.IsCompared ? 1 : 0;
  }
  report.U = this->GetError(U);
  report.V = this->GetError(V);
  report.Time = this->GetError(TIME);
  return report;
}

void SamplingCheck::AddArrays(const SamplingReport& report, vtkFieldData* data)
{
  vtkNew<vtkIdTypeArray> checks;
  checks->SetName(vtkFlowStatus::SamplingChecksArray());
  checks->SetNumberOfComponents(4);
  const char* const kinds[] = { "Checks", "SplitCells", "DifferentMiddles", "Compared" };
  const vtkIdType counts[] = { report.Checks, report.SplitCells, report.MismatchedCenters,
    report.Compared };
  for (int c = 0; c < 4; ++c)
  {
    checks->SetComponentName(c, kinds[c]);
  }
  checks->InsertNextTypedTuple(counts);
  data->AddArray(checks);

  vtkNew<vtkDoubleArray> errors;
  errors->SetName(vtkFlowStatus::SamplingErrorsArray());
  errors->SetNumberOfComponents(NUMBER_OF_QUANTITIES);
  errors->SetComponentName(U, "U");
  errors->SetComponentName(V, "V");
  errors->SetComponentName(TIME, "Time");
  errors->InsertNextTuple3(report.U.Mean, report.V.Mean, report.Time.Mean);
  errors->InsertNextTuple3(report.U.Percentile99, report.V.Percentile99, report.Time.Percentile99);
  errors->InsertNextTuple3(report.U.Largest, report.V.Largest, report.Time.Largest);
  data->AddArray(errors);
}

}
