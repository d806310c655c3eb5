// SPDX-License-Identifier: BSD-3-Clause
#include "Static/DataSetLeaves.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace interlume
{

namespace
{
const char* GetOutputType(vtkDataObject* input)
{
  if (vtkDataObjectTree::SafeDownCast(input))
  {
    return input->GetClassName();
  }
  // AMR datasets cannot contain unstructured grids.
  return vtkCompositeDataSet::SafeDownCast(input) ? "vtkMultiBlockDataSet" : "vtkUnstructuredGrid";
}
}

void DataSetLeaves::FillInput(vtkInformation* port, const char* type)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

void DataSetLeaves::FillOutput(vtkInformation* port)
{
  port->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
}

int DataSetLeaves::RequestDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  if (!input)
  {
    return 0;
  }
  const char* type = GetOutputType(input);
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    vtkDataObject* output = vtkDataObject::GetData(info);
    if (!output || std::string(output->GetClassName()) != type)
    {
      const auto made =
        vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
      info->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  }
  return 1;
}

std::vector<vtkDataSet*> DataSetLeaves::Get(vtkDataObject* input)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return { vtkDataSet::SafeDownCast(input) };
  }
  std::vector<vtkDataSet*> leaves;
  const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  at->SkipEmptyNodesOff();
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    leaves.push_back(vtkDataSet::SafeDownCast(at->GetCurrentDataObject()));
  }
  return leaves;
}

void DataSetLeaves::ForEach(vtkAlgorithm* owner, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const Extractor& extract)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  std::vector<OutputLeaves> ports;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    if (composite)
    {
      vtkCompositeDataSet::SafeDownCast(output)->CopyStructure(composite);
    }
    ports.emplace_back(output);
  }
  const std::vector<vtkDataSet*> leaves = Get(input);
  const double fraction = 1.0 / static_cast<double>(leaves.size());
  for (std::size_t i = 0; i < leaves.size() && !owner->GetAbortExecute(); ++i)
  {
    std::vector<vtkUnstructuredGrid*> grids;
    for (OutputLeaves& port : ports)
    {
      grids.push_back(port.GetNext(leaves[i] != nullptr));
    }
    if (!leaves[i])
    {
      continue;
    }
    // If the input is not composite, the executive passes the field data.
    if (composite)
    {
      for (vtkUnstructuredGrid* grid : grids)
      {
        grid->GetFieldData()->PassData(leaves[i]->GetFieldData());
      }
    }
    owner->SetProgressShiftScale(static_cast<double>(i) * fraction, fraction);
    extract(leaves[i], grids);
  }
  owner->SetProgressShiftScale(0.0, 1.0);
}

OutputLeaves::OutputLeaves(vtkDataObject* output)
  : Single(vtkUnstructuredGrid::SafeDownCast(output))
  , Composite(vtkCompositeDataSet::SafeDownCast(output))
{
  if (this->Composite)
  {
    this->At.TakeReference(this->Composite->NewIterator());
    this->At->SkipEmptyNodesOff();
    this->At->InitTraversal();
  }
}

vtkUnstructuredGrid* OutputLeaves::GetNext(bool isNeeded)
{
  if (!this->Composite)
  {
    return this->Single;
  }
  vtkUnstructuredGrid* made = nullptr;
  if (isNeeded && !this->At->IsDoneWithTraversal())
  {
    vtkNew<vtkUnstructuredGrid> grid;
    this->Composite->SetDataSet(this->At, grid);
    made = grid;
  }
  this->At->GoToNextItem();
  return made;
}

}
