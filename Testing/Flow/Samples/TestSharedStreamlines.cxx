// SPDX-License-Identifier: BSD-3-Clause
// Results interpolated from neighboring samples: their errors compared with formulas and with full
// advection. Also tests rejected blocks, threads, and the default setting.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "Samples/StreamlineInterpolation.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataArray.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationPlane.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using interlume::StreamlineInterpolation;

/// The exact result of the sample with indices i, j, k.
struct Formula
{
  int Status = vtkFlowStatus::REACHED_SURFACE;
  int Id = 0;
  double U = 0.0;
  double V = 0.0;
  double Time = 1.0;
};
using FormulaFunction = std::function<Formula(double i, double j, double k)>;

/// Results of Run(): number of samples, ids of interpolated samples, and errors.
struct Outcome
{
  vtkIdType Number = 0;
  std::set<vtkIdType> Shared;
  double LargestError = 0.0;
  double LargestChecked = 0.0;
  vtkIdType Checks = 0;
};

/// Interpolates exact results. Errors are maximum differences divided by \a tolerance.
Outcome Run(const std::vector<int>& points, const FormulaFunction& known, double tolerance,
  std::array<bool, 2> isPeriodic, Check& check)
{
  Outcome outcome;
  outcome.Number = static_cast<vtkIdType>(points[0]) * points[1] * points[2];
  const auto size = static_cast<std::size_t>(outcome.Number);
  std::vector<unsigned char> status(size, 255);
  std::vector<int> ids(size, -7);
  std::vector<double> uv(2 * size, NAN);
  std::vector<double> times(size, NAN);
  const auto get = [&](vtkIdType id)
  {
    return known(id % points[0], id / points[0] % points[1],
      id / (static_cast<vtkIdType>(points[0]) * points[1]));
  };
  const auto set = [&](vtkIdType id, const Formula& result)
  {
    const auto i = static_cast<std::size_t>(id);
    check.Equal(status[i], 255, "a sample is set only once");
    status[i] = static_cast<unsigned char>(result.Status);
    ids[i] = result.Id;
    uv[2 * i] = result.U;
    uv[2 * i + 1] = result.V;
    times[i] = result.Time;
  };
  const auto measure =
    [tolerance](const StreamlineInterpolation::SampleResult& guess, const double* own, double t)
  {
    return std::max({ std::abs(guess.Parameters[0] - own[0]),
             std::abs(guess.Parameters[1] - own[1]), std::abs(guess.Time - t) }) /
      tolerance;
  };
  StreamlineInterpolation sharing(points.data(),
    { status.data(), ids.data(), uv.data(), times.data() }, measure,
    [isPeriodic](int) { return isPeriodic; });
  const auto follow = [&](const std::vector<vtkIdType>& followed)
  {
    for (const vtkIdType id : followed)
    {
      set(id, get(id));
    }
  };
  follow(sharing.GetFirst());
  while (sharing.Next())
  {
    follow(sharing.GetSamplesToAdvect());
    follow(sharing.CheckCenters());
    sharing.VisitInterpolated(
      [&](vtkIdType id, const StreamlineInterpolation::SampleResult& result)
      {
        const Formula exact = get(id);
        Formula shared;
        shared.Id = result.Id;
        shared.U = result.Parameters[0];
        shared.V = result.Parameters[1];
        shared.Time = result.Time;
        outcome.Shared.insert(id);
        check.That(exact.Status == shared.Status && exact.Id == shared.Id,
          "status and id of the interpolated sample");
        const double own[2] = { exact.U, exact.V };
        outcome.LargestError = std::max(outcome.LargestError, measure(result, own, exact.Time));
        set(id, shared);
      });
  }
  check.That(std::count(status.begin(), status.end(), 255) == 0, "every sample has a result");
  outcome.LargestChecked = sharing.GetLargestError();
  outcome.Checks = sharing.GetNumberOfChecks();
  return outcome;
}

