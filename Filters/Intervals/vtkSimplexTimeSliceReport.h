// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSimplexTimeSliceReport_h
#define vtkSimplexTimeSliceReport_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkSimplexTimeSliceReport
 * @brief   what an execution of vtkSimplexTimeSlice cut, over all datasets of a composite input
 *
 * @sa vtkSimplexTimeSlice
 */
struct INTERLUMEINTERVALS_EXPORT vtkSimplexTimeSliceReport
{
  /// The time of the slice.
  double Time = 0.0;
  /// Cells of the input, and tetrahedra that came of them.
  vtkIdType Simplices = 0;
  vtkIdType Tetrahedra = 0;
  /// Number of cells skipped because a time or a coordinate is NaN or infinite.
  vtkIdType NonFiniteSimplices = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
