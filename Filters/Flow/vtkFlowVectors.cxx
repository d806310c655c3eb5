#include "vtkFlowVectors.h"

#include "vtkAlgorithm.h"
#include "vtkBlanking.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkGridCells.h"
#include "vtkInformation.h"
#include "vtkMultilinearCell.h"
#include "vtkPointData.h"

#include <sstream>

namespace
{
// The point arrays that could be taken.
std::string DescribeVectors(vtkDataSet* data)
{
  std::string names;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetPointData()->GetArray(i);
    if (array && array->GetNumberOfComponents() == 3 && array->GetName())
    {
      names += std::string(names.empty() ? "\"" : ", \"") + array->GetName() + "\"";
    }
  }
  return names.empty() ? "It has no point array of three components."
                       : "Its point arrays of three components: " + names + ".";
}
}

void vtkFlowVectors::FillPortInformation(vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* type :
    { "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid", "vtkUnstructuredGrid" })
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
}

std::string vtkFlowVectors::Check(
  vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* asked)
{
  const std::string wrong = CheckVectors(data, vectors, association, asked);
  return wrong.empty() ? CheckCells(data) : wrong;
}

std::string vtkFlowVectors::CheckVectors(
  vtkDataSet* data, vtkDataArray* vectors, int association, vtkInformation* asked)
{
  std::ostringstream what;
  if (!vectors)
  {
    const char* name =
      asked->Has(vtkDataObject::FIELD_NAME()) ? asked->Get(vtkDataObject::FIELD_NAME()) : nullptr;
    what << "The field has no "
         << (name ? "array of numbers \"" + std::string(name) + "\""
                  : std::string("active point vectors"))
         << ". " << DescribeVectors(data);
  }
  else
  {
    const std::string name = vectors->GetName() ? vectors->GetName() : "(unnamed)";
    if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
    {
      what << "Array \"" << name << "\" is not a point array; vectors are needed at the points.";
    }
    else if (vectors->GetNumberOfComponents() != 3)
    {
      what << "Array \"" << name << "\" has " << vectors->GetNumberOfComponents()
           << " components; three are needed.";
    }
    else if (vectors->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
      what << "Array \"" << name << "\" has " << vectors->GetNumberOfTuples() << " vectors for "
           << data->GetNumberOfPoints() << " points.";
    }
  }
  return what.str();
}

std::string vtkFlowVectors::CompareArrays(vtkDataArray* first, vtkDataArray* other)
{
  const auto describe = [](vtkDataArray* array)
  {
    return "\"" + std::string(array->GetName() ? array->GetName() : "") + "\" of " +
      array->GetDataTypeAsString();
  };
  return describe(first) == describe(other)
    ? std::string()
    : "The vectors are " + describe(other) + ", in the first block " + describe(first) + ".";
}

std::string vtkFlowVectors::CheckCells(vtkDataSet* data)
{
  vtkBlanking blanking;
  blanking.SetBlanking(data);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    // Datasets give hidden cells the empty type.
    const int type = data->GetCellType(cell);
    if (vtkMultilinearCell::GetShape(type) == vtkMultilinearCell::NONE && type != VTK_EMPTY_CELL &&
      !blanking.IsCellBlanked(cell))
    {
      std::ostringstream what;
      what << "Cell " << cell << " is a " << vtkGridCells::GetClassName(type)
           << "; tetrahedra, voxels, hexahedra, wedges and pyramids are needed.";
      return what.str();
    }
  }
  return std::string();
}
