// SPDX-License-Identifier: BSD-3-Clause
// Fill values in the velocity: the automatic error and minimum speed ignore fill values at up to
// half of the points, but do not ignore real values. Streamlines, line integral convolution,
// critical points, vortex axes and inflow surfaces are the same as without fill values, except
// nearby. A warning names the value, including NaN and infinity.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowCriticalPoints.h"
#include "vtkFlowLIC.h"
#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "Numerics/SpeedScale.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationPlane.h"
#include "vtkVortexAxis.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

namespace
{

using namespace reference;

/// Checks the speed scale and the number of fill values of \a number vectors. \a vector returns the
/// vector at an index.
interlume::FillValues CheckVectors(const std::string& name, int number,
  const std::function<Vector(int)>& vector, double scale, int fillValues, Check& check)
{
  interlume::SpeedScale first;
  interlume::SpeedScale second;
  for (int i = 0; i < number; ++i)
  {
    (i % 3 == 0 ? first : second).Add(vector(i).data());
  }
  first.Add(second);
  const interlume::FillValues fill = first.FindFillValues();
  check.That(fill.Scale == scale, name + ": the scale");
  check.Equal(fill.Number, fillValues, name + ": fill values");
  return fill;
}

/// Like CheckVectors(), for vectors along x with the given speeds.
void CheckScale(const std::string& name, int number, const std::function<double(int)>& speed,
  double scale, int fillValues, Check& check)
{
  CheckVectors(
    name, number,
    [&speed](int i) {
      return Vector{ { speed(i), 0.0, 0.0 } };
    },
    scale, fillValues, check);
}

/// Tests various fill values at some of 5000 points. Speeds at the other points are in [1, 2].
void TestRepeated(Check& check)
{
  const auto land = [](int number, const Vector& value)
  {
    return [number, value](int i) {
      return i < number ? value : Vector{ { 1.0 + i / 5000.0, 0.0, 0.0 } };
    };
  };
  constexpr double fast = 1.0 + 4999 / 5000.0;
  const struct
  {
    const char* Name;
    Vector Value;
    int Number;
    int Found;
  } cases[] = {
    { "1e20 at half", { { 1e20, 1e20, 1e20 } }, 2500, 2500 },
    { "1e20 in two components", { { 1e20, 1e20, 0.0 } }, 1500, 1500 },
    { "1e20 in one component", { { 0.1, 1e20, -0.3 } }, 1500, 1500 },
    { "1e20 at almost all", { { 1e20, 1e20, 1e20 } }, 4900, 4900 },
    { "NetCDF", { { 9.96921e36, 9.96921e36, 9.96921e36 } }, 1500, 1500 },
    { "-9999", { { -9999, -9999, -9999 } }, 1500, 1500 },
    { "-30000 in packed thousandths", { { -30, -30, 0.0 } }, 1500, 1500 },
    { "-9999 at more than half", { { -9999, -9999, -9999 } }, 2600, 0 },
    { "a uniform jet along x", { { 500, 0.0, 0.0 } }, 1500, 0 },
    { "a uniform jet at an angle", { { 5, 5, 0.0 } }, 1500, 0 },
  };
  for (const auto& one : cases)
  {
    const double speed = std::sqrt(
      one.Value[0] * one.Value[0] + one.Value[1] * one.Value[1] + one.Value[2] * one.Value[2]);
    const interlume::FillValues fill = CheckVectors(
      one.Name, 5000, land(one.Number, one.Value), one.Found > 0 ? fast : speed, one.Found, check);
    const double value = one.Value[1] == 1e20 ? 1e20 : one.Value[0];
    check.That(one.Found == 0 || fill.Value == value, std::string(one.Name) + ": the fill value");
  }
  CheckVectors(
    "a real jet", 5000,
    [](int i) {
      return i < 1500 ? Vector{ { 3e4 + i, 3e4 + i, 0.0 } } : Vector{ { 1.0, 0.0, 0.0 } };
    },
    std::sqrt(2.0) * 31499, 0, check);
  CheckVectors(
    "uniform flow with rounding errors at its walls", 5000,
    [](int i) {
      return i < 4000 ? Vector{ { 1.0, 1.0, 0.0 } } : Vector{ { 1e-17 * i, 0.0, 0.0 } };
    },
    std::sqrt(2.0), 0, check);
  const interlume::FillValues two = CheckVectors(
    "two fill values at many points", 5000,
    [](int i)
    {
      return i < 800 ? Vector{ { 1e20, 1e20, 1e20 } }
        : i < 2000   ? Vector{ { -9999, -9999, 0.1 } }
                     : Vector{ { 2.0, 0.0, 0.0 } };
    },
    2.0, 2000, check);
  check.That(two.Value == -9999, "the more frequent value is reported");
}

void TestScale(Check& check)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  const auto filled = [](int first, double value)
  { return [first, value](int i) { return i < first ? value : 1.0 + i / 5000.0; }; };
  CheckScale("none", 0, filled(0, 0.0), 0.0, 0, check);
  CheckScale(
    "zeros", 100, [](int) { return 0.0; }, 0.0, 0, check);
  CheckScale("one", 1, filled(1, 7.0), 7.0, 0, check);
  CheckScale("plain", 5000, filled(0, 0.0), 1.0 + 4999 / 5000.0, 0, check);
  CheckScale("one fill value", 5000, filled(1, 1e30), 1.0 + 4999 / 5000.0, 1, check);
  CheckScale("fifty", 5000, filled(50, 1e30), 1.0 + 4999 / 5000.0, 50, check);
  CheckScale("more large values than are ignored", 5000, filled(51, 1e4), 1e4, 0, check);
  CheckScale("more huge values", 5000, filled(51, 1e30), 1.0 + 4999 / 5000.0, 51, check);
  CheckScale("a jet", 5000, filled(20, 500.0), 500.0, 0, check);
  CheckScale("one of eight", 8, filled(1, 17321.0), 1.0 + 7 / 5000.0, 1, check);
  CheckScale("one of seven", 7, filled(1, 17321.0), 17321.0, 0, check);
  CheckScale(
    "gradually increasing speeds", 5000, [](int i) { return std::pow(2.0, i / 50); },
    std::pow(2.0, 99), 0, check);
  CheckScale(
    "among zeros", 5000, [](int i) { return i == 0 ? 1e20 : (i < 300 ? 3.0 : 0.0); }, 3.0, 1,
    check);
  CheckScale(
    "the smallest and the largest number", 500,
    [tiny, huge](int i) { return i == 0 ? huge : tiny; }, tiny, 1, check);
  CheckScale(
    "two fill values", 5000, [](int i) { return i == 0 ? 1e36 : (i == 1 ? 1e20 : 2.0); }, 2.0, 2,
    check);
}

