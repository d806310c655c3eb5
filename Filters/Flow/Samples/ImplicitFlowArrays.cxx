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
// Finds a point array of \a data with type Array. Returns an error as CheckArray does.
template <typename Array>
Error FindArray(vtkDataSet* data, const char* name, int components, vtkSmartPointer<Array>& typed)
{
  Error error = ImplicitFlowArrays::CheckArray(data, name, components);
  if (!error)
  {
    typed = ArrayViews::Get<Array>(data->GetPointData()->GetArray(name));
  }
  return error;
}
}

Error ImplicitFlowArrays::CheckArray(vtkDataSet* data, const char* name, int components)
{
  const Error error =
    ArrayCheck::MakeSentence(ArrayCheck::FindPointError(data, "input", name, components));
  return data->GetPointData()->HasArray(name)
    ? error
    : error.Within("", " Pass the output of vtkImplicitFlowField.");
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

Error ImplicitFlowArrays::Find(vtkDataSet* data)
{
  const auto findIfThere = [data](const char* name, auto& typed)
  { return data->GetPointData()->GetArray(name) ? FindArray(data, name, 1, typed) : Error(); };
  for (const Error& error : { FindArray(data, vtkFlowStatus::StatusArray(), 1, this->Statuses),
         FindArray(data, vtkFlowStatus::IdArray(), 1, this->Ids),
         FindArray(data, vtkFlowStatus::ParametersArray(), 2, this->Parameters),
         findIfThere(vtkFlowStatus::TimeArray(), this->Times),
         findIfThere(vtkFlowStatus::SideArray(), this->Sides) })
  {
    if (error)
    {
      return error;
    }
  }
  vtkDataArray* surfaces = data->GetFieldData()->GetArray(vtkFlowStatus::SurfacesArray());
  if (!surfaces || surfaces->GetNumberOfComponents() != 3)
  {
    return std::string("The input has no field array \"") + vtkFlowStatus::SurfacesArray() +
      "\" with 3 components. Pass the output of vtkImplicitFlowField.";
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
