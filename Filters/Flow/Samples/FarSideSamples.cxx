// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/FarSideSamples.h"

#include "Samples/ImplicitFlowArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
vtkDataArray* Find(vtkDataSet* data, const char* name, int components, vtkIdType number)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(FarSideSamples::GetName(name).c_str());
  const bool isValid = array && array->GetNumberOfComponents() == components &&
    (number < 0 || array->GetNumberOfTuples() == number);
  return isValid ? array : nullptr;
}
}

void FarSideSamples::Remove(vtkFieldData* data)
{
  const std::string prefix = vtkFlowStatus::FarSidePrefix();
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const char* name = data->GetArrayName(i);
    if (name && std::string(name).compare(0, prefix.size(), prefix) == 0)
    {
      data->RemoveArray(i);
    }
  }
}

FarSideSamples::FarSideSamples(vtkDataSet* data)
{
  this->Points = Find(data, Point, 1, -1);
  if (!this->Points || this->Points->GetNumberOfTuples() == 0)
  {
    return;
  }
  this->Number = this->Points->GetNumberOfTuples();
  vtkDataArray* positions = Find(data, Position, 3, this->Number);
  this->Distances = Find(data, Distance, 1, this->Number);
  this->Normals = Find(data, Normal, 3, this->Number);
  this->Surfaces = Find(data, Surface, 1, this->Number);
  this->Sides = Find(data, vtkFlowStatus::SideArray(), 1, this->Number);
  this->Ids = Find(data, vtkFlowStatus::IdArray(), 1, this->Number);
  this->Times = Find(data, vtkFlowStatus::TimeArray(), 1, this->Number);
  const bool isComplete = positions && this->Distances && this->Normals && this->Surfaces &&
    this->Sides && this->Ids && this->Times &&
    Find(data, vtkFlowStatus::ParametersArray(), 2, this->Number);
  if (!isComplete)
  {
    return;
  }
  const std::vector<vtkIdType> none(static_cast<std::size_t>(data->GetNumberOfPoints()), -1);
  std::array<std::vector<vtkIdType>, 2> rows{ { none, none } };
  for (vtkIdType row = 0; row < this->Number; ++row)
  {
    const vtkIdType point = this->GetPoint(row);
    double x[3];
    double before[3];
    positions->GetTuple(row, before);
    if (point < 0 || point >= data->GetNumberOfPoints())
    {
      return;
    }
    data->GetPoint(point, x);
    if (!std::equal(x, x + 3, before))
    {
      return;
    }
    rows[this->HasSurface(row) ? 0 : 1][static_cast<std::size_t>(point)] = row;
  }
  this->RowsOfPoints = std::move(rows);
}

vtkIdType FarSideSamples::GetPoint(vtkIdType row) const
{
  return static_cast<vtkIdType>(this->Points->GetComponent(row, 0));
}

double FarSideSamples::GetDistance(vtkIdType row) const
{
  return std::abs(this->Distances->GetComponent(row, 0));
}

int FarSideSamples::GetSide(vtkIdType row) const
{
  const double side = this->Sides->GetComponent(row, 0);
  return side > 0.0 ? 1 : (side < 0.0 ? -1 : 0);
}

bool FarSideSamples::IsAway(vtkIdType row) const
{
  return std::abs(this->Sides->GetComponent(row, 0)) == vtkFlowStatus::AWAY;
}

int FarSideSamples::GetId(vtkIdType row) const
{
  return static_cast<int>(this->Ids->GetComponent(row, 0));
}

double FarSideSamples::GetTimeToSurface(const ImplicitFlowArrays& arrays, vtkIdType row) const
{
  if (!this->HasSurface(row))
  {
    return 0.0;
  }
  if (this->IsAway(row))
  {
    return this->GetId(row) >= 0 ? this->Times->GetComponent(row, 0) : 0.0;
  }
  return arrays.IsReached(this->GetPoint(row)) ? arrays.GetTime(this->GetPoint(row)) : 0.0;
}

FarSideSamples::Parts FarSideSamples::GetParts(
  const ImplicitFlowArrays& arrays, const vtkIdType* corners, vtkIdType number) const
{
  Parts parts;
  const bool isBoundary = std::any_of(
    corners, corners + number, [this](vtkIdType p) { return this->GetRow(p, false) < 0; });
  for (vtkIdType i = 0; i < number; ++i)
  {
    const vtkIdType row = this->GetRow(corners[i], isBoundary);
    if (row < 0 || this->Surfaces->GetComponent(row, 0) == Stagnant ||
      this->Surfaces->GetComponent(row, 0) !=
        this->Surfaces->GetComponent(this->GetRow(corners[0], isBoundary), 0))
    {
      return parts;
    }
  }
  int sides = 0;
  bool isOn = false;
  parts.IsResolved = true;
  for (const int side : { 1, -1 })
  {
    Part part{ side, -1, true, true, isBoundary };
    vtkIdType onSide = 0;
    vtkIdType reached = 0;
    bool isOne = true;
    for (vtkIdType i = 0; i < number; ++i)
    {
      const vtkIdType row = this->GetRow(corners[i], isBoundary);
      isOn = isOn || this->GetSide(row) == 0;
      if (this->GetSide(row) != side)
      {
        continue;
      }
      const int id = arrays.GetId(corners[i]);
      isOne = isOne && (onSide == 0 || id == part.Id);
      part.Id = id;
      part.IsNear = part.IsNear && !this->IsAway(row);
      part.IsFar = part.IsFar && this->IsAway(row);
      ++onSide;
      reached += arrays.IsReached(corners[i]) ? 1 : 0;
    }
    sides += onSide > 0 ? 1 : 0;
    const bool isExtractable = onSide > 0 && isOne && reached == onSide;
    parts.All[side > 0 ? 0 : 1] = isExtractable ? part : Part();
    parts.IsResolved = parts.IsResolved && (isExtractable || reached == 0);
  }
  return sides == 2 || (sides == 1 && isOn) ? parts : Parts();
}

FarSideSamples::Roles FarSideSamples::GetRole(
  const ImplicitFlowArrays& arrays, vtkIdType corner, const Part& part) const
{
  const vtkIdType row = this->GetRow(corner, part.IsBoundary);
  const bool isReached = arrays.IsReached(corner) && arrays.GetId(corner) == part.Id;
  if (this->GetSide(row) == part.Side || (this->GetSide(row) == 0 && part.IsNear && isReached))
  {
    return OWN;
  }
  const bool extends = this->IsAway(row) ? part.IsNear : part.IsFar;
  return extends && this->GetId(row) == part.Id ? KNOWN : UNKNOWN;
}

}
