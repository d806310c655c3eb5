// SPDX-License-Identifier: BSD-3-Clause
#include "Output/SimplexList.h"

#include "Common/ParallelFor.h"
#include "Output/ThreadGrain.h"

namespace interlume
{

template <typename Array>
vtkSmartPointer<Array> SimplexList::NewOffsets() const
{
  auto offsets = vtkSmartPointer<Array>::New();
  OutputAllocation::SetNumberOfTuples(offsets, this->Number + this->NumberOfInteriorCells + 1);
  return offsets;
}

template <typename Array>
vtkSmartPointer<Array> SimplexList::MakeOffsets(const vtkSmartPointer<Array>& interiorOffsets) const
{
  using Id = typename Array::ValueType;
  const vtkSmartPointer<Array> offsets =
    interiorOffsets ? interiorOffsets : this->NewOffsets<Array>();
  Id* values = offsets->GetPointer(0);
  const Id size = this->Size;
  const bool isStreamed = this->IsStreamed;
  vtkSMPTools::For(0, this->Number + (interiorOffsets ? 0 : 1), ThreadGrain,
    [values, size, isStreamed](vtkIdType first, vtkIdType last)
    { StridedIdBlock::FillMultiples(values, size, first, last, isStreamed); });
  return offsets;
}

void SimplexList::Allocate(vtkIdType number, int size, vtkIdType numberOfPoints,
  vtkIdType interiorCells, vtkIdType interiorIds)
{
  this->Number = number;
  this->Size = size;
  this->NumberOfInteriorCells = interiorCells;
  this->Narrow = {};
  this->Wide = {};
  const vtkIdType ids = number * size + interiorIds;
  const auto allocate = [&](auto& list)
  {
    using Array = std::decay_t<decltype(*list.Values)>;
    list.Values = vtkSmartPointer<Array>::New();
    OutputAllocation::SetNumberOfTuples(list.Values, ids);
    if (interiorCells > 0)
    {
      list.Offsets = this->NewOffsets<Array>();
      Set(list.Offsets->GetPointer(0)[number + interiorCells], ids);
    }
  };
  CanUse32BitStorage(numberOfPoints, ids) ? allocate(this->Narrow) : allocate(this->Wide);
  this->FindIds();
}

void SimplexList::NumberConsecutively()
{
  this->Visit(
    [this](auto* values)
    {
      ParallelFor(
        0, this->Number * this->Size, ThreadGrain, [values](vtkIdType at) { Set(values[at], at); });
    });
}

void SimplexList::Truncate(vtkIdType number)
{
  const vtkIdType removed = this->Number - number;
  const vtkIdType before = this->GetNumberOfIds();
  if (this->NumberOfInteriorCells > 0)
  {
    this->VisitIdsAndOffsets(
      [&](auto* values, auto* offsets)
      {
        std::copy(
          values + this->Number * this->Size, values + before, values + number * this->Size);
        for (vtkIdType cell = 0; cell <= this->NumberOfInteriorCells; ++cell)
        {
          Set(offsets[number + cell], offsets[this->Number + cell] - removed * this->Size);
        }
      });
  }
  this->Number = number;
  this->Shorten(before - removed * this->Size);
}

void SimplexList::RemoveInteriorCells(const std::vector<bool>& isRemoved)
{
  vtkIdType retained = 0;
  vtkIdType position = this->Number * this->Size;
  for (vtkIdType cell = 0; cell < this->NumberOfInteriorCells; ++cell)
  {
    const auto ids = this->GetInteriorIdRange(cell);
    if (!isRemoved[cell])
    {
      this->VisitIdsAndOffsets(
        [&](auto* values, auto* offsets)
        {
          std::copy(values + ids.first, values + ids.second, values + position);
          Set(offsets[this->Number + retained], position);
        });
      position += ids.second - ids.first;
      ++retained;
    }
  }
  this->VisitIdsAndOffsets(
    [&](auto*, auto* offsets) { Set(offsets[this->Number + retained], position); });
  this->NumberOfInteriorCells = retained;
  this->Shorten(position);
}

void SimplexList::RemovePoints(const RetainedIdRanges& retained, vtkIdType numberOfPoints)
{
  this->Visit(
    [&](auto* values)
    {
      ExtractionBuffer<std::decay_t<decltype(*values)>> newIds;
      newIds.Allocate(numberOfPoints);
      retained.FillIds(newIds.GetData());
      ParallelFor(0, this->GetNumberOfIds(), ThreadGrain,
        [values, ids = newIds.GetData()](vtkIdType i) { values[i] = ids[values[i]]; });
    });
}

vtkSmartPointer<vtkCellArray> SimplexList::MakeCells()
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  this->VisitList(
    [&](const auto& list) { cells->SetData(this->MakeOffsets(list.Offsets), list.Values); });
  return cells;
}

SimplexList SimplexList::CopySimplices() const
{
  SimplexList copy;
  copy.Allocate(
    this->Number, this->Size, this->Wide.Values ? std::numeric_limits<vtkIdType>::max() : 0);
  copy.Visit(
    [this](auto* values)
    {
      for (vtkIdType at = 0; at < this->Number * this->Size; ++at)
      {
        Set(values[at], this->GetIdAt(at));
      }
    });
  return copy;
}

void SimplexList::FindIds()
{
  this->Narrow.FindIds();
  this->Wide.FindIds();
  this->IsStreamed = this->Size == 4 && this->Narrow.Ids &&
    StridedIdBlock::ShouldStream(this->Narrow.Ids, this->Number);
}

void SimplexList::Shorten(vtkIdType ids)
{
  this->VisitList(
    [&](const auto& list)
    {
      OutputAllocation::Shorten(list.Values, ids);
      if (list.Offsets)
      {
        OutputAllocation::Shorten(list.Offsets, this->Number + this->NumberOfInteriorCells + 1);
      }
    });
  this->FindIds();
}

}
