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
 * All values are 0 before the first execution and after an error or abort. They do not depend on
 * the number of threads.
 */
struct SourceReport
{
  /// Number of output points. The output may cover only a part of the whole extent.
  vtkIdType Points = 0;
  /// Number of positions at which the field was evaluated. It exceeds the number of points if
  /// values are means of subsamples, or if colors depend on points outside the requested extent.
  vtkIdType Evaluations = 0;
  /// Size of the point arrays in bytes, including point coordinates of grids.
  vtkIdType Bytes = 0;
  /// Time at which the field was evaluated, or 0 for steady fields.
  double Time = 0.0;

  /// Returns the report for a completed \a output.
  static SourceReport Of(vtkDataSet* output, vtkIdType evaluations, double time = 0.0);

  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
