// SPDX-License-Identifier: BSD-3-Clause
#include "Common/CellArrayConversion.h"

#include "Common/ArrayCheck.h"
#include "Common/GridCheck.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Access to a protected function of vtkAlgorithm.
struct ArrayAccess : public vtkAlgorithm
{
  static vtkAbstractArray* Find(vtkAlgorithm* owner, vtkDataSet* input, int& association)
  {
    vtkAbstractArray* (vtkAlgorithm::*find)(int, vtkDataObject*, int&) =
      &ArrayAccess::GetInputAbstractArrayToProcess;
    return (owner->*find)(0, input, association);
  }
};

bool IsPointOrCell(int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    association == vtkDataObject::FIELD_ASSOCIATION_CELLS ||
    association == vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
}

// Points without cells are uninitialized in the result for unstructured grids.
void ClearUnusedPoints(vtkUnstructuredGrid* grid, vtkDataArray* averages)
{
  vtkNew<vtkIdList> cells;
  for (vtkIdType point = 0; grid && point < grid->GetNumberOfPoints(); ++point)
  {
    grid->GetPointCells(point, cells);
    for (int c = 0; cells->GetNumberOfIds() == 0 && c < averages->GetNumberOfComponents(); ++c)
    {
      averages->SetComponent(point, c, 0.0);
    }
  }
}

// Lets the application process an abort. The progress of the filter itself begins afterward.
void ForwardProgress(vtkObject* caller, unsigned long, void* owner, void*)
{
  auto* algorithm = static_cast<vtkAlgorithm*>(owner);
  double progress = algorithm->GetProgress();
  algorithm->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(algorithm->GetAbortExecute());
}
}

CellArrayConversion::CellArrayConversion(
  vtkAlgorithm* owner, int components, const std::vector<std::string>& names, Cache* cache)
  : Owner(owner)
  , Components(components)
  , Names(names)
  , External(cache)
{
}

CellArrayConversion::~CellArrayConversion() = default;

CellArrayConversion::Selection CellArrayConversion::Select(vtkDataSet* input)
{
  Selection selection{ input };
  selection.Array = FindRequested(this->Owner, input, selection.Association);
  std::vector<vtkDataArray*> sources;
  const auto add = [&](vtkAbstractArray* array, int components)
  {
    if (array &&
      !ArrayCheck::FindShapeError(array, components, input->GetNumberOfCells(), "cell") &&
      std::find(sources.begin(), sources.end(), array) == sources.end())
    {
      sources.push_back(vtkDataArray::SafeDownCast(array));
    }
  };
  if (selection.Association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    add(selection.Array, this->Components);
  }
  const bool isConverted = !sources.empty();
  for (const std::string& name : this->Names)
  {
    const Selection named = FindByName(input, name);
    add(named.Association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? named.Array : nullptr, 1);
  }
  // An invalid grid cannot be converted. The filter's own check reports the error.
  if (sources.empty() || GridCheck::FindError(input))
  {
    return selection;
  }
  const Converted& converted = this->Convert(input, sources);
  selection.Data = converted.Data;
  if (isConverted)
  {
    this->Activate(converted);
    selection.Array = converted.Arrays[0];
    selection.Association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  return selection;
}

vtkAbstractArray* CellArrayConversion::FindRequested(
  vtkAlgorithm* owner, vtkDataSet* input, int& association)
{
  vtkAbstractArray* array = ArrayAccess::Find(owner, input, association);
  vtkInformation* request = owner->GetInputArrayInformation(0);
  if (array || !IsPointOrCell(GetAssociation(request)))
  {
    return array;
  }
  association = GetAssociation(request) == vtkDataObject::FIELD_ASSOCIATION_CELLS
    ? vtkDataObject::FIELD_ASSOCIATION_POINTS
    : vtkDataObject::FIELD_ASSOCIATION_CELLS;
  return Find(request, input->GetAttributes(association));
}

CellArrayConversion::Selection CellArrayConversion::FindByName(
  vtkDataSet* data, const std::string& name)
{
  vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(name.c_str());
  return array ? Selection{ data, array }
               : Selection{ data, data->GetCellData()->GetAbstractArray(name.c_str()),
                   vtkDataObject::FIELD_ASSOCIATION_CELLS };
}

vtkAbstractArray* CellArrayConversion::Find(
  vtkInformation* request, vtkDataSetAttributes* attributes)
{
  return request->Has(vtkDataObject::FIELD_NAME())
    ? attributes->GetAbstractArray(request->Get(vtkDataObject::FIELD_NAME()))
    : attributes->GetAbstractAttribute(request->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
}

void CellArrayConversion::RequestGhostCells(
  vtkAlgorithm* owner, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  if (outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1 &&
    GetAssociation(owner->GetInputArrayInformation(0)) != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      input->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) + 1);
  }
}

