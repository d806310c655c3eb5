// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CodeRow_h
#define interlume_CodeRow_h

#include "Scalars/ExtractionScalars.h"

#include <cstdint>

namespace interlume
{

/**
 * @class   CodeRow
 * @brief   codes of one row of grid points, with their minimum and maximum and the range in which
 *          they vary
 */
struct CodeRow
{
  using Code = ExtractionValues::Code;

  vtkIdType Row = -1;
  Code Minimum = 0;
  Code Maximum = 0;
  bool HasTies = false;
  bool IsFinite = true;
  /// Range of varying codes: all codes before First equal the first code of the row, and all codes
  /// after Last equal the last code.
  std::int64_t First = 0;
  std::int64_t Last = 0;
  const Code* Codes = nullptr;

  /// Computes the codes of \a number points, starting at \a point, into \a codes.
  void Fill(const ExtractionScalars& scalars, vtkIdType row, vtkIdType point, vtkIdType number,
    Code* codes);
};

}

#endif
