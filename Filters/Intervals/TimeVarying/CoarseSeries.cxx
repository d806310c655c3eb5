// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/CoarseSeries.h"

#include "Static/DataSetLeaves.h"
#include "Static/GridSampling.h"

#include "vtkDataSet.h"
#include "vtkMultiBlockDataSet.h"

#include <algorithm>
#include <numeric>

namespace interlume
{

namespace
{
vtkSmartPointer<vtkDataSet> Copy(vtkDataSet* leaf, int stride)
{
  vtkSmartPointer<vtkDataSet> copy = stride > 1 ? GridSampling::Sample(leaf, stride) : nullptr;
  if (!copy)
  {
    // The source may write the next step into the same arrays.
    copy.TakeReference(leaf->NewInstance());
    copy->DeepCopy(leaf);
  }
  return copy;
}

vtkSmartPointer<vtkDataObject> CopyStep(vtkDataObject* input, int stride)
{
  if (!vtkCompositeDataSet::SafeDownCast(input))
  {
    return Copy(vtkDataSet::SafeDownCast(input), stride);
  }
  // The run needs only the order of the leaves.
  const std::vector<vtkDataSet*> leaves = DataSetLeaves::Get(input);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(leaves.size()));
  for (unsigned int i = 0; i < leaves.size(); ++i)
  {
    blocks->SetBlock(i, leaves[i] ? Copy(leaves[i], stride).GetPointer() : nullptr);
  }
  return blocks;
}

// Returns the number of cells of coarse copies. Datasets that are not structured keep their cells.
vtkIdType CountCells(const std::vector<vtkDataSet*>& leaves, int stride)
{
  return std::accumulate(leaves.begin(), leaves.end(), vtkIdType(0),
    [stride](vtkIdType sum, vtkDataSet* leaf)
    { return sum + (leaf ? GridSampling::CountCells(leaf, stride) : 0); });
}
}

bool CoarseSeries::Begin(const Key& key)
{
  if (this->State == key && this->IsComplete())
  {
    return true;
  }
  this->State = key;
  this->Steps.clear();
  return false;
}

std::size_t CoarseSeries::GetNumberOfSteps() const
{
  const std::size_t slabs = this->State.Steps.size() - 1;
  const auto stride = static_cast<std::size_t>(this->TimeStride);
  return (slabs + stride - 1) / stride + 1;
}

void CoarseSeries::ChooseStrides(vtkDataObject* input)
{
  if (!this->Steps.empty())
  {
    return;
  }
  const std::vector<vtkDataSet*> leaves = DataSetLeaves::Get(input);
  const int slabs = static_cast<int>(this->State.Steps.size()) - 1;
  this->TimeStride = 1;
  this->Stride = 1;
  vtkIdType cells = CountCells(leaves, 1);
  const auto isTooLarge = [&]
  { return cells * static_cast<vtkIdType>(this->GetNumberOfSteps() - 1) > this->State.Limit; };
  // Increase both strides in turn.
  bool isReduced = true;
  while (isReduced && isTooLarge())
  {
    isReduced = this->TimeStride < slabs;
    this->TimeStride += isReduced ? 1 : 0;
    if (isTooLarge())
    {
      const vtkIdType fewer = CountCells(leaves, this->Stride + 1);
      isReduced = isReduced || fewer < cells;
      this->Stride += fewer < cells ? 1 : 0;
      cells = fewer;
    }
  }
}

Error CoarseSeries::AddStep(
  vtkDataObject* input, TimeVaryingRun& run, TimeVaryingRun::Results& result)
{
  if (!this->IsComplete())
  {
    this->Steps.push_back(CopyStep(input, this->Stride));
    return run.AddStep(this->Steps.back(), result);
  }
  Error error;
  result = TimeVaryingRun::DONE;
  for (std::size_t i = 0; i < this->Steps.size() && result == TimeVaryingRun::DONE; ++i)
  {
    error = run.AddStep(this->Steps[i], result);
  }
  return error;
}

}
