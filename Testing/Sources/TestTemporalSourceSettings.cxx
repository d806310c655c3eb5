// SPDX-License-Identifier: BSD-3-Clause
// Setters clamp or reject invalid values and call Modified() only for real changes. Progress is
// reported, and an abort leaves an empty output.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/TimeVarying/ReferenceTemporalSource.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkDataSet.h"
#include "vtkDeltaWingSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTaperedCylinderSource.h"

#include <array>
#include <limits>

namespace
{

using namespace reference;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int Maximum = std::numeric_limits<int>::max();
constexpr int Minimum = std::numeric_limits<int>::min();

template <std::size_t Size, typename Value>
void CheckValues(const Value* found, const std::array<Value, Size>& expected,
  const std::string& what, Check& check)
{
  check.That(std::equal(expected.begin(), expected.end(), found), what);
}

void CheckCommon(const TemporalSource& source, Check& check)
{
  check.SetContext(source.Name);
  check.Equal(source.GetNumberOfTimeSteps(), 3, "default time steps");
  CheckValues<2>(source.GetTimeRange(), { { 0.0, 2.0 } }, "default time range", check);
  check.Equal(source.GetOutputScalarType(), VTK_FLOAT, "default type");
  check.That(source.GetArrayName() == source.DefaultArrayName, "default array name");

  source.SetNumberOfTimeSteps(0);
  check.Equal(source.GetNumberOfTimeSteps(), 1, "no time steps");
  source.SetNumberOfTimeSteps(Maximum);
  check.Equal(source.GetNumberOfTimeSteps(), 100000, "too many time steps");
  source.SetTimeRange(3.0, -1.0);
  CheckValues<2>(source.GetTimeRange(), { { -1.0, 3.0 } }, "times that are not ascending", check);
  for (double bad : { NaN, Infinity })
  {
    check.Contains(
      CaptureErrors(source.Algorithm, [&]() { source.SetTimeRange(0.0, bad); }), "not finite");
  }
  CheckValues<2>(source.GetTimeRange(), { { -1.0, 3.0 } }, "times after errors", check);
  source.SetOutputScalarType(VTK_INT);
  check.Equal(source.GetOutputScalarType(), VTK_FLOAT, "an invalid type is rejected");
  source.SetArrayName("pressure");
  check.That(source.GetArrayName() == "pressure", "array name");
  source.Algorithm->Update();
  check.That(
    source.GetOutput()->GetPointData()->HasArray("pressure"), "the array has the given name");
  for (const char* none : { "", static_cast<const char*>(nullptr) })
  {
    source.SetArrayName(none);
    check.That(source.GetArrayName() == source.DefaultArrayName, "no array name");
  }
  const vtkMTimeType before = source.Algorithm->GetMTime();
  source.SetArrayName(nullptr);
  source.SetTimeRange(-1.0, 3.0);
  source.SetNumberOfTimeSteps(100000);
  source.SetOutputScalarType(VTK_FLOAT);
  check.That(
    source.Algorithm->GetMTime() == before, "setting the same values does not modify the source");
}

void CheckGrid(Check& check)
{
  check.SetContext("lattice");
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetDimensions(0, Minimum, Maximum);
  CheckValues<6>(source->GetWholeExtent(), { { 0, 0, 0, 0, 0, 32767 } }, "dimensions", check);
  source->SetWholeExtent(5, 3, Minimum, Maximum, 1, 2);
  CheckValues<6>(
    source->GetWholeExtent(), { { 5, 5, -32768, 32767, 1, 2 } }, "whole extent", check);
  for (double bad : { NaN, Infinity, 0.0, -1.0 })
  {
    check.Contains(
      CaptureErrors(source, [&]() { source->SetBounds(0.0, 1.0, 0.0, bad, 0.0, 1.0); }), "axis 1");
  }
  CheckValues<6>(source->GetBounds(), { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } }, "bounds", check);
}