/// Cubic polynomials are interpolated exactly, and other functions only within the tolerance.
void TestFormulas(Check& check)
{
  const auto cubic = [](double i, double j, double k)
  {
    const double x = i / 32.0;
    const double y = j / 32.0;
    const double z = k / 32.0;
    return Formula{ 0, 3, 0.5 + 0.1 * (x * x * x - y * z * z), 0.3 + 0.1 * x * y * y * y,
      3.0 + z * z * z - x };
  };
  for (const std::vector<int>& points : std::vector<std::vector<int>>{ { 33, 33, 33 },
         { 37, 40, 30 }, { 50, 50, 1 }, { 1, 1, 70 }, { 4, 4, 4 }, { 2, 9, 9 }, { 1, 1, 1 } })
  {
    check.SetContext("cubic, " + std::to_string(points[0]) + " points");
    const Outcome cubics = Run(points, cubic, 1e-9, { { false, false } }, check);
    check.That(cubics.LargestError < 1e-3, "no error for a cubic polynomial");
    // The samples at centers of blocks are advected as checks. On a line, these are all samples
    // that could be interpolated.
    check.Equal(
      cubics.Shared.empty(), points[0] < 33, "samples are interpolated if there are blocks");
  }
  // Errors along two axes cancel at the centers of blocks, but not at their edges.
  const auto canceling = [](double i, double j, double) {
    return Formula{ 0, 0, 0.5 + 1e-5 * (i * i * i * i - j * j * j * j), 0.5, 1.0 };
  };
  check.SetContext("canceling");
  check.That(Run({ 13, 13, 13 }, canceling, 1e-6, { { false, false } }, check).LargestError <= 1.0,
    "errors that cancel at the center");
  check.SetContext("");
  const auto smooth = [](double i, double j, double k)
  {
    return Formula{ 0, 0, 0.5 + 0.4 * std::sin(0.11 * i) * std::cos(0.07 * j),
      0.5 + 0.4 * std::cos(0.05 * k + 0.1 * i), 2.0 + std::sin(0.09 * j + 0.08 * k) };
  };
  vtkIdType before = 0;
  for (const double tolerance : { 1e-7, 1e-5, 1e-4, 1e-2 })
  {
    const Outcome found = Run({ 41, 41, 41 }, smooth, tolerance, { { false, false } }, check);
    check.That(found.LargestError <= 1.5, "errors within the tolerance");
    check.That(found.LargestChecked <= 1.0 && (found.Checks > 0 || found.Shared.empty()),
      "errors at the centers");
    const auto number = static_cast<vtkIdType>(found.Shared.size());
    check.That(number >= before, "a larger tolerance interpolates more samples");
    before = number;
  }
  check.That(before > 0.7 * 41 * 41 * 41, std::to_string(before) + " samples interpolated");
}

