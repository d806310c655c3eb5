// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/FieldInput.h"

#include "Cells/MultilinearCell.h"
#include "Common/Blanking.h"
#include "Fields/MergedDataSets.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace interlume
{

namespace
{
bool HasVolume(vtkDataSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!MultilinearCell::IsFlat(data->GetCellType(cell)))
    {
      return true;
    }
  }
  return false;
}
}

FieldInput::FieldInput(vtkDataObject* input)
  : DataSet{ vtkDataSet::SafeDownCast(input) }
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
      if (leaf && leaf->GetNumberOfCells() > 0)
      {
        this->Blocks.push_back({ { leaf }, leaves->GetCurrentFlatIndex() });
      }
    }
    // If some blocks have three-dimensional cells, all other blocks are assumed to be boundary
    // patches and ignored.
    const auto firstFlat = std::stable_partition(this->Blocks.begin(), this->Blocks.end(),
      [](const Block& block) { return HasVolume(block.Selection.Data); });
    if (firstFlat != this->Blocks.begin())
    {
      this->Blocks.erase(firstFlat, this->Blocks.end());
    }
  }
}

void FieldInput::SelectVectors(CellArrayConversion& conversion)
{
  if (this->DataSet.Data)
  {
    this->DataSet = conversion.Select(this->DataSet.Data);
  }
  for (Block& block : this->Blocks)
  {
    block.Selection = conversion.Select(block.Selection.Data);
  }
}

bool FieldInput::IsComposite(vtkDataObject* input)
{
  return vtkCompositeDataSet::SafeDownCast(input) != nullptr;
}

vtkSmartPointer<vtkDataSet> FieldInput::MakeField() const
{
  if (this->Blocks.empty())
  {
    return this->DataSet.Data;
  }
  if (this->Blocks.size() == 1)
  {
    return this->Blocks[0].Selection.Data;
  }
  return MergedDataSets::Merge(this->GetData());
}

bool FieldInput::HasHidden() const
{
  std::vector<vtkDataSet*> parts = this->GetData();
  if (this->DataSet.Data)
  {
    parts.push_back(this->DataSet.Data);
  }
  return std::any_of(parts.begin(), parts.end(),
    [](vtkDataSet* data)
    {
      Blanking blanking;
      blanking.SetBlanking(data);
      bool isHidden = false;
      for (vtkIdType cell = 0; blanking.CellGhosts && cell < data->GetNumberOfCells(); ++cell)
      {
        isHidden = isHidden || blanking.IsCellHidden(cell);
      }
      for (vtkIdType point = 0; blanking.PointGhosts && point < data->GetNumberOfPoints(); ++point)
      {
        isHidden = isHidden || blanking.IsPointBlanked(point);
      }
      return isHidden;
    });
}

bool FieldInput::HasOnlyFlatBlocks() const
{
  return !this->Blocks.empty() && !HasVolume(this->Blocks[0].Selection.Data);
}

vtkSmartPointer<vtkDataSet> FieldInput::MakePart() const
{
  if (this->DataSet.Data)
  {
    return this->DataSet.Data;
  }
  if (this->Blocks.empty() || this->HasOnlyFlatBlocks())
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  return MergedDataSets::Merge(this->GetData());
}

std::vector<vtkDataSet*> FieldInput::GetData() const
{
  std::vector<vtkDataSet*> parts;
  for (const Block& block : this->Blocks)
  {
    parts.push_back(block.Selection.Data);
  }
  return parts;
}

vtkSmartPointer<vtkDataSet> FieldInput::MakeSamples(vtkDataSet* field) const
{
  if (this->Blocks.empty() || vtkUnstructuredGrid::SafeDownCast(field))
  {
    return field;
  }
  return MergedDataSets::Merge({ field });
}

}
