// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayCheck_h
#define interlume_ArrayCheck_h

#include "Common/Error.h"

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
 * Checks arrays. An error message states the array's name, its actual shape and the required shape.
 * The message is a clause; MakeSentence turns it into a sentence.
 */
namespace ArrayCheck
{
/// Returns a description of the array for messages.
inline std::string Describe(vtkAbstractArray* array)
{
  return array->GetName() ? "array \"" + std::string(array->GetName()) + "\""
                          : "the array without a name";
}

/// Returns a count with its noun, for example "1 tuple" or "2 tuples".
inline std::string Count(vtkIdType number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

/// Returns an error unless the array has one tuple for each of \a number items. \a thing names an
/// item, such as "point".
inline Error FindLengthError(vtkAbstractArray* array, vtkIdType number, const std::string& thing)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  return tuples == number ? Error()
                          : Describe(array) + " has " + Count(tuples, "tuple") + "; " +
      std::to_string(number) + (number == 1 ? " is" : " are") + " needed, one for each " + thing;
}

/// Returns an error for the first point or cell array whose number of tuples is wrong.
inline Error FindLengthError(vtkDataSet* data)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* arrays = data->GetAttributes(association);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      if (Error error =
            FindLengthError(arrays->GetAbstractArray(i), data->GetNumberOfElements(association),
              association == vtkDataObject::POINT ? "point" : "cell"))
      {
        return error;
      }
    }
  }
  return {};
}

/// Returns an error if the array is not numeric, has a number of components other than \a
/// components (0 accepts any), or does not have one tuple for each of \a number items.
inline Error FindShapeError(
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
  return FindLengthError(array, number, thing);
}

inline Error FindPointError(vtkDataSet* data, vtkAbstractArray* array, int components)
{
  return FindShapeError(array, components, data->GetNumberOfPoints(), "point");
}

///@{
/// Return an error if the dataset has no array \a name or if that array is invalid. \a owner
/// describes the dataset in the message.
inline Error FindPointError(
  vtkDataSet* data, const std::string& owner, const std::string& name, int components)
{
  vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(name.c_str());
  return array ? FindPointError(data, array, components)
               : "the " + owner + " has no point array \"" + name + "\"";
}
inline Error FindCellError(
  vtkDataSet* data, const std::string& owner, const std::string& name, int components)
{
  vtkAbstractArray* array = data->GetCellData()->GetAbstractArray(name.c_str());
  return array ? FindShapeError(array, components, data->GetNumberOfCells(), "cell")
               : "the " + owner + " has no cell array \"" + name + "\"";
}
///@}

/// Returns an error unless \a array is a valid point or cell array.
inline Error FindError(vtkDataSet* data, vtkAbstractArray* array, int association, int components)
{
  if (association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    return FindShapeError(array, components, data->GetNumberOfCells(), "cell");
  }
  return association == vtkDataObject::FIELD_ASSOCIATION_POINTS
    ? FindPointError(data, array, components)
    : Describe(array) + " is neither a point array nor a cell array";
}

///@{
/// Capitalizes the first letter of a non-empty clause and appends a period.
inline std::string MakeSentence(std::string part)
{
  part[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(part[0])));
  return part + '.';
}
inline Error MakeSentence(const Error& part)
{
  return part ? Error(MakeSentence(part.GetMessage()), part.GetCode()) : Error();
}
///@}
}

}

#endif
