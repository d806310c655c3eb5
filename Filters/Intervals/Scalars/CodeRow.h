// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CodeRow_h
#define interlume_CodeRow_h

#include "Scalars/ExtractionScalars.h"

#include <cstdint>

namespace interlume
{

/**
 * @class   CodeRow
 * @brief   the codes of one row of grid points, and what is known of them
 */
struct CodeRow
{
  using Code = ExtractionValues::Code;

  vtkIdType Row = -1;
  Code Minimum = 0;
  Code Maximum = 0;
  bool HasTies = false;
  bool IsFinite = true;
  /// The range of codes: those before First are equal to the code of the first point, those after
  /// Last to that of the last point.
  std::int64_t First = 0;
  std::int64_t Last = 0;
  const Code* Codes = nullptr;

  /// Computes the codes of \a number points from \a point on, which are kept at \a codes.
  void Fill(const ExtractionScalars& scalars, vtkIdType row, vtkIdType point, vtkIdType number,
    Code* codes);
};

}

#endif
