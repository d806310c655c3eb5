// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionDispatch_h
#define interlume_ExtractionDispatch_h

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayMeta.h"
#include "vtkSmartPointer.h"

namespace interlume
{

/**
 * @class   ExtractionDispatch
 * @brief   calls a function with a typed pointer to the values of an array
 *
 * The array must be contiguous in memory. MakeContiguous() copies other arrays.
 */
class ExtractionDispatch
{
public:
  template <typename Function>
  static bool Execute(vtkDataArray* scalars, Function&& function)
  {
    bool result = false;
    vtkArrayDispatch::Dispatch::Execute(scalars,
      [&](auto* array)
      {
        using T = vtk::GetAPIType<std::decay_t<decltype(*array)>>;
        if (auto* contiguous = vtkAOSDataArrayTemplate<T>::FastDownCast(array))
        {
          result = function(static_cast<const T*>(contiguous->GetPointer(0)));
        }
      });
    return result;
  }

  /// Returns whether Execute() can read the array directly.
  static bool IsSupported(vtkDataArray* scalars)
  {
    return Execute(scalars, [](const auto*) { return true; });
  }

  /// Returns the array itself if it is contiguous, otherwise a copy.
  static vtkSmartPointer<vtkDataArray> MakeContiguous(vtkDataArray* array)
  {
    if (IsSupported(array))
    {
      return array;
    }
    vtkSmartPointer<vtkDataArray> copy = MakeCopy(array, array->GetDataType());
    return IsSupported(copy) ? copy : MakeCopy(array, VTK_DOUBLE);
  }

  /// Returns a copy converted to a VTK data type.
  static vtkSmartPointer<vtkDataArray> MakeCopy(vtkDataArray* array, int dataType)
  {
    vtkSmartPointer<vtkDataArray> copy;
    copy.TakeReference(vtkDataArray::CreateDataArray(dataType));
    copy->DeepCopy(array);
    return copy;
  }
};

}

#endif
