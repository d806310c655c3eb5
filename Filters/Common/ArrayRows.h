// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayRows_h
#define interlume_ArrayRows_h

#include "Common/Prefetch.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cfloat>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   ArrayRows
 * @brief   read access to an array as contiguous float or double tuples, from any thread
 *
 * Contiguous arrays of float or double are used directly. Other arrays are copied, to float if
 * float represents every value exactly (types of one or two bytes, and float in other memory
 * layouts), otherwise to double.
 */
class ArrayRows
{
public:
  void Build(vtkDataArray* array)
  {
    this->Refer(array);
    if (!this->Floats && !this->Doubles)
    {
      const bool isSmall = array->GetDataTypeSize() <= 2 || array->GetDataType() == VTK_FLOAT;
      this->Refer(isSmall ? MakeCopy<float>(array) : MakeCopy<double>(array));
    }
  }

  /// Return the values as float or double. The pointer to the other type is null.
  const float* GetFloats() const { return this->Floats; }
  const double* GetDoubles() const { return this->Doubles; }

  vtkIdType GetNumber() const { return this->Array->GetNumberOfTuples(); }

  /// Returns the rounding error of values of magnitude \a size, or 0 for double.
  double GetRoundingError(double size) const { return this->Floats ? FLT_EPSILON * size : 0.0; }

  /// Copies tuple \a i of an array with N components.
  template <int N>
  void Get(vtkIdType i, double* tuple) const
  {
    if (this->Floats)
    {
      const float* from = this->Floats + N * i;
      for (int c = 0; c < N; ++c)
      {
        tuple[c] = static_cast<double>(from[c]);
      }
      return;
    }
    const double* from = this->Doubles + N * i;
    for (int c = 0; c < N; ++c)
    {
      tuple[c] = from[c];
    }
  }

  /// Prefetches tuple \a i if the compiler supports it.
  template <int N>
  void Prefetch(vtkIdType i) const
  {
    const char* from = this->Floats ? reinterpret_cast<const char*>(this->Floats + N * i)
                                    : reinterpret_cast<const char*>(this->Doubles + N * i);
    const std::size_t size = N * (this->Floats ? sizeof(float) : sizeof(double));
    interlume::Prefetch::Read(from);
    // The tuple may extend across a cache line boundary.
    interlume::Prefetch::Read(from + size - 1);
  }

private:
  // GetTuple with a caller-provided buffer is thread-safe for arrays of any layout.
  template <typename T>
  static vtkSmartPointer<vtkDataArray> MakeCopy(vtkDataArray* array)
  {
    const int components = array->GetNumberOfComponents();
    auto copy = vtkSmartPointer<vtkAOSDataArrayTemplate<T>>::New();
    copy->SetNumberOfComponents(components);
    copy->SetNumberOfTuples(array->GetNumberOfTuples());
    T* to = copy->GetPointer(0);
    vtkSMPTools::For(0, array->GetNumberOfTuples(),
      [=](vtkIdType first, vtkIdType last)
      {
        std::vector<double> tuple(components);
        for (vtkIdType i = first; i < last; ++i)
        {
          array->GetTuple(i, tuple.data());
          for (int c = 0; c < components; ++c)
          {
            to[components * i + c] = static_cast<T>(tuple[c]);
          }
        }
      });
    return copy;
  }

  void Refer(vtkDataArray* array)
  {
    this->Array = array;
    auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array);
    auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array);
    this->Floats = floats ? floats->GetPointer(0) : nullptr;
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
  }

  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  vtkSmartPointer<vtkDataArray> Array;
};

}

#endif
