// SPDX-License-Identifier: BSD-3-Clause
// Error of interpolation between samples, as reported by vtkImplicitFlowField, compared with
// formulas for uniform and rotating flow on all grids. Also tests split cells, seams, threads, and
// when the error is not checked.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationPlane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr int AllCells = 1000000;

/// Dimensions and bounds of an image of samples.
struct SampleGrid
{
  std::array<int, 3> Points;
  std::array<double, 6> Bounds;

  Vector GetPosition(const std::array<double, 3>& at) const
  {
    Vector x;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double width = this->Bounds[2 * axis + 1] - this->Bounds[2 * axis];
      x[axis] = this->Bounds[2 * axis] + width * at[axis] / (this->Points[axis] - 1);
    }
    return x;
  }
};

/// The exact result for the end of a streamline: its status, u, v and time.
struct End
{
  int Status = vtkFlowStatus::REACHED_SURFACE;
  std::array<double, 3> Values{};
};
using Formula = std::function<End(const Vector&)>;

vtkSmartPointer<vtkImplicitFlowField> NewFilter(vtkDataSet* field, vtkTerminationSurface* surface,
  const SampleGrid& samples, int checks = AllCells)
{
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputDataObject(field);
  filter->AddTerminationSurface(surface);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(samples.Points[0], samples.Points[1], samples.Points[2]);
  filter->SetSampleBounds(samples.Bounds.data());
  filter->SetSamplingChecks(checks);
  return filter;
}

/// The values of the report about interpolation errors between samples.
struct Sampling
{
  struct Error
  {
    double Mean = 0.0;
    double Percentile99 = 0.0;
    double Largest = 0.0;
  };

  vtkIdType Checks = 0;
  vtkIdType SplitCells = 0;
  vtkIdType MismatchedCenters = 0;
  vtkIdType Compared = 0;
  Error U;
  Error V;
  Error Time;
};

Sampling ReadReport(vtkInterlumeReport* report)
{
  const auto count = [report](const char* name) { return report->GetCount(name); };
  const auto error = [report](const char* name)
  {
    return Sampling::Error{ report->GetNumber(name), report->GetNumber(name, 1),
      report->GetNumber(name, 2) };
  };
  return { count("SamplingChecks"), count("SamplingSplitCells"), count("SamplingMismatchedCenters"),
    count("SamplingCompared"), error("SamplingErrorU"), error("SamplingErrorV"),
    error("SamplingErrorTime") };
}

/// Computes the expected report from the formula, for checks of all cells.
Sampling GetExpected(const SampleGrid& samples, const Formula& formula)
{
  Sampling report;
  std::array<std::vector<double>, 3> errors;
  for (int k = 0; k + 1 < samples.Points[2]; ++k)
  {
    for (int j = 0; j + 1 < samples.Points[1]; ++j)
    {
      for (int i = 0; i + 1 < samples.Points[0]; ++i)
      {
        std::map<int, int> numbers;
        std::array<double, 3> means{};
        for (int corner = 0; corner < 8; ++corner)
        {
          const End end = formula(samples.GetPosition({ { i + 0.0 + (corner & 1),
            j + 0.0 + ((corner >> 1) & 1), k + 0.0 + (corner >> 2) } }));
          ++numbers[end.Status];
          for (std::size_t q = 0; q < 3; ++q)
          {
            means[q] += end.Values[q] / 8.0;
          }
        }
        if (numbers[vtkFlowStatus::OUTSIDE] == 8)
        {
          continue;
        }
        const End center = formula(samples.GetPosition({ { i + 0.5, j + 0.5, k + 0.5 } }));
        int maximum = 0;
        for (const auto& status : numbers)
        {
          maximum = std::max(maximum, status.second);
        }
        const bool isDifferent = numbers[center.Status] < maximum;
        ++report.Checks;
        report.SplitCells += maximum < 8 ? 1 : 0;
        report.MismatchedCenters += isDifferent ? 1 : 0;
        if (maximum < 8 || isDifferent || center.Status != vtkFlowStatus::REACHED_SURFACE)
        {
          continue;
        }
        ++report.Compared;
        for (std::size_t q = 0; q < 3; ++q)
        {
          errors[q].push_back(std::abs(means[q] - center.Values[q]));
        }
      }
    }
  }
  Sampling::Error* const found[] = { &report.U, &report.V, &report.Time };
  for (std::size_t q = 0; q < 3; ++q)
  {
    std::vector<double>& list = errors[q];
    std::sort(list.begin(), list.end());
    for (const double error : list)
    {
      found[q]->Mean += error / static_cast<double>(list.size());
    }
    const auto rank = std::ceil(0.99 * static_cast<double>(list.size()));
    found[q]->Percentile99 = list[static_cast<std::size_t>(rank) - 1];
    found[q]->Largest = list.back();
  }
  return report;
}

