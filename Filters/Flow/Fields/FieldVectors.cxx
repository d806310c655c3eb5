// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/FieldVectors.h"

#include "Cells/MultilinearCell.h"
#include "Common/ArrayCheck.h"
#include "Common/Blanking.h"
#include "Common/GridCells.h"
#include "Common/GridCheck.h"
#include "Fields/FlowField.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <sstream>

namespace interlume
{

namespace
{
// Returns a sentence that lists the arrays with three components.
std::string DescribeVectors(vtkDataSet* data)
{
  std::string names;
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* arrays = data->GetAttributes(association);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i);
      if (array && array->GetNumberOfComponents() == 3)
      {
        names += names.empty() ? "" : ", ";
        names +=
          array->GetName() ? "\"" + std::string(array->GetName()) + "\"" : "an unnamed array";
        names += association == vtkDataObject::CELL ? " (cells)" : "";
      }
    }
  }
  return names.empty() ? "It has no point or cell array with three components."
                       : "Its arrays with three components: " + names + ".";
}
}

void FieldVectors::FillPortInformation(vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* type :
    { "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid", "vtkUnstructuredGrid" })
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
}

Error FieldVectors::Check(const CellArrayConversion::Selection& selection, vtkInformation* request)
{
  return CheckVectors(selection, request).Then([&] { return CheckCells(selection.Data); });
}

CellArrayConversion::Selection FieldVectors::Select(vtkAlgorithm* owner,
  CellArrayConversion& conversion, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  CellArrayConversion::Selection selection{ vtkDataSet::GetData(inputs[0]) };
  Error error;
  if (selection.Data && selection.Data->GetNumberOfCells() > 0)
  {
    selection = conversion.Select(selection.Data);
    error = Check(selection, owner->GetInputArrayInformation(0));
  }
  else
  {
    // An empty input is not an error, and one piece of several may have points only.
    const int pieces = outputs->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
    if (selection.Data && selection.Data->GetNumberOfPoints() > 0 && pieces <= 1)
    {
      error = "The input has points but no cells. Pass a vtkDataSet with three-dimensional cells.";
    }
    selection.Data = nullptr;
  }
  if (error)
  {
    vtkErrorWithObjectMacro(owner, << error);
    selection.Data = nullptr;
  }
  return selection;
}

Error FieldVectors::CheckVectors(
  const CellArrayConversion::Selection& selection, vtkInformation* request)
{
  vtkDataSet* data = selection.Data;
  if (!selection.Array)
  {
    const std::string what = request->Has(vtkDataObject::FIELD_NAME())
      ? "point or cell array \"" + std::string(request->Get(vtkDataObject::FIELD_NAME())) + "\""
      : "active vectors";
    return "The field has no " + what + ". " + DescribeVectors(data);
  }
  return ArrayCheck::MakeSentence(
    ArrayCheck::FindError(data, selection.Array, selection.Association, 3)
      .Then([&] { return GridCheck::FindError(data); }));
}

Error FieldVectors::CompareNames(vtkAbstractArray* first, vtkAbstractArray* other)
{
  const auto describe = [](vtkAbstractArray* array)
  { return "\"" + std::string(array->GetName() ? array->GetName() : "") + "\""; };
  return describe(first) == describe(other)
    ? Error()
    : "The vectors are " + describe(other) + ", but " + describe(first) + " in the first block.";
}

Error FieldVectors::CheckCells(vtkDataSet* data)
{
  Blanking blanking;
  blanking.SetBlanking(data);
  bool isFlat = data->GetNumberOfCells() > 0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    // Hidden cells have type VTK_EMPTY_CELL.
    const int type = data->GetCellType(cell);
    const bool isKnown = MultilinearCell::GetShape(type) != MultilinearCell::NONE;
    isFlat = isFlat && !isKnown && type != VTK_EMPTY_CELL;
    if (!isKnown && !blanking.IsCellBlanked(cell) && !MultilinearCell::IsFlat(type))
    {
      std::ostringstream what;
      what << "Cell " << cell << " is a " << GridCells::GetClassName(type)
           << "; only tetrahedra, voxels, hexahedra, wedges and pyramids are supported.";
      return what.str();
    }
  }
  return isFlat ? ArrayCheck::MakeSentence(FlowField::GetErrorWithoutCells()) : Error();
}

}
