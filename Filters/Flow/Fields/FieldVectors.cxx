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
#include "vtkPointData.h"

#include <sstream>

namespace interlume
{

namespace
{
// Returns a sentence that lists the point arrays with three components.
std::string DescribeVectors(vtkDataSet* data)
{
  std::string names;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetPointData()->GetArray(i);
    if (array && array->GetNumberOfComponents() == 3)
    {
      names += names.empty() ? "" : ", ";
      names += array->GetName() ? "\"" + std::string(array->GetName()) + "\"" : "an unnamed array";
    }
  }
  return names.empty() ? "It has no point array with three components."
                       : "Its point arrays with three components: " + names + ".";
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

Error FieldVectors::Check(
  vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* request)
{
  return CheckVectors(data, vectors, association, request).Then([&] { return CheckCells(data); });
}

Error FieldVectors::CheckVectors(
  vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* request)
{
  using namespace ArrayCheck;
  if (!vectors)
  {
    const char* name = request->Has(vtkDataObject::FIELD_NAME())
      ? request->Get(vtkDataObject::FIELD_NAME())
      : nullptr;
    vectors = name ? data->GetCellData()->GetArray(name) : data->GetCellData()->GetVectors();
    if (!vectors)
    {
      return MakeSentence(
        name ? FindPointError(data, "field", name, 3) : "the field has no active point vectors")
        .Within("", " " + DescribeVectors(data));
    }
    association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  }
  return MakeSentence(FindAssociationError(vectors, association)
                        .Then([&] { return FindPointError(data, vectors, 3); })
                        .Then([&] { return GridCheck::FindError(data); }));
}

Error FieldVectors::CompareNames(vtkDataArray* first, vtkDataArray* other)
{
  const auto describe = [](vtkDataArray* array)
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