void CheckReport(const Sampling& found, const Sampling& expected, Check& check)
{
  check.Equal(found.Checks, expected.Checks, "cells");
  check.Equal(found.SplitCells, expected.SplitCells, "split cells");
  check.Equal(
    found.MismatchedCenters, expected.MismatchedCenters, "cell centers with another status");
  check.Equal(found.Compared, expected.Compared, "cell centers with an error");
  const auto compare =
    [&](const Sampling::Error& one, const Sampling::Error& other, const std::string& name)
  {
    check.Near(one.Mean, other.Mean, 1e-3, "mean of " + name, 1e-3);
    check.Near(one.Percentile99, other.Percentile99, 1e-3, "99th percentile of " + name, 1e-3);
    check.Near(one.Largest, other.Largest, 1e-3, "maximum of " + name, 1e-3);
  };
  compare(found.U, expected.U, "u");
  compare(found.V, expected.V, "v");
  compare(found.Time, expected.Time, "time");
}

/// In uniform flow, interpolation between samples has no error.
void TestUniform(Check& check)
{
  for (const auto& grid : MakeFlowGrids())
  {
    check.SetContext("uniform, " + grid.first);
    AddVectors(grid.second, [](const Vector&) { return Vector{ { 0.5, 0.0, 0.0 } }; });
    const auto filter =
      NewFilter(grid.second, MakeFlowPlane(0.0), { { { 9, 8, 7 } }, { { 0, 4, 0, 4, 0, 4 } } });
    filter->SetMaximumError(1e-11);
    filter->Update();
    const Sampling found = ReadReport(filter->GetReport());
    check.Equal(found.Checks, 8 * 7 * 6, "cells");
    check.Equal(found.Compared, found.Checks, "all centers reach the plane");
    check.Equal(found.SplitCells + found.MismatchedCenters, 0, "borders");
    check.That(
      std::max({ found.U.Largest, found.V.Largest, found.Time.Largest }) < 1e-9, "errors are 0");
    check.Equal(
      filter->GetReport()->GetCount("Samples"), 9 * 8 * 7, "only samples are counted as samples");
  }
  check.SetContext("");
}

/// Rotating flow around the axis x = 0, y = -1. Backward streamlines reach the plane x = 0, except
/// those that would reach it above y = 4, which leave the field.
Vector Rotation(const Vector& x)
{
  return { { x[1] + 1.0, -x[0], 0.0 } };
}
End FollowRotation(const Vector& x)
{
  End end;
  const double radius = std::hypot(x[0], x[1] + 1.0);
  end.Values = { { (radius - 1.0) / 4.0, x[2] / 4.0, std::atan2(x[0], x[1] + 1.0) } };
  end.Status = radius > 5.0 ? vtkFlowStatus::LEFT_DOMAIN : end.Status;
  for (const double rank : x)
  {
    end.Status = rank < 0.0 || rank > 4.0 ? vtkFlowStatus::OUTSIDE : end.Status;
  }
  return end;
}