/// Samples are not interpolated across a change of id or status, a seam, or a thin wall, but they
/// are interpolated on either side of it.
void TestRejections(Check& check)
{
  const auto fraction = [&](const FormulaFunction& known, std::array<bool, 2> isPeriodic) {
    return Run({ 33, 33, 33 }, known, 1e-3, isPeriodic, check);
  };
  const auto flat = [](double i, double j, double) {
    return Formula{ 0, 0, 0.01 * i, 0.02 * j, 1.0 + 0.03 * i };
  };
  const vtkIdType all = static_cast<vtkIdType>(fraction(flat, { { false, false } }).Shared.size());
  for (const int kind : { 0, 1, 2 })
  {
    check.SetContext("kind " + std::to_string(kind));
    const auto halves = [&](double i, double j, double k)
    {
      Formula result = flat(i, j, k);
      const bool isOtherSide = i + 0.3 * j > 20.7;
      result.Id = kind == 0 && isOtherSide ? 1 : 0;
      result.Status = kind == 1 && isOtherSide ? vtkFlowStatus::LEFT_DOMAIN : result.Status;
      // The seam of u passes between samples.
      result.U = kind == 2 ? std::fmod(0.8 + result.U, 1.0) : result.U;
      return result;
    };
    const Outcome found = fraction(halves, { { kind == 2, false } });
    const auto number = static_cast<vtkIdType>(found.Shared.size());
    check.That(
      number > 0.1 * all && number < all, std::to_string(number) + " interpolated on one side");
    check.That(found.LargestError <= 1.0, "no error on one side");
  }
  // A small feature at a sample of the coarsest level: no checked sample is close to it, so all
  // measured errors are small.
  for (const int kind : { 0, 1, 2 })
  {
    check.SetContext("around one sample, kind " + std::to_string(kind));
    const auto spot = [&](double i, double j, double k)
    {
      Formula result = flat(i, j, k);
      const bool isNear = std::hypot(i - 16.0, j - 16.0, k - 16.0) < 1.5;
      result.Id = kind == 0 && isNear ? 1 : 0;
      result.Status = kind == 1 && isNear ? vtkFlowStatus::LEFT_DOMAIN : result.Status;
      result.U = kind == 2 ? (isNear ? 0.999 : 0.001) : result.U;
      return result;
    };
    // At the center of an adjacent block, a jump of 1 contributes only 0.18.
    const Outcome found =
      Run({ 33, 33, 33 }, spot, kind == 2 ? 0.2 : 1e-3, { { kind == 2, false } }, check);
    check.That(found.LargestError <= 1.0, "no error near the feature");
    check.That(
      found.Shared.size() > 0.1 * static_cast<double>(all), "other samples are interpolated");
  }
  check.SetContext("");
  // Close to the boundary edge u = 1 of the surface, u has a kink between adjacent samples.
  const auto edge = [&](double i, double j, double)
  {
    const double distance = 0.03 * i + 1e-5 * j * j;
    return Formula{ 0, 0, 1.0 + 1e-3 - std::abs(distance - 0.5), 0.02 * j, 1.0 };
  };
  const Outcome edges = fraction(edge, { { false, false } });
  check.That(edges.LargestError <= 1.0, "no error at a boundary edge");
  // A wall one sample wide, which coarse levels miss. Its samples are advected at the first level
  // that contains them.
  const auto wall = [&](double i, double j, double k)
  {
    Formula result = flat(i, j, k);
    result.Time += i == 13.0 ? 5.0 : 0.0;
    return result;
  };
  const Outcome walled = fraction(wall, { { false, false } });
  check.That(walled.LargestError <= 1.0, "no error at a thin wall");
  check.That(
    walled.Shared.size() < static_cast<std::size_t>(all), "fewer interpolated samples with a wall");
}

vtkSmartPointer<vtkImplicitFlowField> NewFilter(int field, double error, bool isShared)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(field);
  source->SetDimensions(17, 17, 17);
  if (field == vtkAnalyticFlowSource::ROTATION)
  {
    // Around this center outside the field, every circular streamline leaves the field.
    source->SetCenter(-1.2, -1.2, 0.0);
  }
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(29, 33, 25);
  filter->DomainFacesOn();
  filter->SetMaximumTime(20.0);
  filter->SetMaximumError(error);
  filter->SetInterpolateStreamlines(isShared);
  filter->StoreStepCountsOn();
  return filter;
}

vtkDataArray* Get(vtkImplicitFlowField* filter, const char* name)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetArray(name);
}

