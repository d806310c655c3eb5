// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ImplicitFlowArrays.h"

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
// ArrayType.
template <typename ArrayType>
std::string FindArray(
  vtkDataSet* data, const char* name, int components, vtkSmartPointer<ArrayType>& typed)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  const std::string start = std::string("The point array \"") + name + "\" ";
  if (!array)
  {
    return start + "is missing: the input is no implicit flow field.";
  }
  if (array->GetNumberOfComponents() != components)
  {
    return start + "has " + std::to_string(array->GetNumberOfComponents()) + " components; " +
      std::to_string(components) + " are needed.";
  }
  if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    return start + "has " + std::to_string(array->GetNumberOfTuples()) + " tuples for " +
      std::to_string(data->GetNumberOfPoints()) + " points.";
  }
  typed = ArrayType::SafeDownCast(array);
  if (!typed)
  {
    typed = vtkSmartPointer<ArrayType>::New();
    typed->DeepCopy(array);
  }
  return {};
}
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
    return std::string("The field array \"") + vtkFlowStatus::SurfacesArray() +
      "\" of 3 components is missing: the input is no implicit flow field.";
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