/// Compares the report with the formula for all grids. The samples are inside the field, or extend
/// past the boundaries of the field and of the reached region.
void TestRotation(Check& check)
{
  const SampleGrid sampleGrids[] = { { { { 15, 14, 4 } },
                                       { { 0.11, 3.87, 0.13, 3.91, 0.1, 3.9 } } },
    { { { 15, 14, 7 } }, { { -0.53, 4.41, -0.67, 4.37, -0.71, 4.43 } } } };
  for (const auto& grid : MakeFlowGrids())
  {
    AddVectors(grid.second, Rotation);
    for (const SampleGrid& samples : sampleGrids)
    {
      check.SetContext("rotation, " + grid.first + ", from " + std::to_string(samples.Bounds[0]));
      const auto filter = NewFilter(grid.second, MakeFlowPlane(0.0), samples);
      filter->Update();
      const Sampling expected = GetExpected(samples, FollowRotation);
      check.That(expected.SplitCells > 40 && expected.Compared > 300 &&
          expected.Compared < expected.Checks &&
          (samples.Bounds[0] > 0.0 || expected.MismatchedCenters > 3),
        "every case occurs");
      CheckReport(ReadReport(filter->GetReport()), expected, check);
    }
  }
  check.SetContext("");
}

/// Errors decrease by a factor of four when the spacing is halved. Errors in 1,000 checked cells
/// are similar to those in all cells.
void TestOrder(Check& check)
{
  const auto grid = MakeFlowGrids()[2].second;
  AddVectors(grid, Rotation);
  Sampling before;
  for (const int points : { 11, 21, 41 })
  {
    const SampleGrid samples{ { { points, points, points } },
      { { 0.3, 2.7, 0.2, 2.4, 0.5, 3.5 } } };
    const auto filter = NewFilter(grid, MakeFlowPlane(0.0), samples, 1000);
    filter->Update();
    const Sampling found = ReadReport(filter->GetReport());
    const Sampling all = GetExpected(samples, FollowRotation);
    check.SetContext(std::to_string(points) + " points");
    check.Equal(found.Checks, 1000, "1,000 checked cells");
    check.Near(found.U.Mean, all.U.Mean, 0.05, "mean of u");
    check.Near(found.Time.Mean, all.Time.Mean, 0.05, "mean of time");
    check.That(
      found.Time.Largest <= all.Time.Largest + 1e-4 && found.Time.Largest >= 0.8 * all.Time.Largest,
      "maximum of time");
    if (before.Checks > 0)
    {
      check.Near(std::log2(before.U.Mean / found.U.Mean), 2.0, 0.05, "order of u");
      check.Near(std::log2(before.Time.Mean / found.Time.Mean), 2.0, 0.05, "order of time");
      check.Near(std::log2(before.Time.Percentile99 / found.Time.Percentile99), 2.0, 0.1,
        "order of the 99th percentile");
    }
    before = found;
  }
  check.SetContext("");
}

/// All four sides of a cylinder have equal errors, although one contains the seam of u.
void TestSeam(Check& check)
{
  const auto field = MakeFlowImage(5,
    [](const Vector& x) {
      return Vector{ { x[0] - 2.0, x[1] - 2.0, 0.0 } };
    });
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetPoint1(2.0, 2.0, -1.0);
  cylinder->SetPoint2(2.0, 2.0, 5.0);
  cylinder->SetRadius(0.3);
  const SampleGrid sides[] = { { { { 6, 14, 4 } }, { { 2.8, 3.9, 0.7, 3.3, 1, 3 } } },
    { { { 14, 6, 4 } }, { { 0.7, 3.3, 2.8, 3.9, 1, 3 } } },
    { { { 6, 14, 4 } }, { { 0.1, 1.2, 0.7, 3.3, 1, 3 } } },
    { { { 14, 6, 4 } }, { { 0.7, 3.3, 0.1, 1.2, 1, 3 } } } };
  Sampling first;
  for (const SampleGrid& side : sides)
  {
    const auto filter = NewFilter(field, cylinder, side);
    filter->Update();
    const Sampling found = ReadReport(filter->GetReport());
    check.Equal(found.Compared, 5 * 13 * 3, "all reach the cylinder");
    check.That(found.U.Largest > 1e-5 && found.U.Largest < 0.02, "maximum of u");
    first = first.Checks > 0 ? first : found;
    CheckReport(found, first, check);
  }
}