int CellArrayConversion::GetAssociation(vtkInformation* request)
{
  return request->Get(vtkDataObject::FIELD_ASSOCIATION());
}

const CellArrayConversion::Converted& CellArrayConversion::Convert(
  vtkDataSet* input, const std::vector<vtkDataArray*>& sources)
{
  Converted& result = (this->External ? *this->External : this->OwnResults)[input];
  result.IsUsed = true;
  if (result.InputTime != input->GetMTime() || result.Sources != sources)
  {
    result = Converted();
    result.IsUsed = true;
    result.Sources = sources;
    result.Data.TakeReference(input->NewInstance());
    result.Data->ShallowCopy(input);
    vtkPointData* points = result.Data->GetPointData();
    for (vtkDataArray* source : sources)
    {
      const vtkSmartPointer<vtkDataArray> averages = this->Average(input, source);
      points->AddArray(averages);
      result.Arrays.push_back(averages);
    }
    // The result of an aborted conversion is used only until the filter stops.
    result.InputTime = this->Owner->GetAbortExecute() ? 0 : input->GetMTime();
  }
  for (vtkDataArray* source : sources)
  {
    const std::string name = source->GetName() ? source->GetName() : "";
    std::vector<std::string>& names = this->ConvertedNames;
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  }
  return result;
}

// If the cell array was selected as an active attribute, makes the first converted array this
// attribute of the points, so that it is found there.
void CellArrayConversion::Activate(const Converted& converted) const
{
  vtkInformation* request = this->Owner->GetInputArrayInformation(0);
  vtkPointData* points = converted.Data->GetPointData();
  for (int i = 0; !request->Has(vtkDataObject::FIELD_NAME()) && i < points->GetNumberOfArrays();
       ++i)
  {
    const int type = request->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
    if (points->GetAbstractArray(i) == converted.Arrays[0] &&
      points->GetAbstractAttribute(type) != converted.Arrays[0])
    {
      points->SetActiveAttribute(i, type);
    }
  }
}

vtkSmartPointer<vtkDataArray> CellArrayConversion::Average(vtkDataSet* input, vtkDataArray* source)
{
  this->Owner->SetProgressText(
    ("Averaging cell " + ArrayCheck::Describe(source) + " at the points").c_str());
  // A grid with the same blanking and a single cell array, which has a name in any case.
  const auto grid = vtkSmartPointer<vtkDataSet>::Take(input->NewInstance());
  grid->CopyStructure(input);
  const char* const name = "values";
  // VTK's filter does not average ids and bits, and reads other memory layouts than tuple by tuple
  // incorrectly.
  const int type = source->GetDataType();
  const bool isNumber = type != VTK_ID_TYPE && type != VTK_BIT;
  const auto values = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(isNumber ? type : VTK_DOUBLE));
  isNumber && source->HasStandardMemoryLayout() ? values->ShallowCopy(source)
                                                : values->DeepCopy(source);
  values->SetName(name);
  grid->GetCellData()->AddArray(values);
  vtkNew<vtkCellDataToPointData> filter;
  filter->SetInputData(grid);
  filter->ProcessAllArraysOff();
  filter->AddCellDataArray(name);
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(this->Owner);
  progress->SetCallback(ForwardProgress);
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  if (vtkUnstructuredGrid::SafeDownCast(grid))
  {
    // With several threads, the order of the cells at a point varies, and so does the rounding of
    // the averages.
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(std::string("Sequential")), [&filter] { filter->Update(); });
  }
  else
  {
    filter->Update();
  }
  vtkSmartPointer<vtkDataArray> averages = filter->GetOutput()->GetPointData()->GetArray(name);
  if (averages && averages->GetNumberOfTuples() == input->GetNumberOfPoints())
  {
    ClearUnusedPoints(vtkUnstructuredGrid::SafeDownCast(grid), averages);
  }
  else
  {
    // There are no cells, or the user aborted.
    averages.TakeReference(values->NewInstance());
    averages->SetNumberOfComponents(source->GetNumberOfComponents());
    averages->SetNumberOfTuples(input->GetNumberOfPoints());
    averages->Fill(0.0);
  }
  averages->SetName(source->GetName());
  return averages;
}

}