bool IsLand(const double* x)
{
  return x[1] > 3.0;
}

/// Sets all vector components to a fill value at the points where IsLand() is true, 4 of 17 layers.
/// Returns the number of these points.
vtkIdType AddLand(vtkImageData* image, double value)
{
  vtkDataArray* vectors = image->GetPointData()->GetVectors();
  vtkIdType number = 0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    if (IsLand(image->GetPoint(id)))
    {
      vectors->SetTuple3(id, value, value, value);
      ++number;
    }
  }
  vectors->Modified();
  return number;
}

void HideLand(vtkImageData* image)
{
  vtkUnsignedCharArray* ghosts = image->AllocatePointGhostArray();
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    if (IsLand(image->GetPoint(id)))
    {
      ghosts->SetValue(id, vtkDataSetAttributes::HIDDENPOINT);
    }
  }
}

/// A filter that traces to a plane, and its results for a field without fill values.
struct FlowToPlane
{
  FlowToPlane()
  {
    this->Filter->SetInputDataObject(this->Image);
    this->Filter->AddTerminationSurface(MakeFlowPlane(0.0));
    this->Filter->Update();
    this->Expected->DeepCopy(this->Filter->GetOutputDataObject(0));
    this->Error = this->Filter->GetReport()->GetNumber("MaximumError");
  }

  /// Checks that results in a region are unchanged.
  void Compare(const std::function<bool(const double*)>& isInRegion, Check& check)
  {
    auto* output = vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
    vtkIdType reached = 0;
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
    {
      if (!isInRegion(output->GetPoint(id)))
      {
        continue;
      }
      const auto get = [id](vtkDataSet* data, const char* name)
      { return data->GetPointData()->GetArray(name)->GetComponent(id, 0); };
      for (const char* name : { "FlowStatus", "TerminationId", "AdvectionTime" })
      {
        check.That(get(output, name) == get(this->Expected, name), name);
      }
      reached += get(output, "FlowStatus") == vtkFlowStatus::REACHED_SURFACE ? 1 : 0;
    }
    check.That(reached > 2000, "samples that reach the plane");
    check.Near(this->Filter->GetReport()->GetNumber("MaximumError"), this->Error, 1e-9,
      "the automatic error is unchanged");
  }

  vtkSmartPointer<vtkImageData> Image = MakeFlowImage(17,
    [](const Vector& x) {
      return Vector{ { 1.0, 0.1 * std::sin(x[2]), 0.0 } };
    });
  vtkNew<vtkImplicitFlowField> Filter;
  vtkNew<vtkImageData> Expected;
  double Error = 0.0;
};

