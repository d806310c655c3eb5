// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayCheck_h
#define interlume_ArrayCheck_h

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <cctype>
#include <string>

namespace interlume
{

/**
 * Says what is wrong with an array, everywhere in the same words: which array it is, what it has,
 * and what is needed. Each function returns a part of a sentence, or nothing where all is well;
 * MakeSentence makes it a message of its own.
 */
namespace ArrayCheck
{
/// Names an array.
inline std::string Describe(vtkAbstractArray* array)
{
  return array->GetName() ? "array \"" + std::string(array->GetName()) + "\""
                          : "the array without a name";
}

/// Counts things, as "1 tuple" or "2 tuples".
inline std::string Count(vtkIdType number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

/// Returns an error message if an array has not one tuple for each of \a number things, such as
/// points.
inline std::string FindLengthFault(
  vtkAbstractArray* array, vtkIdType number, const std::string& thing)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  return tuples == number ? std::string()
                          : Describe(array) + " has " + Count(tuples, "tuple") + "; " +
      std::to_string(number) + (number == 1 ? " is" : " are") + " needed, one for each " + thing;
}

/// Returns the same for the first such array of points or cells.
inline std::string FindLengthFault(vtkDataSet* data)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* arrays = data->GetAttributes(association);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      const std::string fault =
        FindLengthFault(arrays->GetAbstractArray(i), data->GetNumberOfElements(association),
          association == vtkDataObject::POINT ? "point" : "cell");
      if (!fault.empty())
      {
        return fault;
      }
    }
  }
  return {};
}

/// Returns why an array cannot be read: it has to have numbers, in so many components, 0 for any
/// number of them, and one tuple for each of \a number things, such as points.
inline std::string FindShapeFault(
  vtkAbstractArray* array, int components, vtkIdType number, const std::string& thing)
{
  if (!vtkDataArray::SafeDownCast(array))
  {
    return Describe(array) + " is a " + array->GetClassName() + "; numbers are needed";
  }
  if (components > 0 && array->GetNumberOfComponents() != components)
  {
    return Describe(array) + " has " + Count(array->GetNumberOfComponents(), "component") + "; " +
      std::to_string(components) + (components == 1 ? " is needed" : " are needed");
  }
  return FindLengthFault(array, number, thing);
}

inline std::string FindPointFault(vtkDataSet* data, vtkAbstractArray* array, int components)
{
  return FindShapeFault(array, components, data->GetNumberOfPoints(), "point");
}

///@{
/// Return why a dataset has no such array of that name. \a owner names the dataset.
inline std::string FindPointFault(
  vtkDataSet* data, const std::string& owner, const std::string& name, int components)
{
  vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(name.c_str());
  return array ? FindPointFault(data, array, components)
               : "the " + owner + " has no point array \"" + name + "\"";
}
inline std::string FindCellFault(
  vtkDataSet* data, const std::string& owner, const std::string& name, int components)
{
  vtkAbstractArray* array = data->GetCellData()->GetAbstractArray(name.c_str());
  return array ? FindShapeFault(array, components, data->GetNumberOfCells(), "cell")
               : "the " + owner + " has no cell array \"" + name + "\"";
}
///@}

/// Returns why an array of an association, one of vtkDataObject's, has no values at points.
inline std::string FindPlaceFault(vtkAbstractArray* array, int association)
{
  if (association == vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return {};
  }
  return Describe(array) + " is not a point array" +
    (association == vtkDataObject::FIELD_ASSOCIATION_CELLS
        ? ": it is in the cells. Apply vtkCellDataToPointData (Cell Data to Point Data) first"
        : "; values are needed at the points");
}

inline std::string MakeSentence(std::string part)
{
  if (!part.empty())
  {
    part[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(part[0])));
    part += '.';
  }
  return part;
}
}

}

#endif
