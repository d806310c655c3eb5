// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoupPart_h
#define interlume_SoupPart_h

#include "Output/ExtractionBuffer.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace interlume
{

/**
 * The triangles of some cells, which share no points, with the coordinates and arrays of their
 * corners. Corners that are the same point may have one entry.
 */
struct SoupPart
{
  using Index = std::uint32_t;

  /// The entries of the corners, three for each triangle.
  ExtractionBuffer<Index> Corners;
  std::size_t NumberOfEntries = 0;

  ///@{
  /// The values of the entries, array after array, by their type.
  ExtractionBuffer<float> Floats;
  ExtractionBuffer<double> Doubles;
  ///@}

  /// The nearer end of each entry, where there are arrays that are not of numbers.
  ExtractionBuffer<vtkIdType> Nearer;

  template <typename T>
  ExtractionBuffer<T>& GetValues()
  {
    if constexpr (std::is_same<T, float>::value)
    {
      return this->Floats;
    }
    else
    {
      return this->Doubles;
    }
  }

  std::size_t GetBytes() const
  {
    return this->Corners.GetBytes() + this->Floats.GetBytes() + this->Doubles.GetBytes() +
      this->Nearer.GetBytes();
  }
};

}

#endif