bool IsAtSea(const double* x)
{
  return x[1] <= 2.0;
}

std::string DescribeValue(vtkIdType number, double value)
{
  std::ostringstream text;
  text << "at " << number << " points look like fill values: each has a component equal to "
       << value;
  return text.str();
}

std::string DescribeNonFinite(vtkIdType number)
{
  return "at " + std::to_string(number) + " points are NaN or infinite";
}

void CheckWarning(const std::string& warning, const std::string& expected, Check& check)
{
  check.That(warning.find(expected) != std::string::npos, "a warning: " + warning);
  check.That(warning.find("HIDDENPOINT") != std::string::npos, "the warning names the remedy");
}

/// Land with a fill value does not change the results of distant samples.
void TestLand(Check& check)
{
  FlowToPlane flow;
  for (const double value : { 1e20, -9999.0, -30000.0, 9.96920996838687e36 })
  {
    check.SetContext("land of " + std::to_string(value));
    const vtkIdType number = AddLand(flow.Image, value);
    CheckWarning(WarningsOf(flow.Filter), DescribeValue(number, value), check);
    check.Equal(flow.Filter->GetReport()->GetCount("FillValues"), number, "fill values");
    check.That(flow.Filter->GetReport()->GetNumber("FillValue") == value, "the value");
    flow.Compare(IsAtSea, check);
  }
  // Hidden points are not part of the field and cause no warning.
  check.SetContext("hidden land");
  HideLand(flow.Image);
  check.That(WarningsOf(flow.Filter).empty(), "no warning");
}

const double NonFiniteValues[] = { std::numeric_limits<double>::quiet_NaN(),
  std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };

/// NaN or infinity on land causes a warning, even if automatic settings are off.
void TestNonFinite(Check& check)
{
  for (const double value : NonFiniteValues)
  {
    FlowToPlane flow;
    check.SetContext("land of " + std::to_string(value));
    check.Equal(
      flow.Filter->GetReport()->GetCount("NonFiniteVectors"), 0, "non-finite vectors without land");
    const vtkIdType number = AddLand(flow.Image, value);
    CheckWarning(WarningsOf(flow.Filter), DescribeNonFinite(number), check);
    check.Equal(flow.Filter->GetReport()->GetCount("NonFiniteVectors"), number, "vectors");
    check.Equal(flow.Filter->GetReport()->GetCount("FillValues"), 0, "fill values");
    flow.Compare(IsAtSea, check);
    flow.Filter->SetMaximumError(flow.Error);
    flow.Filter->SetMinimumSpeed(1e-9);
    CheckWarning(WarningsOf(flow.Filter), DescribeNonFinite(number), check);
    HideLand(flow.Image);
    check.That(WarningsOf(flow.Filter).empty(), "no warning if the land is hidden");
    check.Equal(flow.Filter->GetReport()->GetCount("NonFiniteVectors"), 0,
      "non-finite vectors with hidden land");
  }
}

