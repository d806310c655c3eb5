// SPDX-License-Identifier: BSD-3-Clause
#include "Checkpoint/StreamlineRecord.h"

#include "Common/DataDigest.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace interlume
{

namespace
{
constexpr const char* NumbersArray = "GroupStreamlines";
constexpr const char* DigestsArray = "GroupDigests";
constexpr const char* DigestArray = "Digest";

template <typename Number>
using Member = std::pair<const char*, Number AdvectionEnd::*>;

constexpr Member<int> IntMembers[] = { { "Status", &AdvectionEnd::Status },
  { "Id", &AdvectionEnd::Id }, { "Steps", &AdvectionEnd::Steps },
  { "RejectedSteps", &AdvectionEnd::RejectedSteps }, { "StiffSteps", &AdvectionEnd::StiffSteps },
  { "RejectedStiffSteps", &AdvectionEnd::RejectedStiffSteps },
  { "SimdSteps", &AdvectionEnd::SimdSteps }, { "Evaluations", &AdvectionEnd::Evaluations },
  { "JacobianEvaluations", &AdvectionEnd::JacobianEvaluations },
  { "DistanceEvaluations", &AdvectionEnd::DistanceEvaluations },
  { "Cells", &AdvectionEnd::Cells } };

constexpr Member<double> DoubleMembers[] = { { "Time", &AdvectionEnd::Time },
  { "MaximumSpeed", &AdvectionEnd::MaximumSpeed }, { "ArcLength", &AdvectionEnd::ArcLength },
  { "MeanVorticity", &AdvectionEnd::MeanVorticity }, { "Nearness", &AdvectionEnd::Nearness } };

static_assert(sizeof(AdvectionEnd) <= 11 * sizeof(int) + 10 * sizeof(double) + 4,
  "each member of AdvectionEnd needs a column");

std::string GetDigest(const std::vector<vtkDataArray*>& columns)
{
  DataDigest digest;
  for (vtkDataArray* column : columns)
  {
    digest.Add(column);
  }
  return digest.Take();
}
}

StreamlineRecord::StreamlineRecord(int means)
  : NumberOfMeans(means)
{
  static_assert(std::size(IntMembers) == NumberOfInts, "one column per member");
  static_assert(std::size(DoubleMembers) == NumberOfDoubles, "one column per member");
  for (std::size_t i = 0; i < NumberOfInts; ++i)
  {
    this->Ints[i]->SetName(IntMembers[i].first);
  }
  for (std::size_t i = 0; i < NumberOfDoubles; ++i)
  {
    this->Doubles[i]->SetName(DoubleMembers[i].first);
  }
  this->Parameters->SetName("Parameters");
  this->Parameters->SetNumberOfComponents(2);
  this->Position->SetName("Position");
  this->Position->SetNumberOfComponents(3);
  this->Means->SetName("Means");
  this->Means->SetNumberOfComponents(std::max(1, means));
}

StreamlineRecord::~StreamlineRecord() = default;

std::vector<vtkDataArray*> StreamlineRecord::GetColumns() const
{
  std::vector<vtkDataArray*> columns(this->Ints.begin(), this->Ints.end());
  columns.insert(columns.end(), this->Doubles.begin(), this->Doubles.end());
  columns.insert(columns.end(), { this->Parameters.Get(), this->Position.Get() });
  if (this->NumberOfMeans > 0)
  {
    columns.push_back(this->Means);
  }
  return columns;
}

void StreamlineRecord::SetCapacity(vtkIdType rows)
{
  for (vtkDataArray* column : this->GetColumns())
  {
    // Resize preserves the values, unlike SetNumberOfTuples.
    column->Resize(rows);
    column->SetNumberOfTuples(rows);
  }
}

vtkIdType StreamlineRecord::BeginGroup(
  vtkIdType number, const std::string& digest, bool& isDifferent)
{
  if (this->HasBegun)
  {
    this->First += this->Groups[this->Current].Number;
    ++this->Current;
  }
  this->HasBegun = true;
  const bool exists = this->Current < this->Groups.size();
  isDifferent = exists &&
    (this->Groups[this->Current].Number != number || this->Groups[this->Current].Digest != digest);
  if (!exists || isDifferent)
  {
    this->Groups.resize(this->Current);
    this->Groups.push_back({ number, digest });
    this->Rows = std::min(this->Rows, this->First);
  }
  const vtkIdType recorded = std::clamp<vtkIdType>(this->Rows - this->First, 0, number);
  if (recorded < number)
  {
    this->SetCapacity(this->First + number);
  }
  return recorded;
}

void StreamlineRecord::Get(vtkIdType i, AdvectionResult& result) const
{
  const vtkIdType row = this->First + i;
  for (std::size_t column = 0; column < NumberOfInts; ++column)
  {
    result.*IntMembers[column].second = this->Ints[column]->GetValue(row);
  }
  for (std::size_t column = 0; column < NumberOfDoubles; ++column)
  {
    result.*DoubleMembers[column].second = this->Doubles[column]->GetValue(row);
  }
  this->Parameters->GetTypedTuple(row, result.Parameters);
  this->Position->GetTypedTuple(row, result.Position);
  result.Means.resize(static_cast<std::size_t>(this->NumberOfMeans));
  if (this->NumberOfMeans > 0)
  {
    this->Means->GetTypedTuple(row, result.Means.data());
  }
}

void StreamlineRecord::Set(vtkIdType i, const AdvectionResult& result)
{
  const vtkIdType row = this->First + i;
  for (std::size_t column = 0; column < NumberOfInts; ++column)
  {
    this->Ints[column]->SetValue(row, result.*IntMembers[column].second);
  }
  for (std::size_t column = 0; column < NumberOfDoubles; ++column)
  {
    this->Doubles[column]->SetValue(row, result.*DoubleMembers[column].second);
  }
  this->Parameters->SetTypedTuple(row, result.Parameters);
  this->Position->SetTypedTuple(row, result.Position);
  for (int mean = 0; mean < this->NumberOfMeans; ++mean)
  {
    const auto at = static_cast<std::size_t>(mean);
    this->Means->SetTypedComponent(row, mean, at < result.Means.size() ? result.Means[at] : 0.0);
  }
}

void StreamlineRecord::SetNumberOfFinished(vtkIdType number)
{
  this->Rows = std::max(this->Rows, this->First + number);
}

void StreamlineRecord::Clear()
{
  this->Groups.clear();
  this->Rows = 0;
}

void StreamlineRecord::Write(vtkTable* table) const
{
  std::vector<vtkDataArray*> columns;
  for (vtkDataArray* column : this->GetColumns())
  {
    auto view = vtk::TakeSmartPointer(column->NewInstance());
    view->SetName(column->GetName());
    view->SetNumberOfComponents(column->GetNumberOfComponents());
    // The view shares the memory of the column.
    view->SetVoidArray(column->GetVoidPointer(0), this->Rows * column->GetNumberOfComponents(), 1);
    table->AddColumn(view);
    columns.push_back(view);
  }
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(NumbersArray);
  vtkNew<vtkStringArray> digests;
  digests->SetName(DigestsArray);
  for (const Group& group : this->Groups)
  {
    numbers->InsertNextValue(group.Number);
    digests->InsertNextValue(group.Digest);
  }
  vtkNew<vtkStringArray> digest;
  digest->SetName(DigestArray);
  digest->InsertNextValue(GetDigest(columns));
  for (vtkAbstractArray* array :
    { static_cast<vtkAbstractArray*>(numbers.Get()), static_cast<vtkAbstractArray*>(digests.Get()),
      static_cast<vtkAbstractArray*>(digest.Get()) })
  {
    table->GetFieldData()->AddArray(array);
  }
}

Error StreamlineRecord::Read(vtkTable* table)
{
  std::vector<vtkDataArray*> fileColumns;
  for (vtkDataArray* column : this->GetColumns())
  {
    auto* same = vtkDataArray::SafeDownCast(table->GetColumnByName(column->GetName()));
    if (!same || same->GetDataType() != column->GetDataType() ||
      same->GetNumberOfComponents() != column->GetNumberOfComponents())
    {
      return { std::string("the column ") + column->GetName() + " is missing or has another type",
        ErrorCode::File };
    }
    fileColumns.push_back(same);
  }
  vtkFieldData* data = table->GetFieldData();
  vtkDataArray* numbers = data->GetArray(NumbersArray);
  auto* digests = vtkStringArray::SafeDownCast(data->GetAbstractArray(DigestsArray));
  auto* digest = vtkStringArray::SafeDownCast(data->GetAbstractArray(DigestArray));
  const vtkIdType groups = numbers ? numbers->GetNumberOfTuples() : -1;
  if (groups < 0 || !digests || digests->GetNumberOfValues() != groups || !digest ||
    digest->GetNumberOfValues() != 1 || digest->GetValue(0) != GetDigest(fileColumns))
  {
    return { "its values do not match its digest", ErrorCode::File };
  }
  this->Rows = table->GetNumberOfRows();
  this->Groups.clear();
  for (vtkIdType i = 0; i < groups; ++i)
  {
    this->Groups.push_back(
      { static_cast<vtkIdType>(numbers->GetComponent(i, 0)), digests->GetValue(i) });
  }
  const std::vector<vtkDataArray*> columns = this->GetColumns();
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    columns[i]->ShallowCopy(fileColumns[i]);
  }
  return {};
}

}
