// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSelectionIds.h"

#include "vtkTimeWeightedTetrahedraMapper.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeRepresentationPreprocessor.h"

#include <algorithm>
#include <numeric>

namespace
{
/// Adds an array of ids that are not set.
vtkIdType* AddIds(vtkFieldData* to, const char* name, vtkIdType number)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(name);
  ids->SetNumberOfValues(number);
  to->AddArray(ids);
  return ids->GetPointer(0);
}

/// Returns the points and cells of a block with their ids as arrays.
vtkSmartPointer<vtkDataSet> CopyWithIds(vtkDataSet* block, unsigned int index)
{
  using Mapper = vtkTimeWeightedTetrahedraMapper;
  auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
  copy->CopyStructure(block);
  // Ghost cells are not drawn.
  const char* const ghosts = vtkDataSetAttributes::GhostArrayName();
  if (vtkDataArray* array = block->GetCellData()->GetArray(ghosts))
  {
    copy->GetCellData()->AddArray(array);
  }
  const vtkIdType cells = block->GetNumberOfCells();
  const vtkIdType points = block->GetNumberOfPoints();
  vtkIdType* ids = AddIds(copy->GetCellData(), Mapper::SelectionCellIds(), cells);
  std::iota(ids, ids + cells, 0);
  ids = AddIds(copy->GetCellData(), Mapper::SelectionBlockIds(), cells);
  std::fill_n(ids, cells, static_cast<vtkIdType>(index));
  ids = AddIds(copy->GetPointData(), Mapper::SelectionPointIds(), points);
  std::iota(ids, ids + points, 0);
  return copy;
}

vtkSmartPointer<vtkDataObject> CopyWithIds(vtkDataObject* input)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return CopyWithIds(vtkDataSet::SafeDownCast(input), 1);
  }
  auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    if (auto* data = vtkDataSet::SafeDownCast(block->GetCurrentDataObject()))
    {
      copy->SetDataSet(block, CopyWithIds(data, block->GetCurrentFlatIndex()));
    }
  }
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(copy))
  {
    // As in vtkIntervalVolumeRepresentation::GetInternalOutputPort().
    auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    collection->SetPartitionedDataSet(0, partitions);
    return collection;
  }
  return copy;
}
}

vtkSelectionIds::vtkSelectionIds()
{
  this->Preprocessor->SetTetrahedraOnly(1);
}

vtkSelectionIds::~vtkSelectionIds() = default;

vtkDataSet* vtkSelectionIds::Update(vtkDataObject* input, vtkUnstructuredGrid* tetrahedra)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (grid && grid->GetCells() == tetrahedra->GetCells())
  {
    return nullptr;
  }
  if (input != this->Input || input->GetMTime() != this->InputTime ||
    this->Preprocessor->GetMTime() != this->SettingsTime)
  {
    this->Preprocessor->SetInputDataObject(CopyWithIds(input));
    this->Preprocessor->Update();
    this->Input = input;
    this->InputTime = input->GetMTime();
    this->SettingsTime = this->Preprocessor->GetMTime();
  }
  return vtkDataSet::SafeDownCast(this->Preprocessor->GetOutputDataObject(0));
}