/// In rotating flow, the advection time jumps at a half-plane. Cells across the half-plane are
/// reported as split, not as errors.
void TestJump(Check& check)
{
  const auto field = MakeFlowImage(5,
    [](const Vector& x) {
      return Vector{ { 2.0 - x[1], x[0] - 2.0, 0.0 } };
    });
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(2.0, 2.0, -1.0);
  plane->SetPoint1(4.0, 2.0, -1.0);
  plane->SetPoint2(2.0, 2.0, 5.0);
  const auto filter =
    NewFilter(field, plane, { { { 8, 12, 5 } }, { { 2.6, 3.3, 1.52, 2.6, 1, 3 } } });
  filter->Update();
  const Sampling found = ReadReport(filter->GetReport());
  check.Equal(found.Checks, 7 * 11 * 4, "cells");
  check.Equal(found.SplitCells, 7 * 4, "a layer of split cells");
  check.Equal(found.Compared, 7 * 10 * 4, "all other cells");
  check.That(found.Time.Largest < 0.02, "a jump is not an error");
}

/// Tests determinism across threads, the field arrays, the default number of checks, and which
/// sample modes and options disable the checks.
void TestRuns(Check& check)
{
  const auto grid = MakeFlowGrids()[2].second;
  AddVectors(grid, Rotation);
  const SampleGrid samples{ { { 15, 14, 13 } }, { { 0.11, 3.87, 0.13, 3.91, 0.1, 3.9 } } };
  std::string before;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        const auto filter = NewFilter(grid, MakeFlowPlane(0.0), samples, 500);
        filter->Update();
        vtkFieldData* data = filter->GetOutputDataObject(0)->GetFieldData();
        vtkDataArray* errors = data->GetArray(vtkFlowStatus::SamplingErrorsArray());
        const Sampling report = ReadReport(filter->GetReport());
        check.That(before.empty() ||
            before.compare(
              0, before.size(), static_cast<const char*>(errors->GetVoidPointer(0)), 72) == 0,
          "the errors are bit-identical");
        before.assign(static_cast<const char*>(errors->GetVoidPointer(0)), 72);
        check.That(errors->GetComponent(0, 0) == report.U.Mean &&
            errors->GetComponent(1, 1) == report.V.Percentile99 &&
            errors->GetComponent(2, 2) == report.Time.Largest && report.Time.Largest > 0.0,
          "errors in the array");
        check.Equal(static_cast<int>(
                      data->GetArray(vtkFlowStatus::SamplingChecksArray())->GetComponent(0, 3)),
          report.Compared, "number of compared cells in the array");
        CheckPrinted(Print(filter),
          { "SamplingChecks: 500\n", "SamplingCompared: " + std::to_string(report.Compared) + "\n",
            "SamplingErrorTime: " },
          check);
      });
  }
  vtkNew<vtkImplicitFlowField> defaults;
  check.Equal(defaults->GetSamplingChecks(), 1000, "default");

  const auto isChecked = [&check](vtkImplicitFlowField* filter)
  {
    filter->Update();
    const bool hasArray = filter->GetOutputDataObject(0)->GetFieldData()->HasArray(
      vtkFlowStatus::SamplingErrorsArray());
    const bool hasReport = filter->GetReport()->GetNumber("SamplingChecks") > 0;
    check.Equal(hasArray, hasReport, "the array exists if the report has checks");
    return hasReport;
  };
  auto filter = NewFilter(grid, MakeFlowPlane(0.0), samples, 500);
  check.That(isChecked(filter), "samples of an image");
  filter->SetSamplingChecks(0);
  check.That(!isChecked(filter), "no checks if off");
  filter->SetSamplingChecks(500);
  filter->SetRefinementLevels(1);
  check.That(!isChecked(filter), "no checks with refinement");
  filter->SetRefinementLevels(0);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  check.That(!isChecked(filter), "no checks at the field's points");
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_AUTOMATIC);
  check.That(!isChecked(filter), "no checks at the points of a small field");
  const auto large = MakeStructuredGrid({ { 4, 4, 1400 } });
  AddVectors(large, Rotation);
  filter->SetInputDataObject(large);
  check.That(isChecked(filter), "checks if the samples are fewer than the field's points");
}

}

int TestSamplingReport(int, char*[])
{
  Check check;
  TestUniform(check);
  TestRotation(check);
  TestOrder(check);
  TestSeam(check);
  TestJump(check);
  TestRuns(check);
  return check.Result();
}
