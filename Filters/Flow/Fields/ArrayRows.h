// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayRows_h
#define interlume_ArrayRows_h

#include "Common/Prefetch.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cfloat>
#include <cstddef>

namespace interlume
{

/**
 * @class   ArrayRows
 * @brief   the numbers of an array as floats or doubles in rows, read by any thread
 *
 * Arrays of floats and doubles that lie in rows are used as they are; others are copied, to floats
 * where those hold every number exactly (types of one or two bytes, floats in columns), else to
 * doubles.
 */
class ArrayRows
{
public:
  void Build(vtkDataArray* array);

  vtkIdType GetNumber() const { return this->Array->GetNumberOfTuples(); }

  /// Returns the error that rounding may have made in numbers as large as \a size; 0 for doubles.
  double GetRounding(double size) const { return this->Floats ? FLT_EPSILON * size : 0.0; }

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

  /// Prefetches tuple \a i, where the compiler knows how.
  template <int N>
  void Prefetch(vtkIdType i) const
  {
    const char* from = this->Floats ? reinterpret_cast<const char*>(this->Floats + N * i)
                                    : reinterpret_cast<const char*>(this->Doubles + N * i);
    const std::size_t size = N * (this->Floats ? sizeof(float) : sizeof(double));
    interlume::Prefetch::Read(from);
    // The tuple may lie across the end of a cache line.
    interlume::Prefetch::Read(from + size - 1);
  }

private:
  void Refer(vtkDataArray* array);

  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  vtkSmartPointer<vtkDataArray> Array;
};

}

#endif