std::string GetBytes(vtkImplicitFlowField* filter)
{
  std::string bytes;
  for (const char* name : { vtkFlowStatus::StatusArray(), vtkFlowStatus::IdArray(),
         vtkFlowStatus::ParametersArray(), vtkFlowStatus::TimeArray(), vtkFlowStatus::SideArray() })
  {
    vtkDataArray* array = Get(filter, name);
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
  return bytes;
}

/// Returns the sorted errors of interpolated results in units of the tolerance. Errors are infinite
/// if status or id differ.
std::vector<double> FindErrors(vtkImplicitFlowField* all, vtkImplicitFlowField* some)
{
  double bounds[6];
  vtkDataSet::SafeDownCast(some->GetOutputDataObject(0))->GetBounds(bounds);
  vtkInterlumeReport* report = some->GetReport();
  std::vector<double> errors;
  for (vtkIdType i = 0; i < report->GetNumber("Samples"); ++i)
  {
    const double time = Get(all, "AdvectionTime")->GetTuple1(i);
    const bool isShared = Get(some, "AdvectionSteps")->GetTuple1(i) == 0.0 &&
      Get(some, "AdvectionTime")->GetTuple1(i) > 0.0;
    if (isShared)
    {
      const bool isSame =
        Get(all, "FlowStatus")->GetTuple1(i) == Get(some, "FlowStatus")->GetTuple1(i) &&
        Get(all, "TerminationId")->GetTuple1(i) == Get(some, "TerminationId")->GetTuple1(i);
      double difference = report->GetNumber("MaximumSpeed") *
        std::abs(Get(some, "AdvectionTime")->GetTuple1(i) - time);
      for (int c = 0; c < 2; ++c)
      {
        // The field has the same width along each axis.
        difference = std::max(difference,
          (bounds[1] - bounds[0]) *
            std::abs(Get(all, "TerminationUV")->GetComponent(i, c) -
              Get(some, "TerminationUV")->GetComponent(i, c)));
      }
      errors.push_back(isSame ? difference / (some->GetMaximumError() * time + 1e-12)
                              : std::numeric_limits<double>::infinity());
    }
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

/// In eight fields, the errors of interpolated results are less than ten times the tolerance of
/// advection.
void TestFields(Check& check)
{
  vtkIdType shared = 0;
  for (const int field : { vtkAnalyticFlowSource::UNIFORM, vtkAnalyticFlowSource::ROTATION,
         vtkAnalyticFlowSource::SADDLE, vtkAnalyticFlowSource::SOURCE_SINK,
         vtkAnalyticFlowSource::SPHERE, vtkAnalyticFlowSource::ABC, vtkAnalyticFlowSource::SHEAR,
         vtkAnalyticFlowSource::HURRICANE })
  {
    for (const double error : { 1e-3, 1e-2 })
    {
      check.SetContext("field " + std::to_string(field) + ", error " + std::to_string(error));
      const auto all = NewFilter(field, error, false);
      const auto some = NewFilter(field, error, true);
      all->Update();
      some->Update();
      vtkInterlumeReport* report = some->GetReport();
      shared += report->GetNumber("InterpolatedSamples");
      check.Equal(
        all->GetReport()->GetCount("InterpolatedSamples"), 0, "no interpolation by default");
      check.Equal(report->GetCount("Samples"), all->GetReport()->GetCount("Samples"), "samples");
      check.That(report->GetNumber("LargestInterpolationError") <= 1.0 &&
          report->GetNumber("MeanInterpolationError") <=
            report->GetNumber("LargestInterpolationError") &&
          (report->GetNumber("LargestInterpolationError") > 0.0 ||
            report->GetNumber("InterpolationChecks") == 0),
        "errors in the report");
      const std::vector<double> errors = FindErrors(all, some);
      // FindErrors() skips samples on a surface, where the time is 0.
      check.That(
        10 * static_cast<vtkIdType>(errors.size()) >= 9 * report->GetCount("InterpolatedSamples"),
        std::to_string(errors.size()) + " interpolated");
      const auto above =
        static_cast<double>(errors.end() - std::upper_bound(errors.begin(), errors.end(), 10.0));
      check.That(above <= 0.001 * static_cast<double>(errors.size()),
        std::to_string(above) + " of " + std::to_string(errors.size()) +
          " above ten times the tolerance");
      check.That(errors.empty() || errors.back() < 10.0,
        std::to_string(errors.empty() ? 0.0 : errors.back()) + " is the maximum error");
    }
  }
  check.SetContext("");
  check.That(shared > 20000, std::to_string(shared) + " interpolated samples in total");
}

void TestRuns(Check& check)
{
  std::string bytes;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        const auto filter = NewFilter(vtkAnalyticFlowSource::ROTATION, 1e-3, true);
        filter->Update();
        check.That(bytes.empty() || bytes == GetBytes(filter), "the results are bit-identical");
        bytes = GetBytes(filter);
      });
  }
  // Samples are not interpolated if path quantities are computed, or if the samples form a mesh.
  auto filter = NewFilter(vtkAnalyticFlowSource::ROTATION, 1e-3, true);
  filter->ComputeArcLengthOn();
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("InterpolatedSamples"), 0, "path quantities");
  filter = NewFilter(vtkAnalyticFlowSource::ROTATION, 1e-3, true);
  filter->SetSampleData(MakeFlowMesh(FlowMeshKinds().front(), { { 2, 2, 2 } }));
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("InterpolatedSamples"), 0, "a mesh");
  CheckPrinted(Print(filter), { "InterpolateStreamlines: 1", "InterpolatedSamples: 0" }, check);
}

}

int TestSharedStreamlines(int, char*[])
{
  Check check;
  TestFormulas(check);
  TestRejections(check);
  TestFields(check);
  TestRuns(check);
  return check.Result();
}