/// Land does not change convolution, critical points or vortex axes.
void TestOtherFilters(Check& check)
{
  // A vortex around the line x = y = 1.3.
  const auto swirl = [](const Vector& x)
  {
    return Vector{ { 1.3 - x[1] - 0.1 * (x[0] - 1.3), x[0] - 1.3 - 0.1 * (x[1] - 1.3),
      0.3 * (x[2] - 1.9) } };
  };
  const auto run = [&](vtkAlgorithm* filter, const char* name, vtkDataArray* (*get)(vtkAlgorithm*),
                     const std::function<vtkIdType(bool)>& count)
  {
    check.SetContext(name);
    auto image = MakeFlowImage(17, swirl);
    filter->SetInputDataObject(image);
    check.That(WarningsOf(filter).empty(), "no warning without land");
    vtkSmartPointer<vtkDataArray> expected = vtk::TakeSmartPointer(get(filter)->NewInstance());
    expected->DeepCopy(get(filter));
    for (const double value : { 1e20, -9999.0, NonFiniteValues[0], NonFiniteValues[1] })
    {
      const vtkIdType number = AddLand(image, value);
      CheckWarning(WarningsOf(filter),
        std::isfinite(value) ? DescribeValue(number, value) : DescribeNonFinite(number), check);
      check.That(count(std::isfinite(value)) > 0, "the report counts cells or points");
      vtkDataArray* found = get(filter);
      check.Equal(found->GetNumberOfTuples(), expected->GetNumberOfTuples(), "results");
      double largest = 0.0;
      for (vtkIdType i = 0; i < std::min(found->GetNumberOfTuples(), expected->GetNumberOfTuples());
           ++i)
      {
        const bool isFar = found->GetNumberOfComponents() == 3 || i / 17 % 17 < 4;
        for (int c = 0; isFar && c < found->GetNumberOfComponents(); ++c)
        {
          largest =
            std::max(largest, std::abs(found->GetComponent(i, c) - expected->GetComponent(i, c)));
        }
      }
      check.Near(largest, 0.0, 1e-6, "maximum difference", 1.0);
    }
  };
  const auto getPoints = [](vtkAlgorithm* filter)
  { return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetPoints()->GetData(); };
  vtkNew<vtkFlowCriticalPoints> zeros;
  run(zeros, "critical points", getPoints,
    [&zeros](bool isFinite)
    {
      return isFinite ? zeros->GetReport()->GetNumber("FillValueCells")
                      : zeros->GetReport()->GetNumber("NonFiniteCells");
    });
  vtkNew<vtkVortexAxis> axis;
  axis->SetNumberOfPlanes(9);
  run(axis, "vortex axis", getPoints,
    [&axis](bool isFinite)
    {
      return isFinite ? axis->GetReport()->GetNumber("FillValueCells")
                      : axis->GetReport()->GetNumber("NonFiniteCells");
    });
  vtkNew<vtkFlowLIC> convolution;
  convolution->SetLength(0.3);
  run(
    convolution, "convolution",
    [](vtkAlgorithm* filter)
    {
      return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))
        ->GetPointData()
        ->GetArray("LIC");
    },
    [&](bool isFinite)
    {
      vtkInterlumeReport* report = convolution->GetReport();
      check.That(!isFinite || report->GetNumber("PointsAtRest") < 20, "points at rest");
      return isFinite ? report->GetNumber("FillValues") : report->GetNumber("NonFiniteVectors");
    });
}

/// A fill value in a corner is reported and does not change distant results.
void TestField(Check& check)
{
  check.SetContext("a corner");
  FlowToPlane flow;
  check.Equal(flow.Filter->GetReport()->GetCount("FillValues"), 0, "fill values");
  vtkDataArray* vectors = flow.Image->GetPointData()->GetVectors();
  vectors->SetTuple3(flow.Image->GetNumberOfPoints() - 1, 1e30, 1e30, 1e30);
  vectors->Modified();
  CheckWarning(WarningsOf(flow.Filter), DescribeValue(1, 1e30), check);
  check.Equal(flow.Filter->GetReport()->GetCount("FillValues"), 1, "fill values");
  flow.Compare([](const double* x) { return x[1] < 3.0 || x[2] < 3.0; }, check);
  flow.Filter->SetMaximumError(flow.Error);
  flow.Filter->SetMinimumSpeed(1e-9);
  check.That(WarningsOf(flow.Filter).empty(), "no warning without automatic settings");
}

/// Fill values do not displace an inflow surface, whose position depends on the flow.
void TestInflow(Check& check)
{
  auto image = MakeFlowImage(17,
    [](const Vector& x) {
      return Vector{ { 2.0 + std::sin(x[1]), 0.1, 0.0 } };
    });
  std::array<double, 6> position;
  const auto find = [&](const std::string& name)
  {
    check.SetContext("inflow, " + name);
    vtkNew<vtkTerminationInflow> inflow;
    check.That(
      inflow->InitializeFromField(image, image->GetPointData()->GetVectors(), true).empty() &&
        inflow->Update().empty(),
      "an inflow surface is found");
    inflow->GetBounds(position.data());
  };
  find("real vectors");
  const std::array<double, 6> expected = position;
  check.That(expected[1] < 1.0, "the surface is at the inflow");
  const auto compare = [&](const std::string& name)
  {
    find(name);
    check.That(position[0] == expected[0] && position[1] == expected[1],
      "the surface is perpendicular to the flow");
  };
  image->GetPointData()->GetVectors()->SetTuple3(image->GetNumberOfPoints() / 2, 0.0, 1e30, 0.0);
  compare("one fill value");
  for (const double value : { 1e20, -9999.0, NonFiniteValues[0], NonFiniteValues[1] })
  {
    AddLand(image, value);
    compare("land of " + std::to_string(value));
    check.That(position[3] <= 3.0, "result without the land");
  }
}

}

int TestFlowFillValues(int, char*[])
{
  Check check;
  TestScale(check);
  TestRepeated(check);
  TestField(check);
  TestLand(check);
  TestNonFinite(check);
  TestOtherFilters(check);
  TestInflow(check);
  return check.Result();
}
