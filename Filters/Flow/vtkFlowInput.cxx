#include "vtkFlowInput.h"

#include "vtkFlowMerge.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkUnstructuredGrid.h"

//------------------------------------------------------------------------------
vtkFlowInput::vtkFlowInput(vtkDataObject* input)
  : Whole(vtkDataSet::SafeDownCast(input))
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
      if (leaf && leaf->GetNumberOfCells() > 0)
      {
        this->Blocks.push_back({ leaf, leaves->GetCurrentFlatIndex() });
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkFlowInput::IsComposite(vtkDataObject* input)
{
  return vtkCompositeDataSet::SafeDownCast(input) != nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> vtkFlowInput::MakeField() const
{
  if (this->Blocks.empty())
  {
    return this->Whole;
  }
  std::vector<vtkDataSet*> parts;
  for (const Block& block : this->Blocks)
  {
    parts.push_back(block.Data);
  }
  if (parts.size() == 1)
  {
    return parts[0];
  }
  return vtkFlowMerge::Merge(parts);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> vtkFlowInput::MakeSamples(vtkDataSet* field) const
{
  if (this->Blocks.empty() || vtkUnstructuredGrid::SafeDownCast(field))
  {
    return field;
  }
  return vtkFlowMerge::Merge({ field });
}
