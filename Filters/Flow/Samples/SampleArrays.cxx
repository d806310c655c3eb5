// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SampleArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"

#include <type_traits>

namespace interlume
{

template <typename Visit>
void SampleArrays::ForEach(const vtkFlowSettings& settings, Visit&& visit)
{
  visit(this->Status, vtkFlowStatus::StatusArray(), 1);
  visit(this->Id, vtkFlowStatus::IdArray(), 1);
  visit(this->Parameters, vtkFlowStatus::ParametersArray(), 2);
  visit(this->Time, vtkFlowStatus::TimeArray(), 1);
  visit(this->Side, vtkFlowStatus::SideArray(), 1);
  const auto visitIf = [&visit](bool isStored, auto& array, const char* name)
  {
    if (isStored)
    {
      visit(array, name, 1);
    }
  };
  visitIf(settings.ComputeMaximumSpeed, this->MaximumSpeed, "MaximumSpeed");
  visitIf(settings.ComputeArcLength, this->ArcLength, "ArcLength");
  visitIf(settings.ComputeMeanVorticity, this->MeanVorticity, "MeanVorticity");
  this->Means.resize(settings.MeanArrays.size());
  for (std::size_t i = 0; i < this->Means.size(); ++i)
  {
    visit(this->Means[i], "Mean" + settings.MeanArrays[i], 1);
  }
  visitIf(settings.StoreStepCounts, this->Steps, "AdvectionSteps");
  visitIf(settings.StoreStepCounts, this->StiffSteps, "StiffSteps");
}

SampleArrays SampleArrays::Make(
  const vtkFlowSettings& settings, vtkFieldData* data, vtkIdType number, const std::string& prefix)
{
  SampleArrays arrays;
  arrays.ForEach(settings,
    [&](auto& array, const std::string& name, int components)
    {
      vtkNew<std::remove_reference_t<decltype(*array)>> made;
      made->SetName((prefix + name).c_str());
      made->SetNumberOfComponents(components);
      made->SetNumberOfTuples(number);
      data->AddArray(made);
      array = made;
    });
  return arrays;
}

SampleArrays SampleArrays::Find(const vtkFlowSettings& settings, vtkFieldData* data)
{
  SampleArrays arrays;
  arrays.ForEach(settings,
    [data](auto& array, const std::string& name, int)
    {
      array = std::remove_reference_t<decltype(*array)>::SafeDownCast(
        data->GetAbstractArray(name.c_str()));
    });
  return arrays;
}

template <typename Result, typename Visit>
void SampleArrays::ForEachQuantity(Result& result, Visit&& visit) const
{
  const auto visitIf = [&visit](vtkDoubleArray* array, auto& value)
  {
    if (array)
    {
      visit(array, value);
    }
  };
  visitIf(this->MaximumSpeed, result.MaximumSpeed);
  visitIf(this->ArcLength, result.ArcLength);
  visitIf(this->MeanVorticity, result.MeanVorticity);
  for (std::size_t i = 0; i < this->Means.size(); ++i)
  {
    visitIf(this->Means[i], result.Means[i]);
  }
}

void SampleArrays::Set(vtkIdType id, const AdvectionResult& result)
{
  this->Status->SetValue(id, static_cast<unsigned char>(result.Status));
  this->Id->SetValue(id, result.Id);
  this->Parameters->SetTypedTuple(id, result.Parameters);
  this->Time->SetValue(id, result.Time);
  this->ForEachQuantity(
    result, [id](vtkDoubleArray* array, double value) { array->SetValue(id, value); });
  if (this->Steps)
  {
    this->Steps->SetValue(id, result.Steps);
    this->StiffSteps->SetValue(id, result.StiffSteps);
  }
}

AdvectionResult SampleArrays::Get(vtkIdType id) const
{
  AdvectionResult result;
  result.Status = this->Status->GetValue(id);
  result.Id = this->Id->GetValue(id);
  this->Parameters->GetTypedTuple(id, result.Parameters);
  result.Time = this->Time->GetValue(id);
  result.Means.resize(this->Means.size());
  this->ForEachQuantity(
    result, [id](vtkDoubleArray* array, double& value) { value = array->GetValue(id); });
  result.Steps = this->Steps ? this->Steps->GetValue(id) : 0;
  result.StiffSteps = this->StiffSteps ? this->StiffSteps->GetValue(id) : 0;
  return result;
}

}