void CheckAnalytic(Check& check)
{
  check.SetContext("analytic");
  vtkNew<vtkAnalyticFieldSource> source;
  check.Equal(source->GetField(), vtkAnalyticFieldSource::VORTEX, "default field");
  source->SetField(-1);
  check.Equal(source->GetField(), 0, "a field index below the range");
  source->SetField(99);
  check.Equal(source->GetField(), vtkAnalyticFieldSource::GYROID, "a field index above the range");
  check.That(vtkAnalyticFieldSource::GetFieldName(5) == nullptr, "an invalid field has no name");
  source->SetGradient(NaN, Infinity, -1e9);
  CheckValues<3>(source->GetGradient(), { { 1.0, 1e6, -1e6 } }, "gradient", check);
  source->SetCenter(1.0, NaN, 2.0);
  CheckValues<3>(source->GetCenter(), { { 1.0, 0.0, 2.0 } }, "center", check);
  source->SetVelocity(-Infinity, 0.0, 0.0);
  CheckValues<3>(source->GetVelocity(), { { -1e6, 0.0, 0.0 } }, "velocity", check);
  source->SetConstant(1e7);
  source->SetRate(-1e7);
  source->SetRadius(NaN);
  source->SetGrowth(Infinity);
  check.That(source->GetConstant() == 1e6 && source->GetRate() == -1e6 &&
      source->GetRadius() == 0.4 && source->GetGrowth() == 1e6,
    "numbers");
}

void CheckGrids(Check& check)
{
  check.SetContext("cylinder");
  vtkNew<vtkTaperedCylinderSource> cylinder;
  CheckValues<3>(cylinder->GetDimensions(), { { 64, 64, 32 } }, "default dimensions", check);
  cylinder->SetDimensions(1, Minimum, Maximum);
  CheckValues<3>(cylinder->GetDimensions(), { { 2, 2, 32768 } }, "dimensions", check);
  cylinder->SetRadii(0.0, Infinity);
  CheckValues<2>(cylinder->GetRadii(), { { 0.05, 50.0 } }, "radii", check);
  cylinder->SetHeight(-1.0);
  cylinder->SetOuterRadius(1e9);
  cylinder->SetSpeed(0.0);
  cylinder->SetStrouhalNumber(2.0);
  check.That(cylinder->GetHeight() == 0.1 && cylinder->GetOuterRadius() == 200.0 &&
      cylinder->GetSpeed() == 0.001 && cylinder->GetStrouhalNumber() == 1.0,
    "numbers");
  cylinder->SetOuterRadius(0.2);
  const int outer[3] = { 1, 0, 0 };
  double x[3];
  cylinder->GetPosition(outer, x);
  check.Near(x[0], -100.0, 1e-12, "a cylinder radius too large for the grid is corrected");

  check.SetContext("wing");
  vtkNew<vtkDeltaWingSource> wing;
  CheckValues<3>(wing->GetDimensions(), { { 111, 126, 51 } }, "default dimensions", check);
  wing->SetSweepAngle(90.0);
  wing->SetBreakdownPosition(3.0);
  wing->SetBreakdownAmplitude(-1.0);
  wing->SetBreakdownFrequency(1e4);
  wing->SetSpiralFrequency(NaN);
  check.That(wing->GetSweepAngle() == 85.0 && wing->GetBreakdownPosition() == 2.0 &&
      wing->GetBreakdownAmplitude() == 0.0 && wing->GetBreakdownFrequency() == 1000.0 &&
      wing->GetSpiralFrequency() == 0.15,
    "numbers");
}

void CheckProgress(const TemporalSource& source, Check& check)
{
  check.SetContext(source.Name);
  ProgressWatch watch;
  ObserveProgress(source.Algorithm, watch);
  source.Algorithm->Update();
  CheckMonotonicProgress(watch, 10, check);
  check.That(watch.Progress.back() == 1.0, "progress increases to 1");
  for (double at : { 0.0, 0.6 })
  {
    watch = ProgressWatch();
    watch.AbortAt = at;
    source.Algorithm->SetAbortExecute(0);
    source.Algorithm->Modified();
    source.Algorithm->Update();
    check.Equal(source.GetOutput()->GetNumberOfPoints(), 0, "points after an abort");
    // Executives of newer VTK versions report progress 1 even for an aborted execution.
    if (watch.Progress.back() == 1.0)
    {
      watch.Progress.pop_back();
    }
    check.That(watch.Progress.back() < at + 0.1, "an abort stops the execution");
  }
  source.Algorithm->RemoveAllObservers();
  source.Algorithm->SetAbortExecute(0);
  source.Algorithm->Modified();
  source.Algorithm->Update();
  check.That(source.GetOutput()->GetNumberOfPoints() > 0, "the next execution is complete");
}

}

int TestTemporalSourceSettings(int, char*[])
{
  Check check;
  for (const TemporalSource& source : MakeTemporalSources())
  {
    CheckProgress(source, check);
    CheckCommon(source, check);
  }
  CheckGrid(check);
  CheckAnalytic(check);
  CheckGrids(check);
  return check.Result();
}
