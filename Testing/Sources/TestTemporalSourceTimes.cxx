// SPDX-License-Identifier: BSD-3-Clause
// Time steps are reported to the pipeline, and any requested time yields the field at that time. An
// invalid time causes an error and an empty output.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/TimeVarying/ReferenceTemporalSource.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace reference;
using Pipeline = vtkStreamingDemandDrivenPipeline;

void CheckSteps(const TemporalSource& source, const std::vector<double>& expected, Check& check)
{
  source.Algorithm->UpdateInformation();
  vtkInformation* info = source.Algorithm->GetOutputInformation(0);
  const int number = info->Length(Pipeline::TIME_STEPS());
  check.Equal(number, static_cast<int>(expected.size()), "number of time steps");
  for (int i = 0; i < number && i < static_cast<int>(expected.size()); ++i)
  {
    check.Near(info->Get(Pipeline::TIME_STEPS(), i), expected[i], 1e-15, "a time step", 1.0);
  }
  check.That(info->Get(Pipeline::TIME_RANGE(), 0) == expected.front() &&
      info->Get(Pipeline::TIME_RANGE(), 1) == expected.back(),
    "the time range covers the time steps");
}

void CheckTime(const TemporalSource& source, double time, Check& check)
{
  check.SetContext(source.Name + ", time " + std::to_string(time));
  vtkDataArray* values = source.GetValues();
  check.That(source.GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == time,
    "the output has the time");
  double worst = 0.0;
  for (vtkIdType point = 0; point < values->GetNumberOfTuples(); ++point)
  {
    double x[3];
    source.GetOutput()->GetPoint(point, x);
    reference::KeepLargest(worst, std::fabs(values->GetTuple1(point) - source.Evaluate(x, time)));
  }
  check.Near(worst, 0.0, 1e-12, "difference from the field at the time", 1.0);
}

void CheckBadTime(const TemporalSource& source, Check& check)
{
  for (double time :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    check.Contains(
      CaptureErrors(source.Algorithm, [&]() { source.Algorithm->UpdateTimeStep(time); }),
      "not finite");
    check.Equal(source.GetOutput()->GetNumberOfPoints(), 0, "points for a non-finite time");
    source.Algorithm->UpdateTimeStep(0.0);
    check.That(source.GetOutput()->GetNumberOfPoints() > 0, "points for a finite time");
  }
}

}

int TestTemporalSourceTimes(int, char*[])
{
  Check check;
  for (const TemporalSource& source : MakeTemporalSources())
  {
    check.SetContext(source.Name);
    CheckSteps(source, { 0.0, 1.0, 2.0 }, check);
    source.SetOutputScalarType(VTK_DOUBLE);
    source.Algorithm->Update();
    CheckTime(source, 0.0, check);
    for (double time : { 1.0, 0.37, 2.0, -1.5, 40.25, 1.0 })
    {
      source.Algorithm->UpdateTimeStep(time);
      CheckTime(source, time, check);
    }
    check.SetContext(source.Name);
    source.SetNumberOfTimeSteps(5);
    source.SetTimeRange(-1.0, 0.6);
    CheckSteps(source, { -1.0, -0.6, -0.2, 0.2, 0.6 }, check);
    source.SetNumberOfTimeSteps(1);
    CheckSteps(source, { -1.0 }, check);
    source.SetNumberOfTimeSteps(4);
    source.SetTimeRange(0.5, 0.5);
    CheckSteps(source, { 0.5 }, check);
    CheckBadTime(source, check);
  }
  for (const TemporalSource& source : MakeTemporalSources())
  {
    source.SetOutputScalarType(VTK_DOUBLE);
    source.SetTimeRange(1.25, 3.0);
    source.Algorithm->Update();
    CheckTime(source, 1.25, check);
  }
  return check.Result();
}
