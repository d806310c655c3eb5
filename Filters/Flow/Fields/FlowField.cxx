// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/FlowField.h"

#include "Common/ArrayCheck.h"
#include "Common/Blanking.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>

namespace interlume
{

namespace
{

Error FindError(vtkDataSet* data, vtkDataArray* array, const char* what, int components)
{
  return array ? ArrayCheck::FindPointError(data, array, components)
               : std::string("there is no array of ") + what;
}

}

Error FlowField::SetArrays(
  vtkDataSet* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays)
{
  if (Error error = FindError(data, vectors, "vectors", 3))
  {
    return error;
  }
  for (vtkDataArray* array : arrays)
  {
    if (Error error = FindError(data, array, "numbers", 1))
    {
      return error;
    }
  }
  this->Vectors.Build(vectors);
  this->Arrays.resize(arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    this->Arrays[i].Build(arrays[i]);
  }
  this->NumberOfCells = data->GetNumberOfCells();
  data->GetBounds(this->Bounds);
  return {};
}

void FlowField::SetBlanking(vtkDataSet* data, const CellPoints& cells)
{
  Blanking blanking;
  blanking.SetBlanking(data);
  if (!blanking.HasBlanking())
  {
    return;
  }
  this->Excluded.assign(this->NumberOfCells, 0);
  vtkSMPTools::For(0, this->NumberOfCells,
    [&](vtkIdType first, vtkIdType last)
    {
      vtkIdType points[8];
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        bool isExcluded = blanking.IsCellHidden(cell);
        const int number = blanking.PointGhosts && !isExcluded ? cells(cell, points) : 0;
        for (int v = 0; v < number; ++v)
        {
          isExcluded = isExcluded || blanking.IsPointBlanked(points[v]);
        }
        this->Excluded[cell] = isExcluded;
      }
    });
}

void FlowField::ExcludeFlatCell(vtkIdType cell)
{
  this->Excluded.resize(static_cast<std::size_t>(this->NumberOfCells), 0);
  this->Excluded[static_cast<std::size_t>(cell)] = 1;
  ++this->NumberOfFlatCells;
}

void FlowField::Measure(const CellPoints& cells, bool hasOtherPoints)
{
  this->SetSpeeds(this->CountSpeeds(cells, hasOtherPoints));
}

SpeedCount FlowField::CountSpeeds(const CellPoints& cells, bool hasOtherPoints,
  const std::function<bool(vtkIdType)>& isCounted) const
{
  // Vectors at points that belong to no cell of the field must be ignored.
  const bool isPart = hasOtherPoints || !this->Excluded.empty();
  std::vector<std::atomic<bool>> isUsed(isPart ? this->Vectors.GetNumber() : 0);
  if (isPart)
  {
    vtkSMPTools::For(0, this->NumberOfCells,
      [&](vtkIdType first, vtkIdType last)
      {
        vtkIdType points[8];
        for (vtkIdType cell = first; cell < last; ++cell)
        {
          const int number = this->IsCellIncluded(cell) ? cells(cell, points) : 0;
          for (int v = 0; v < number; ++v)
          {
            isUsed[points[v]].store(true, std::memory_order_relaxed);
          }
        }
      });
  }
  vtkSMPThreadLocal<SpeedCount> sums;
  vtkSMPTools::For(0, this->Vectors.GetNumber(),
    [&](vtkIdType first, vtkIdType last)
    {
      SpeedCount& sum = sums.Local();
      for (vtkIdType point = first; point < last; ++point)
      {
        if ((isPart && !isUsed[point].load(std::memory_order_relaxed)) ||
          (isCounted && !isCounted(point)))
        {
          continue;
        }
        double v[3];
        this->GetVector(point, v);
        sum.Add(v);
      }
    });
  SpeedCount all;
  for (const SpeedCount& sum : sums)
  {
    all.Add(sum);
  }
  return all;
}

void FlowField::SetSpeeds(const SpeedCount& count)
{
  this->MaximumSpeed = count.Speeds.GetLargest();
  this->Fill = count.Speeds.FindFillValues();
  this->NumberOfNonFiniteVectors = count.NonFinite;
}

}
