// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ImplicitFlowArrays.h"

#include "Common/ArrayCheck.h"
#include "Common/ArrayViews.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkPointData.h"

namespace interlume
{

static_assert(vtkFlowStatus::REACHED_SURFACE == 0, "IsReached compares with 0");

namespace
{
// Returns what is wrong with a point array of \a data, or nothing; \a typed is the array as an
// Array.
template <typename Array>
std::string FindArray(
  vtkDataSet* data, const char* name, int components, vtkSmartPointer<Array>& typed)
{
  const std::string wrong = ImplicitFlowArrays::CheckArray(data, name, components);
  if (wrong.empty())
  {
    typed = ArrayViews::Get<Array>(data->GetPointData()->GetArray(name));
  }
  return wrong;
}
}

std::string ImplicitFlowArrays::CheckArray(vtkDataSet* data, const char* name, int components)
{
  const std::string wrong =
    ArrayCheck::MakeSentence(ArrayCheck::FindPointFault(data, "input", name, components));
  return data->GetPointData()->HasArray(name) ? wrong : wrong + " It is no implicit flow field.";
}

std::map<int, std::array<bool, 2>> ImplicitFlowArrays::ReadFlags(vtkDataSet* data, const char* name)
{
  std::map<int, std::array<bool, 2>> periodicity;
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  const vtkIdType number =
    array && array->GetNumberOfComponents() == 3 ? array->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < number; ++i)
  {
    periodicity[static_cast<int>(array->GetComponent(i, 0))] = { { array->GetComponent(i, 1) != 0.0,
      array->GetComponent(i, 2) != 0.0 } };
  }
  return periodicity;
}

std::string ImplicitFlowArrays::Find(vtkDataSet* data)
{
  std::string wrong = FindArray(data, vtkFlowStatus::StatusArray(), 1, this->Statuses);
  wrong = wrong.empty() ? FindArray(data, vtkFlowStatus::IdArray(), 1, this->Ids) : wrong;
  wrong =
    wrong.empty() ? FindArray(data, vtkFlowStatus::ParametersArray(), 2, this->Parameters) : wrong;
  if (!wrong.empty())
  {
    return wrong;
  }
  const auto has = [data](const char* name) { return data->GetPointData()->GetArray(name); };
  wrong = has(vtkFlowStatus::TimeArray())
    ? FindArray(data, vtkFlowStatus::TimeArray(), 1, this->Times)
    : wrong;
  wrong = wrong.empty() && has(vtkFlowStatus::SideArray())
    ? FindArray(data, vtkFlowStatus::SideArray(), 1, this->Sides)
    : wrong;
  if (!wrong.empty())
  {
    return wrong;
  }
  vtkDataArray* surfaces = data->GetFieldData()->GetArray(vtkFlowStatus::SurfacesArray());
  if (!surfaces || surfaces->GetNumberOfComponents() != 3)
  {
    return std::string("The input has no field array \"") + vtkFlowStatus::SurfacesArray() +
      "\" of 3 components. It is no implicit flow field.";
  }
  this->Surfaces = ReadFlags(data, vtkFlowStatus::SurfacesArray());
  return {};
}

std::array<bool, 2> ImplicitFlowArrays::GetPeriodicity(int id) const
{
  const auto found = this->Surfaces.find(id);
  return found == this->Surfaces.end() ? std::array<bool, 2>{ { false, false } } : found->second;
}

}
