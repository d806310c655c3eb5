// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/FieldSampler.h"

#include "Common/NamedValue.h"
#include "Sampling/ExtentRows.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace interlume
{

namespace
{
template <typename Value>
void Assign(Value& member, const Value& value, vtkAlgorithm* owner)
{
  if (member != value)
  {
    member = value;
    owner->Modified();
  }
}
}

Error FieldSampler::SetTimeRange(double (&range)[2], double first, double last, vtkAlgorithm* owner)
{
  if (!std::isfinite(first) || !std::isfinite(last))
  {
    std::ostringstream words;
    words << "The time range " << first << " to " << last << " is not finite.";
    return words.str();
  }
  Assign(range[0], std::min(first, last), owner);
  Assign(range[1], std::max(first, last), owner);
  return {};
}

void FieldSampler::SetScalarType(int& member, int type, vtkAlgorithm* owner)
{
  Assign(member, type == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT, owner);
}

void FieldSampler::SetArrayName(
  std::string& member, const char* name, const char* defaultName, vtkAlgorithm* owner)
{
  Assign(member, std::string(name && *name ? name : defaultName), owner);
}

void FieldSampler::FillInformation(vtkInformation* output, const int wholeExtent[6]) const
{
  // A time range of zero length has one time step.
  const double length = this->TimeRange[1] - this->TimeRange[0];
  const int number = length > 0.0 ? this->NumberOfTimeSteps : 1;
  std::vector<double> times(number, this->TimeRange[0]);
  for (int i = 1; i < number; ++i)
  {
    times[i] =
      i == number - 1 ? this->TimeRange[1] : this->TimeRange[0] + length * i / (number - 1);
  }
  const double range[2] = { times.front(), times.back() };
  output->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), number);
  output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), wholeExtent, 6);
  output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(output, this->ScalarType, 1);
}

Error FieldSampler::FindTime(vtkInformation* output, double& time) const
{
  const auto key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  time = output->Has(key) ? output->Get(key) : this->TimeRange[0];
  std::ostringstream words;
  if (!std::isfinite(time))
  {
    words << "The requested time, " << time << ", is not finite.";
  }
  return words.str();
}

bool FieldSampler::Sample(vtkDataSet* output, const int extent[6], double time, const Field& field,
  const Positions& positions, vtkAlgorithm* owner) const
{
  vtkSmartPointer<vtkDataArray> values =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->ScalarType));
  values->SetName(this->ArrayName);
  values->SetNumberOfTuples(output->GetNumberOfPoints());

  const auto sampleRow = [&](int j, int k, vtkIdType point)
  {
    for (int i = extent[0]; i <= extent[1]; ++i, ++point)
    {
      const int ijk[3] = { i, j, k };
      double x[3];
      positions(ijk, point, x);
      values->SetComponent(point, 0, field(x));
    }
  };
  if (!ExtentRows::Run(extent, owner, 0.0, 1.0, sampleRow))
  {
    return false;
  }
  output->GetPointData()->SetScalars(values);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  owner->UpdateProgress(1.0);
  return true;
}

void FieldSampler::Print(std::ostream& os, vtkIndent indent) const
{
  NamedValue::Print(os, indent,
    { { "NumberOfTimeSteps", this->NumberOfTimeSteps }, { "TimeRange", this->TimeRange },
      { "OutputScalarType", this->ScalarType == VTK_DOUBLE ? "double" : "float" },
      { "ArrayName", this->ArrayName } });
}

}
