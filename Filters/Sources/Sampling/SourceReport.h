// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SourceReport_h
#define interlume_SourceReport_h

#include "vtkType.h"

class vtkDataSet;
class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   SourceReport
 * @brief   report of a source of images or grids
 *
 * Every number is 0 before the first execution and after one that failed or was aborted, and is
 * the same for any number of threads.
 */
struct SourceReport
{
  /// The number of points of the output, which may be a part of the whole extent.
  vtkIdType Points = 0;
  /// The number of positions at which the field was evaluated. These are more than the points if a
  /// value is the mean of several, or if colors need the points around a part.
  vtkIdType Evaluations = 0;
  /// The bytes of the output's point arrays and, for grids, of its coordinates.
  vtkIdType Bytes = 0;
  /// The time for which the field was evaluated, or 0 for fields that do not change.
  double Time = 0.0;

  /// Returns the report of an output that is made.
  static SourceReport Of(vtkDataSet* output, vtkIdType evaluations, double time = 0.0);

  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
