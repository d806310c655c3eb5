// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSourceReport_h
#define vtkSourceReport_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

class vtkDataSet;

/**
 * @class   vtkSourceReport
 * @brief   what the last execution of a source of images or grids took
 *
 * This is a plain value object. Every number is 0 before the first execution and after one that
 * failed or was aborted, and is the same for any number of threads.
 *
 * @sa vtkBoundedImageSource vtkTemporalGridSource
 */
struct INTERLUMESOURCES_EXPORT vtkSourceReport
{
  /// The number of points of the output, which may be a part of the whole extent.
  vtkIdType Points = 0;
  /// The number of positions at which the field was evaluated. These are more than the points where
  /// a value is the mean of several, and where colours need the points around a part.
  vtkIdType Evaluations = 0;
  /// The bytes of the output's point arrays and, for grids, of its coordinates.
  vtkIdType Bytes = 0;
  /// The time that the field was evaluated for; 0 for fields that do not change.
  double Time = 0.0;

  /// Returns the report of an output that is made.
  static vtkSourceReport Of(vtkDataSet* output, vtkIdType evaluations, double time = 0.0);

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
